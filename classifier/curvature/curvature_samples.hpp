// Particles of clouds with known curvature, as the runtime sees them: what a curvature map is
// fitted to. Every stage of a step that comes before the map runs on the clouds of a calibration.
// Samples of one shape, size and arrangement form a group, since a map should be right in each.
#pragma once

#include "calibration.hpp"

#include <functional>

namespace meniscus {

/// One surface particle.
struct CurvatureSample {
    double turning = 0; ///< averaged over the surface around where the map is
    double square = 0;
    double closed_form = 0;
    double curvature = 0; ///< the truth: h kappa at the nearest point of the surface
    double weight = 0;    ///< exposure weight
};

/// Samples that belong together, and what they are of.
struct CurvatureGroup {
    std::string shape;
    Side side = Side::inside;
    std::string arrangement; ///< "relaxed", "lattice, jitter 0.2", "dense"
    double size = 0;         ///< h / R of the shape; 1 / h
    double spacing_ratio = 0;
    int directions = 0; ///< 0: exact coverage
    int clouds = 0;
    std::vector<CurvatureSample> samples;
};

/// The particles around a place on a surface, dense: inside the fluid and on its surface.
struct DenseCloud {
    Positions positions; ///< the first one is at the place
    std::vector<std::uint8_t> is_candidate;
};

/// A cloud as DenseClouds says, in support radii: h is 1. All within 2 h are there, candidates
/// within h. Throws as random_neighborhood does.
DenseCloud dense_cloud(const Shape& shape, const std::array<double, 3>& place,
                       const DenseClouds& clouds, std::uint64_t seed);

/// What the runtime finds of a dense cloud's first particle, in `directions` sampled directions of
/// that seed (0: exactly).
CurvatureSample dense_sample(const DenseCloud& cloud, const Calibration& calibration,
                             int directions, std::uint64_t seed);

/// All groups of a calibration. `progress` is called with the groups done and their number. The
/// same on every machine, whatever the threads. Throws as fill() does.
std::vector<CurvatureGroup>
curvature_groups(const Calibration& calibration,
                 const std::function<void(std::size_t, std::size_t)>& progress);

} // namespace meniscus
