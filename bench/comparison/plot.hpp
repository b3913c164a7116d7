// Plots of a table's columns, as a rule time against error, drawn as SVG by gnuplot.
#pragma once

#include "comparison/table.hpp"

#include <filesystem>

namespace meniscus {

struct Plot {
    std::string file; ///< name, ending in .svg
    std::string title;
    std::string x;      ///< key of a column of figures
    std::string y;      ///< key of a column of figures
    std::string series; ///< key of a column of texts: rows of one text share color and legend entry
    std::string label = {}; ///< key of a column of texts that name the points; empty: no names
    std::string panel =
        {}; ///< key of a column of texts: a picture beside another for each; or empty
    bool logarithmic_x = true;
    bool logarithmic_y = true; ///< zeros then stand a decade below the smallest figure, marked 0
    bool joined = false;       ///< lines through the rows of a series, in their order
};

/// Throws FailureError where gnuplot cannot be run: to be asked before something long.
void require_gnuplot();

/// Draws the plot into a folder; an existing file is replaced. Rows without one of the figures are
/// left out, and where none is left nothing is drawn; those marked best (mark_best) are drawn
/// filled. Throws FailureError where gnuplot is missing or fails, or where the file cannot be
/// written.
void draw(const Table& table, const Plot& plot, const std::filesystem::path& folder);

} // namespace meniscus
