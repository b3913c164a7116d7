// Plots of a table's columns (struct Plot) as charts.
#pragma once

#include "table.hpp"

#include <filesystem>

namespace meniscus {

/// The plot as SVG. Rows without one of the figures are left out, and where none is left it is
/// empty; those marked best (mark_best) are filled, and where rows have names theirs are there in
/// any case.
std::string svg_of(const Table& table, const Plot& plot);

/// Writes that to a file of its name in a folder, in the place of one that is there, and nothing
/// where it is empty. Throws as write_whole does.
void draw(const Table& table, const Plot& plot, const std::filesystem::path& folder);

} // namespace meniscus
