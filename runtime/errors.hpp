// How the runtime refuses what it cannot work with: by an exception or, in a program built without
// them (-fno-exceptions), by ending it with the same message.
#pragma once

#include "simd/instruction_set.hpp"

#if defined(__cpp_exceptions)
#include <stdexcept>
#else
#include <cstdio>
#include <cstdlib>
#endif

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// Throws std::invalid_argument with the message; without exceptions, prints it on standard error
/// and calls std::abort().
[[noreturn]] inline void refuse(const char* message) {
#if defined(__cpp_exceptions)
    throw std::invalid_argument(message);
#else
    std::fprintf(stderr, "meniscus: %s\n", message);
    std::abort();
#endif
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
