// The one fact about deflate (gzip, and HDF5's usual compression) that bounds what a file of a
// given size can hold. For the sources of data/ only.
#pragma once

#include <cstdint>

namespace meniscus {

/// Nothing gets smaller than 1/1032 of its size: 258 bytes for a code of two bits.
inline constexpr std::uint64_t max_compression = 1032;

} // namespace meniscus
