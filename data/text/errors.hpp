// Errors for the person at the terminal. Every message is one line that names the file and the
// particle, array or option at fault, says what was expected, and what to do about it. Two types,
// because a caller treats them differently: what the user gave is wrong (mend the input), or the
// machine failed while the input was fine (disk full, out of memory: try again elsewhere).
#pragma once

#include <stdexcept>

namespace meniscus {

/// The input or an option is wrong. The command line exits with status 2.
class InputError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The input is fine but the work could not be finished. The command line exits with status 3.
class FailureError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

} // namespace meniscus
