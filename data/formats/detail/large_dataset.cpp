#include "large_dataset.hpp"

#include <meniscus/data/hdf5/packed_chunk.hpp>

#include <algorithm>

namespace meniscus {
namespace {

// A megabyte at most: HDF5's cache of chunks holds one then.
constexpr std::uint64_t max_chunk_bytes = std::uint64_t{1} << 20;
constexpr std::uint64_t min_compressed = 1024;

} // namespace

std::uint64_t rows_a_chunk(const LargeDataset& dataset) {
    const std::uint64_t row = dataset.row_bytes();
    if (dataset.rows * row < min_compressed)
        return 0;
    return std::min(dataset.rows, std::max<std::uint64_t>(max_chunk_bytes / row, 1));
}

std::uint64_t chunk_count(const LargeDataset& dataset) {
    const std::uint64_t rows = rows_a_chunk(dataset);
    return rows == 0 ? 0 : (dataset.rows + rows - 1) / rows;
}

void for_chunks(const LargeDataset& dataset, std::uint64_t first, std::uint64_t end,
                const std::function<void(std::uint64_t, const std::string&)>& use) {
    const std::uint64_t rows = rows_a_chunk(dataset);
    const std::uint64_t row = dataset.row_bytes();
    const std::uint64_t at_once = std::max<std::uint64_t>(dataset.at_once / rows, 1);
    for (std::uint64_t next = first; next < end; next += at_once) {
        const std::uint64_t last = std::min(next + at_once, end);
        const std::uint64_t from = next * rows;
        const std::uint64_t to = std::min(last * rows, dataset.rows);
        const auto* fetched = static_cast<const char*>(dataset.fetch(from, to - from));
        for (std::uint64_t chunk = next; chunk < last; ++chunk) {
            const std::uint64_t begin = chunk * rows;
            const std::uint64_t bytes = (std::min(begin + rows, dataset.rows) - begin) * row;
            use(chunk, packed_chunk(fetched + (begin - from) * row, bytes, dataset.number_size,
                                    rows * row));
        }
    }
}

} // namespace meniscus
