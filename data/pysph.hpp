// PySPH's `.hdf5` output: under /particles a group for each of its particle arrays ("fluid",
// "boundary", ...), whose arrays of coordinates and properties it names by letters, and the time in
// /solver_data. What such a file leaves open is taken as follows, and the snapshot's provenance
// says so:
//   - Which arrays are walls is told by their names (boundary, solid, wall, tank, ...), and rigid
//     bodies by their property `body_id`; all others are fluid, each one a phase where there are
//     several. An array that is alone is fluid whatever its name. (`fluid_arrays`,
//     `boundary_arrays`)
//   - PySPH's h is a smoothing length; the support radius is 2 h, as for its cubic spline and
//     Wendland kernels. (`support_radius_from`)
#pragma once

#include "snapshot.hpp"

#include <filesystem>

namespace meniscus {

/// Reads the real particles (`tag` 0) in a child process (isolated_read.hpp). Names become ours:
/// `velocity`, `density`, `mass`, `pressure`, `id`; other properties that all fluid arrays store
/// keep theirs. A support radius that varies is point data `support_radius`. Throws InputError
/// where there is no fluid particle, or where the file is damaged or inconsistent.
Snapshot read_pysph(const std::filesystem::path& file);

} // namespace meniscus
