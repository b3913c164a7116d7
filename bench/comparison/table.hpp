// The figures of a comparison: a table of one row a method, printed as Markdown, kept as JSON, and
// plotted (plot.hpp). A method is among the best where no other is as good in every figure, and
// better in one (Pareto).
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace meniscus {

/// Median of repeated runs, and the quartiles, between which half of the runs lie.
struct RepeatedTime {
    double median = 0; ///< in the unit of its column
    double lower = 0;
    double upper = 0;
};

/// What stands in a cell; nothing where a figure does not apply, printed as "-".
using Cell = std::variant<std::monostate, std::string, double, RepeatedTime>;

struct Column {
    std::string key;     ///< in JSON
    std::string heading; ///< in Markdown, with unit
    int digits = 3;      ///< significant ones, in Markdown; JSON keeps all
};

struct Table {
    std::string name; ///< key in JSON, stem of the plot
    std::string title;
    std::vector<Column> columns;
    std::vector<std::vector<Cell>> rows;

    /// Index of the column of that key, which must be one.
    [[nodiscard]] std::size_t column(const std::string& key) const;
};

/// The number of a cell, the median of a time; nothing for texts and empty cells.
std::optional<double> figure(const Cell& cell);

/// Adds a column "best" that says "yes" in each row that no other row beats: none is at most equal
/// in each of the columns `keys` and less in one. Rows that lack one of the figures are not among
/// the best. Where `group` names a column, rows are compared only with those of equal text there.
void mark_best(Table& table, const std::vector<std::string>& keys, const std::string& group = "");

/// Adds a first column "number" that counts the rows, from 1 in each stretch of rows with equal
/// text in column `group` where one is named: names for the points of a plot.
void number_rows(Table& table, const std::string& group = "");

/// The table in Markdown, without its title.
std::string markdown(const Table& table);

/// {"name", "title", "columns": [{"key", "heading"}], "rows": [{key: value}]}; a RepeatedTime is an
/// object of median, lower and upper, and an empty cell is null.
nlohmann::json to_json(const Table& table);

} // namespace meniscus
