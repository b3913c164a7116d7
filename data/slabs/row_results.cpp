#include "row_results.hpp"

#include <meniscus/data/formats/vtkhdf.hpp>

#include <algorithm>
#include <cstring>

namespace meniscus {
namespace {

constexpr std::uint64_t rows_a_block = 1 << 14;
constexpr std::size_t bytes_at_once = 1 << 19;

std::uint64_t row_of(const char* record) {
    std::uint64_t row = 0;
    std::memcpy(&row, record, sizeof row);
    return row;
}

} // namespace

RowResults::RowResults(std::uint64_t rows, std::size_t numbers,
                       const std::filesystem::path& scratch, Ranks& ranks)
    : rows(rows), numbers(numbers), ranks(ranks),
      own_first(first_of_share(rows, ranks.rank(), ranks.size())),
      own_end(first_of_share(rows, ranks.rank() + 1, ranks.size())),
      kept_end(rows_end_of(ranks.rank())), blocks(scratch),
      in_block((kept_end - own_first + rows_a_block - 1) / rows_a_block), outgoing(scratch) {
    for (std::size_t column = 0; column <= numbers; ++column)
        columns.emplace_back(scratch);
}

std::uint64_t RowResults::rows_end_of(int rank) const {
    return std::min(rows, end_of_chunks(first_of_share(rows, rank + 1, ranks.size())));
}

/// Calls visit(rank) with the ranks that have a row: whose share it is in, and those before it
/// whose chunks reach there.
template <class Visit>
void RowResults::for_ranks_of(std::uint64_t row, const Visit& visit) const {
    const auto size = static_cast<std::uint64_t>(ranks.size());
    int rank = static_cast<int>(std::min(row / std::max<std::uint64_t>(rows / size, 1), size - 1));
    while (row < first_of_share(rows, rank, ranks.size()))
        --rank;
    while (row >= first_of_share(rows, rank + 1, ranks.size()))
        ++rank;
    for (; rank >= 0 && row < rows_end_of(rank); --rank)
        visit(rank);
}

void RowResults::add(std::uint64_t particle, const double* found) {
    const auto append = [&](std::string& records) {
        records.append(reinterpret_cast<const char*>(&particle), sizeof particle);
        records.append(reinterpret_cast<const char*>(found), 8 * numbers);
    };
    bool is_left = false;
    for_ranks_of(particle, [&](int rank) {
        is_left = is_left || rank != ranks.rank();
        if (rank == ranks.rank())
            append(waiting);
    });
    if (is_left)
        append(leaving);
    if (waiting.size() + leaving.size() >= bytes_at_once)
        flush();
}

void RowResults::flush() {
    store(waiting);
    waiting.clear();
    if (ranks.size() > 1)
        outgoing.append(leaving.data(), leaving.size());
    leaving.clear();
}

/// Records of rows that follow on each other go to their block together.
void RowResults::store(std::string_view records) {
    const std::size_t record = record_bytes();
    const auto block_at = [&](std::size_t at) {
        return (row_of(records.data() + at) - own_first) / rows_a_block;
    };
    for (std::size_t at = 0; at < records.size();) {
        const std::uint64_t block = block_at(at);
        std::size_t end = at + record;
        while (end < records.size() && block_at(end) == block)
            end += record;
        blocks.write((block * rows_a_block + in_block[block]) * record, records.data() + at,
                     end - at);
        in_block[block] += (end - at) / record;
        at = end;
    }
}

void RowResults::settle() {
    do_together(ranks, [&] { flush(); });
    if (ranks.size() > 1)
        exchange();
    do_together(ranks, [&] { make_columns(); });
}

void RowResults::exchange() {
    const std::size_t record = record_bytes();
    const std::uint64_t most = std::max(bytes_at_once / record, std::size_t{1}) * record;
    std::vector<double> longest = {static_cast<double>(outgoing.size())};
    ranks.max(longest);
    const auto size = static_cast<std::uint64_t>(ranks.size());
    for (std::uint64_t place = 0; static_cast<double>(place) < longest[0]; place += most) {
        std::vector<std::string> for_rank(size);
        do_together(ranks, [&] {
            std::string some(std::min(most, outgoing.size() - std::min(place, outgoing.size())),
                             '\0');
            outgoing.read(place, some.data(), some.size());
            for (std::size_t at = 0; at < some.size(); at += record) {
                const std::uint64_t row = row_of(some.data() + at);
                for_ranks_of(row, [&](int rank) {
                    if (rank != ranks.rank())
                        for_rank[static_cast<std::size_t>(rank)].append(some, at, record);
                });
            }
        });
        for (const std::string& bytes : for_rank)
            sent += bytes.size();
        const auto received = ranks.exchange(std::move(for_rank));
        do_together(ranks, [&] {
            for (const std::string& records : received)
                store(records);
        });
    }
}

void RowResults::make_columns() {
    const std::size_t record = record_bytes();
    std::string records;
    for (std::uint64_t block = 0; block < in_block.size(); ++block) {
        const std::uint64_t first = own_first + block * rows_a_block;
        const std::uint64_t count = std::min(rows_a_block, kept_end - first);
        records.resize(in_block[block] * record);
        blocks.read(block * rows_a_block * record, records.data(), records.size());
        std::vector<std::vector<double>> values(numbers, std::vector<double>(count));
        std::vector<std::uint8_t> added(count);
        for (std::size_t at = 0; at < records.size(); at += record) {
            const std::uint64_t row = row_of(records.data() + at) - first;
            added[row] = 1;
            for (std::size_t n = 0; n < numbers; ++n)
                std::memcpy(&values[n][row], records.data() + at + 8 * (1 + n), 8);
        }
        for (std::size_t n = 0; n < numbers; ++n)
            columns[n].append(values[n].data(), 8 * count);
        columns[numbers].append(added.data(), count);
    }
    blocks.clear();
    outgoing.clear();
}

std::vector<double> RowResults::column(std::size_t number, std::uint64_t first,
                                       std::uint64_t count) const {
    std::vector<double> values(count);
    columns[number].read(8 * (first - own_first), values.data(), 8 * count);
    return values;
}

std::vector<std::uint8_t> RowResults::was_added(std::uint64_t first, std::uint64_t count) const {
    std::vector<std::uint8_t> added(count);
    columns[numbers].read(first - own_first, added.data(), count);
    return added;
}

} // namespace meniscus
