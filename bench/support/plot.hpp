// Plots of a table's columns (struct Plot), drawn as SVG by gnuplot.
#pragma once

#include "table.hpp"

#include <filesystem>

namespace meniscus {

/// Throws FailureError where gnuplot cannot be run: to be asked before something long.
void require_gnuplot();

/// Draws the plot into a folder; an existing file is replaced. Rows without one of the figures are
/// left out, and where none is left nothing is drawn; those marked best (mark_best) are drawn
/// filled. Throws FailureError where gnuplot is missing or fails, or where the file cannot be
/// written.
void draw(const Table& table, const Plot& plot, const std::filesystem::path& folder);

} // namespace meniscus
