// Errors for the person at the terminal. Every message is one line that names the file and the
// particle, array or option at fault, says what was expected, and what to do about it; whatever
// bytes it quotes, it can be printed (printable.hpp). Two types, because a caller treats them
// differently: what the user gave is wrong (mend the input), or the machine failed while the input
// was fine (disk full, out of memory: try again elsewhere).
#pragma once

#include "printable.hpp"

#include <stdexcept>
#include <string>

namespace meniscus {

/// The input or an option is wrong. The command line exits with status 2.
class InputError : public std::runtime_error {
public:
    explicit InputError(const std::string& message) : std::runtime_error(printable(message)) {}
};

/// The input is fine but the work could not be finished. The command line exits with status 3.
class FailureError : public std::runtime_error {
public:
    explicit FailureError(const std::string& message) : std::runtime_error(printable(message)) {}
};

} // namespace meniscus
