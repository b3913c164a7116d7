// How much memory this process takes, as the system counts it.
#pragma once

#include <cstdint>

namespace meniscus {

/// Bytes that this process has in memory now, and the most that it ever had; 0 where the system
/// does not say.
std::uint64_t resident_memory();
std::uint64_t peak_memory();

} // namespace meniscus
