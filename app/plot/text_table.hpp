// Tables that the project writes, as texts: logs of runs (CSV), what `meniscus_bench` prints
// (Markdown, as docs/ has it, too), and what it and `meniscus bench` keep (JSON).
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace meniscus {

struct TextColumn {
    std::string key;     ///< in JSON; elsewhere the heading
    std::string heading; ///< with unit
};

struct TextTable {
    std::string name; ///< in JSON; elsewhere its number in the file, from 1
    std::string title;
    std::vector<TextColumn> columns;
    std::vector<std::vector<std::string>> rows; ///< a cell a column
    bool is_log = false;                        ///< of a run: has the columns `frame` and `time`

    /// The column of that key or heading, or nothing.
    [[nodiscard]] std::optional<std::size_t> find(const std::string& name) const;
    /// The same; throws InputError with the nearest name and all there are where there is none.
    [[nodiscard]] std::size_t column(const std::string& name) const;
    /// The figure in a cell: the number that stands first in it, as in "**1.5** (1.4 to 1.6)";
    /// nothing where the cell is empty, "-" or not finite. Throws InputError, naming row and
    /// column, where it is a text.
    [[nodiscard]] std::optional<double> figure(std::size_t row, std::size_t column) const;
};

/// The keys of all columns, for messages.
std::string columns_text(const TextTable& table);

/// All tables of a file, told by its content. Throws InputError, naming the file and what was
/// expected, where it is of none of the three kinds, has no rows, or has a row of another length.
std::vector<TextTable> read_tables(const std::filesystem::path& file);

} // namespace meniscus
