// Charts of tables: columns by their names over each other.
#pragma once

#include "text_table.hpp"

#include <meniscus/data/drawing/chart.hpp>

#include <string>
#include <vector>

namespace meniscus {

struct TableChartOptions {
    std::string x; ///< column; empty: the time of a log
    /// Columns, each with a panel of its own, or several of one panel with commas between. None:
    /// the rows stand below each other, with their names.
    std::vector<std::string> y;
    std::string series; ///< column of texts: rows of one text share a color; or empty
    std::string names;  ///< column of texts that stand at the points; or empty
    std::string panel;  ///< column of texts: a panel for each; or empty
    bool is_logarithmic_x = false;
    bool is_logarithmic_y = false;
    bool is_joined = false;
};

/// Adds the rows of a table that have both figures; `prefix` goes before the names of its series.
/// Rows where a column `best` has something else than "yes" are rings. Throws InputError where
/// there is no column of a name, or a text in place of a figure.
void add_table(const TextTable& table, const TableChartOptions& options, const std::string& prefix,
               Chart& chart);

} // namespace meniscus
