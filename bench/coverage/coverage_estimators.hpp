// What the ways to find how exposed a surface particle is are worth: run-time random directions
// (2019 preprint), a table of random ones, blue noise and Halton's sequence (2020 paper, section
// 3.3), this project's outward directions, exact coverage; and beside them the color field, which
// needs no directions, with the curvature of Mueller et al. 2003 (the field's Laplacian over its
// gradient's length) and that of Morris 2000 (the divergence of the field's unit normals).
//
// What follows coverage is the same for all: normals are smoothed once, and curvature comes from
// how they turn (runtime/surface/curvature_map.hpp). Candidates are all surface particles, as with
// a perfect line. Published schemes lose a particle that no sample finds uncovered, as published;
// outward directions run in both ways, with the exact test that decides in that case, as they ship,
// and without.
#pragma once

#include "support/table.hpp"
#include "support/timing.hpp"

#include <cstddef>
#include <filesystem>
#include <vector>

namespace meniscus {

struct EstimatorOptions {
    /// Each at least 4.
    std::vector<std::size_t> samples = {10, 30, 100, 300, 1000, 3000, 10000, 30000, 100000};
    /// In 3D, with a support radius: lambda is measured on so many particles of each, too.
    std::vector<std::filesystem::path> snapshots;
    std::size_t particles_per_snapshot = 50;
    double ball_radius = 4;  ///< in support radii
    double disc_radius = 20; ///< likewise
    double saddle_width = 9; ///< likewise; its rim, 2 of them, is not measured
    int threads = 2;         ///< of the parallel times
    TimingOptions timing = {5, 0.01};
};

/// A row for each case (particles of snapshots, of a ball, of a saddle with h kappa = 0 and
/// principal curvatures of +-0.25 / h, and in 2D of a disc), estimator and number of samples.
/// Columns: case, estimator, samples (nothing where there are none); `lost` (percent of surface
/// particles without a normal; all errors are of the others) and root mean squares of errors:
/// `lambda`, over all surface particles, against exact coverage; over the outermost layer
/// `raw_normal` and, smoothed, `normal`, degrees; over all surface particles by the weight that
/// they have in forces `curvature`, of h kappa. Then time (us a surface particle, one thread) and
/// time_parallel (on `threads` threads): of coverage, normals and curvature, of the snapshots'
/// particles, whose neighbors are not surface, of coverage alone. The color field's is with volumes
/// given, as a step has them. Throws as cases_of_files() does.
Table coverage_estimators(const EstimatorOptions& options);

} // namespace meniscus
