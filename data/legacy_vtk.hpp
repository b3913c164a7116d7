// VTK's legacy format ("# vtk DataFile Version ..."), versions 1.0 to 5.1, ASCII or binary:
// UNSTRUCTURED_GRID with vertex cells, as SPlisHSPlasH writes it, and POLYDATA with vertices or
// mere points, as DualSPHysics does. Point data keeps the names that the solver gave;
// SPlisHSPlasH's `id`, `velocity` and `density` coincide with ours.
#pragma once

#include "snapshot.hpp"

#include <filesystem>

namespace meniscus {

/// True where the file begins with the legacy format's first line.
bool is_legacy_vtk(const std::filesystem::path& file);

/// Reads positions and point data. Throws InputError, naming the section, on anything that is not
/// well formed; memory is bounded by the file's own size whatever its header claims.
Snapshot read_legacy_vtk(const std::filesystem::path& file);

} // namespace meniscus
