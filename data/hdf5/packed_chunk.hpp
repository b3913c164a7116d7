// A chunk of a dataset as HDF5's own filters store it: bytes of equal place in their numbers side
// by side (shuffle), then deflated. Made without the library, in which one thread works at a time,
// so that other threads and processes make chunks while one of them writes. For the sources of
// data/ only.
#pragma once

#include <cstddef>
#include <string>

namespace meniscus {

/// The level of all our files. Higher ones cost more time than they save space on coordinates that
/// are all but random.
inline constexpr int compression_level = 1;

/// Packs `bytes` bytes of numbers of that size as a chunk of `chunk_bytes`, which they fill or, at
/// the end of a dataset, zeros fill up. Throws std::bad_alloc where memory is wanting.
std::string packed_chunk(const void* numbers, std::size_t bytes, std::size_t number_size,
                         std::size_t chunk_bytes);

} // namespace meniscus
