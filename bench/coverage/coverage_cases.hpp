// Particles whose uncovered fraction lambda is known exactly, to measure estimates of it against.
#pragma once

#include <meniscus/labeler/sampling/directions.hpp>

#include <filesystem>

namespace meniscus {

/// Radius of the covering spheres over the support radius, in all cases.
inline constexpr double case_radius_ratio = 0.8;

struct CoverageCase {
    std::vector<Direction> displacements; ///< of the neighbors, in units of the support radius
    double uncovered_fraction;            ///< lambda, exact; above zero_uncovered_fraction
};

/// Cases from snapshots in 3D that store their support radius: about `per_file` particles of each
/// that are not wholly covered, picked at random, always the same. Throws as read_snapshot_in_3d
/// does.
std::vector<CoverageCase> cases_of_files(const std::vector<std::filesystem::path>& files,
                                         std::size_t per_file);

/// Cases in 2D: particles at the rim of a disc that are not wholly covered, of a square lattice
/// with each particle moved at random.
std::vector<CoverageCase> cases_of_a_disc();

} // namespace meniscus
