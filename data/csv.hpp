// Tables of particles as text: one line that names the columns, then one line a particle. What
// ParaView exports ("Points:0","velocity:0"), what DualSPHysics' PartVTK saves (Pos.x [m];Idp; with
// lines about the time step in front), and plain x,y,z. Columns are separated by commas, semicolons
// or tabs, numbers have a decimal point, texts may stand in double quotes.
//
// Columns that are known under several names get ours (`id`, `velocity`, `density`, `mass`,
// `phase`, `support_radius`); others keep theirs. docs/file_formats.md has the names.
#pragma once

#include "snapshot.hpp"

#include <filesystem>

namespace meniscus {

/// True where one of the first lines names columns with positions.
bool is_csv(const std::filesystem::path& file);

/// Reads positions, point data, and the time where PartVTK wrote it. Without a column z the
/// snapshot is two-dimensional; without y too, with z for the second coordinate. Throws InputError,
/// naming the line and the column, where a cell is missing, one too many, or no number; where two
/// columns have one name; where a unit is not the SI's; and where the file does not end with a line
/// break, since it may then be cut within a number. A file that is cut at the end of a line cannot
/// be told from a whole one. Memory is bounded by the file's own size.
Snapshot read_csv(const std::filesystem::path& file);

} // namespace meniscus
