// What training and audit need of a labelled snapshot: the two features and the uncovered fraction
// of each valid particle, and what the file says of itself. Twenty bytes a particle, so that ten
// million particles are held with ease; never as tensors.
#pragma once

#include <meniscus/data/snapshot.hpp>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace meniscus {

struct LabelledState {
    std::string file;  ///< name without folder
    std::string hash;  ///< SHA-256 of the file
    std::string scene; ///< scene_of() unless overridden
    int dimension = 3;
    double support_radius = 0; ///< h in m
    double radius_ratio = 0;   ///< r2 / r1 that it was labelled with
    std::optional<double> particle_spacing;
    // One entry a valid particle, in the file's order:
    std::vector<double> mass_offset;           ///< feature x, without unit
    std::vector<std::uint32_t> neighbor_count; ///< feature y
    std::vector<double> uncovered_fraction;    ///< lambda

    [[nodiscard]] std::size_t size() const { return mass_offset.size(); }
};

/// Takes the state out of a labelled snapshot read from `file`. Throws InputError, naming the file
/// and what is missing, where it was not labelled (`meniscus label` adds the arrays) or where an
/// array has a value that is not finite or out of range.
LabelledState labelled_state(const Snapshot& snapshot, const std::filesystem::path& file);

/// Reads and checks one labelled file; `scene` replaces the file's own where it is not empty.
LabelledState read_labelled_state(const std::filesystem::path& file, const std::string& scene);

/// Neighbor count typical of the bulk: the median over particles with lambda = 0; nothing where
/// there are none.
std::optional<double> bulk_neighbor_count(const LabelledState& state);

} // namespace meniscus
