// What of a file grows with the number of particles: datasets of rows, cut into chunks each of
// which is compressed by itself. Chunks are made here, by any thread or rank, and HDF5 only puts
// them in their places.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace meniscus {

/// Rows of numbers in the type in which they are stored.
struct LargeDataset {
    std::string path; ///< below /VTKHDF, as "Points"
    std::uint64_t rows = 0;
    int components = 1;
    std::size_t number_size = 0; ///< bytes
    std::uint64_t at_once = 0;   ///< rows that are fetched at a time, about
    /// Rows from `first` on, in memory that lives until the next call.
    std::function<const void*(std::uint64_t first, std::uint64_t count)> fetch;

    [[nodiscard]] std::size_t row_bytes() const {
        return number_size * static_cast<std::size_t>(components);
    }
};

/// Rows of a chunk, the last of which may have less; 0 where a dataset is too small to gain from
/// compression, and is stored as it is.
std::uint64_t rows_a_chunk(const LargeDataset& dataset);

/// Number of chunks.
std::uint64_t chunk_count(const LargeDataset& dataset);

/// Calls use(chunk, packed) with chunks from `first` up to `end` as the file has them. Throws what
/// fetching throws and std::bad_alloc.
void for_chunks(const LargeDataset& dataset, std::uint64_t first, std::uint64_t end,
                const std::function<void(std::uint64_t chunk, const std::string& packed)>& use);

} // namespace meniscus
