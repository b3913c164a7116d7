// Tables of words between spaces, one line a particle, as extended XYZ and LAMMPS dumps have them.
#pragma once

#include <meniscus/data/particles/snapshot.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace meniscus {

struct WordColumn {
    std::string name;
    bool is_text = false; ///< which nothing is made of
    ArrayValues values;   ///< whole numbers until one is not
};

/// What is left of a text, line by line.
struct Lines {
    std::filesystem::path file;
    std::string_view rest;
    std::size_t line = 0; ///< number of the line taken last, from 1
};

/// Throws an InputError that names the file and the line taken last.
[[noreturn]] void fail(const Lines& lines, const std::string& expected, const std::string& found);

/// The next line without its end.
std::string_view take_line(Lines& lines);

/// A count that is alone on the next line.
std::uint64_t take_count(Lines& lines, const std::string& of);

/// Takes `rows` lines into the columns. Fails where a line has another number of words, or a word
/// is no number in a column of numbers.
void take_rows(Lines& lines, std::uint64_t rows, std::vector<WordColumn>& columns);

/// Whether anything but space follows.
bool has_more(const Lines& lines);

/// The column of that name, or nullptr.
const WordColumn* find_column(const std::vector<WordColumn>& columns, std::string_view name);

/// Positions from columns of these names, y or z being 0 where there is none, and all other columns
/// of numbers as point data.
Snapshot snapshot_of(const Lines& lines, std::vector<WordColumn> columns,
                     const std::vector<std::string>& axes);

} // namespace meniscus
