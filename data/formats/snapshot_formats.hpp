// The list of formats that snapshots are read from: a new one is its file, with a function that is
// declared here, and its place in the list. Those that are kept in HDF5 files have a list of their
// own (detail/hdf5_formats.hpp).
#pragma once

#include "read_choices.hpp"
#include <meniscus/data/particles/snapshot.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace meniscus {

/// Both functions throw InputError where the file is missing, empty or no regular file.
struct SnapshotFormat {
    std::string name; ///< as messages give it
    /// Whether the file is of the format, by its first bytes or lines.
    bool (*detect)(const std::filesystem::path& file);
    /// Throws InputError, naming the file and the place in it, on anything that is not well formed.
    /// Memory is bounded by what the file's bytes can hold, whatever they claim.
    Snapshot (*reader)(const std::filesystem::path& file, const ReadChoices& choices);
    /// Whether a file may hold several states, of which ReadChoices::frame is one.
    bool holds_frames = false;

    /// As the file has it, but for choices that name arrays of particles.
    Snapshot read(const std::filesystem::path& file, const ReadChoices& choices = {}) const {
        return reader(file, choices);
    }
};

SnapshotFormat hdf5_format();
SnapshotFormat legacy_vtk_format();
SnapshotFormat bgeo_format();
SnapshotFormat vtk_xml_format();
SnapshotFormat ply_format();
SnapshotFormat npy_format();
SnapshotFormat xyz_format();
SnapshotFormat deep_lagrangian_fluids_format();
SnapshotFormat lammps_format();
SnapshotFormat csv_format();

/// In the order in which a file is tried.
inline std::vector<SnapshotFormat> snapshot_formats() {
    return {hdf5_format(),
            legacy_vtk_format(),
            vtk_xml_format(),
            bgeo_format(),
            ply_format(),
            npy_format(),
            deep_lagrangian_fluids_format(),
            xyz_format(),
            lammps_format(),
            csv_format()};
}

} // namespace meniscus
