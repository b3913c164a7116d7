// What was found for particles, slab by slab, in the order of the file. Each rank gets that of its
// own share of the rows (first_of_share, data/ranks/ranks.hpp), and of some rows beyond, so that it
// can make its chunks of the output. In scratch files: records come in any order, are kept by
// blocks of rows, and become columns in the end.
#pragma once

#include <meniscus/data/ranks/ranks.hpp>
#include <meniscus/data/text/scratch_file.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace meniscus {

class RowResults {
public:
    /// For a state of so many rows and so many numbers a particle. Throws as ScratchFile does, and
    /// so does what follows.
    RowResults(std::uint64_t rows, std::size_t numbers, const std::filesystem::path& scratch,
               Ranks& ranks);

    /// Adds what was found for a particle, by its number in the state: at once where it is in this
    /// rank's rows, else for settle().
    void add(std::uint64_t particle, const double* numbers);

    /// Sends what others need, and puts all in order. Collective, once, after all add(); throws on
    /// all ranks alike.
    void settle();

    /// Column `number` of rows that this rank has, and whether a row was added; 0 where it was not.
    [[nodiscard]] std::vector<double> column(std::size_t number, std::uint64_t first,
                                             std::uint64_t count) const;
    [[nodiscard]] std::vector<std::uint8_t> was_added(std::uint64_t first,
                                                      std::uint64_t count) const;

    /// This rank's share of the rows, without those beyond.
    [[nodiscard]] std::uint64_t first_row() const { return own_first; }
    [[nodiscard]] std::uint64_t end_row() const { return own_end; }

    [[nodiscard]] std::uint64_t bytes_sent() const { return sent; }

private:
    std::uint64_t rows;
    std::size_t numbers;
    Ranks& ranks;
    std::uint64_t own_first;
    std::uint64_t own_end;
    std::uint64_t kept_end; ///< of the rows beyond
    std::string waiting;    ///< records that are not in a file yet, own ones
    std::string leaving;    ///< and those of others
    ScratchFile blocks;     ///< a region for the records of each block of rows
    std::vector<std::uint64_t> in_block;
    ScratchFile outgoing;
    std::vector<ScratchFile> columns; ///< the last one says whether a row was added
    std::uint64_t sent = 0;

    [[nodiscard]] std::size_t record_bytes() const { return 8 * (1 + numbers); }
    [[nodiscard]] std::uint64_t rows_end_of(int rank) const;
    template <class Visit>
    void for_ranks_of(std::uint64_t row, const Visit& visit) const;
    void store(std::string_view records);
    void flush();
    void exchange();
    void make_columns();
};

} // namespace meniscus
