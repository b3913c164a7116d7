// What is measured, as a table: printed as Markdown, kept as JSON, and plotted (plot.hpp). A row is
// among the best where no other is as good in every figure, and better in one (Pareto).
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace meniscus {

/// Median of repeated runs, and the quartiles, between which half of the runs lie.
struct RepeatedTime {
    double median = 0; ///< in the unit of its column
    double lower = 0;
    double upper = 0;
};

/// Several figures in one cell, printed as "1 / 2".
using Figures = std::vector<double>;

/// What stands in a cell; nothing where a figure does not apply, printed as "-".
struct Cell : std::variant<std::monostate, std::string, double, RepeatedTime, Figures> {
    Cell(std::monostate nothing = {}) : variant(nothing) {}
    Cell(std::string text) : variant(std::move(text)) {}
    Cell(const char* text) : variant(std::string(text)) {}
    Cell(const RepeatedTime& time) : variant(time) {}
    Cell(Figures figures) : variant(std::move(figures)) {}
    template <class Number, class = std::enable_if_t<std::is_arithmetic_v<Number>>>
    Cell(Number number) : variant(static_cast<double>(number)) {}
    template <class Number, class = std::enable_if_t<std::is_arithmetic_v<Number>>>
    Cell(const std::optional<Number>& number) : Cell() {
        if (number)
            *this = Cell(*number);
    }
};

struct Column {
    std::string key;     ///< in JSON
    std::string heading; ///< in Markdown, with unit
    int digits = 3;      ///< significant ones, in Markdown; JSON keeps all
    /// In their place: how fmt prints a figure, as "{:.2f} %".
    std::string format = {};
    bool bold_min = false; ///< the smallest figure is printed bold
};

/// A picture of a table's columns, as a rule time against error.
struct Plot {
    std::string file; ///< name, ending in .svg
    std::string title;
    std::string x;      ///< key of a column of figures
    std::string y;      ///< key of a column of figures
    std::string series; ///< key of a column of texts: rows of one text share color and legend entry
    std::string label = {}; ///< key of a column of texts that name the points; empty: no names
    /// Key of a column of texts: a picture beside another for each; or empty.
    std::string panel = {};
    bool logarithmic_x = true;
    bool logarithmic_y = true; ///< zeros then stand a decade below the smallest figure, marked 0
    bool joined = false;       ///< lines through the rows of a series, in their order
};

struct Table {
    std::string name; ///< key in JSON, stem of the plot
    std::string title;
    std::vector<Column> columns;
    std::vector<std::vector<Cell>> rows;
    std::string before = {}; ///< Markdown above the table
    std::string after = {};  ///< and below
    std::vector<Plot> plots = {};

    /// Index of the column of that key, which must be one.
    [[nodiscard]] std::size_t column(const std::string& key) const;
    void add(std::vector<Cell> row) { rows.push_back(std::move(row)); }
};

/// An empty table with columns as "state | k {:.2f} | rate {:.1f} %": headings, which are the keys
/// in JSON, too, with how fmt prints the figures below. Where a heading is there twice, the later
/// keys end in " (PLACE)", places counted from 1.
Table table_of(const std::string& name, const std::string& columns);

/// The same below its title in bold.
Table titled_table(const std::string& name, const std::string& title, const std::string& columns);

/// A text in place of a table.
Table text_alone(const std::string& text);

/// The number of a cell, the median of a time; nothing for texts, several figures and empty cells.
std::optional<double> figure(const Cell& cell);

/// Adds a column "best" that says "yes" in each row that no other row beats: none is at most equal
/// in each of the columns `keys` and less in one. Rows that lack one of the figures are not among
/// the best. Where `group` names a column, rows are compared only with those of equal text there.
void mark_best(Table& table, const std::vector<std::string>& keys, const std::string& group = "");

/// The cells of a row of the table, as markdown() prints them.
std::vector<std::string> texts_of(const Table& table, const std::vector<Cell>& row);

/// The table in Markdown, without its title and the texts around it; nothing without columns.
std::string markdown(const Table& table);

/// {"name", "title", "columns": [{"key", "heading"}], "rows": [{key: value}]}; a RepeatedTime is an
/// object of median, lower and upper, several figures are an array, and an empty cell is null.
nlohmann::json to_json(const Table& table);

} // namespace meniscus
