// Errors for the person at the terminal. Every message is one line that names the file and the
// particle, array or option at fault, says what was expected, and what to do about it; whatever
// bytes it quotes, it can be printed (printable.hpp). Two types, because a caller treats them
// differently: what the user gave is wrong (mend the input), or the machine failed while the input
// was fine (disk full, out of memory: try again elsewhere).
#pragma once

#include "printable.hpp"

#include <cerrno>
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

/// Whether an error of the system (errno) is a failure of the machine; any other that keeps a file
/// from being opened or created is the path's.
inline bool is_failure_of_machine(int error) {
    for (const int failure : {ENOSPC, EDQUOT, EIO, ENFILE, EMFILE, ENOMEM, EFBIG})
        if (error == failure)
            return true;
    return false;
}

/// Throws the error that fits one of the system.
[[noreturn]] inline void fail_for(int error, const std::string& message) {
    if (is_failure_of_machine(error))
        throw FailureError(message);
    throw InputError(message);
}

} // namespace meniscus
