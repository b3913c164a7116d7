// What a process has needed of memory.
#pragma once

#include <sys/resource.h>

namespace meniscus {

/// The most that this process has held at once.
inline double peak_bytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) * 1024;
}

} // namespace meniscus
