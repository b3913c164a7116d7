// Plots of a table's columns (struct Plot) as charts.
#pragma once

#include "table.hpp"

#include <filesystem>

namespace meniscus {

/// Draws the plot into a folder as SVG; an existing file is replaced. Rows without one of the
/// figures are left out, and where none is left nothing is drawn; those marked best (mark_best) are
/// filled, and where rows have names theirs are there in any case. Throws as write_whole does.
void draw(const Table& table, const Plot& plot, const std::filesystem::path& folder);

} // namespace meniscus
