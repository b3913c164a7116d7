// The project's own snapshot files: VTKHDF (HDF5, type UnstructuredGrid, version 1.0), one vertex
// cell a particle, which ParaView and VTK's own reader open as they are. What VTK need not see
// lies in the group /meniscus. The layout is described in docs/file_formats.md.
#pragma once

#include <meniscus/data/particles/snapshot.hpp>

#include <filesystem>

namespace meniscus {

/// True where the file begins as an HDF5 file and holds a group /VTKHDF.
bool is_vtkhdf(const std::filesystem::path& file);

/// Reads a VTKHDF file of particles. Throws InputError where it is not one, where arrays disagree
/// in length, or where a dataset claims more than the file can hold.
Snapshot read_vtkhdf(const std::filesystem::path& file);

/// What the file says of itself, without its particles: a snapshot of none, with the names of its
/// point data, its numbers, scene and provenance. Throws as read_vtkhdf does, but for the arrays,
/// which are not looked at.
Snapshot read_vtkhdf_header(const std::filesystem::path& file);

/// Writes the snapshot, whole or not at all; the same snapshot gives the same bytes. Throws as
/// write_whole does.
void write_vtkhdf(const Snapshot& snapshot, const std::filesystem::path& file);

} // namespace meniscus
