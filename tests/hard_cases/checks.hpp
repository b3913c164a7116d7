// What every method makes of every hard case. A check runs one method on one case and says what it
// found, how far off the largest number was, and whether that is what was expected.
#pragma once

#include "cases.hpp"

#include <string>
#include <vector>

namespace meniscus::test {

struct Check {
    std::string hard_case;
    std::string method;
    std::string expected; ///< and why
    std::string result;
    double max_error = 0; ///< of lambda, where the method has one; else of what `result` names
    bool passed = false;
};

/// All methods on one case, positions in Real (float or double).
template <class Real>
std::vector<Check> check_case(const HardCase& hard_case);

} // namespace meniscus::test
