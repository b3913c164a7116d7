// A CSV file as lines of cells. Cells may stand in double quotes, which hold separators as they are
// and quotes twice; no cell goes over the end of its line.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace meniscus::csv {

/// What is left of a file to read, line by line.
struct Source {
    std::filesystem::path file;
    std::string_view rest;
    std::size_t line = 0; ///< number of the line taken last, from 1
};

/// A source at the first line of the file's bytes, past a byte order mark.
Source source_of(const std::filesystem::path& file, std::string_view bytes);

/// Throws an InputError that names the file, the line taken last, and the column unless empty.
[[noreturn]] void fail(const Source& source, const std::string& column, const std::string& expected,
                       const std::string& found);

/// Fails where the last line of the source does not end and may be cut within a number.
void check_end(Source source, char separator);

/// The next line without its end and spaces around it.
std::string_view take_line(Source& source);

/// What is left of a line, cell by cell.
struct Cells {
    std::string_view rest;
    char separator;
    bool more = true; ///< there is a cell, which may be empty
};

/// The next cell, without spaces or quotes around it; none where quotes are not closed, or not
/// around the whole cell.
std::optional<std::string_view> take_cell(Cells& cells);

/// The cells of a header line; none where its quotes make no sense.
std::vector<std::string> names_of(std::string_view line, char separator);

/// The text without spaces at its end.
std::string_view without_spaces_behind(std::string_view text);

} // namespace meniscus::csv
