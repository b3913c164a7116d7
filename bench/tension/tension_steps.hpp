// Whole surface-tension steps side by side on the same states: this project's with several numbers
// of samples, and its rivals. What is timed is all that a model does once a step has neighbor lists
// and densities with the kernel's slopes, which every SPH step has and which are not part of the
// time: ours classifies, samples, and finds normals, curvature and forces of the surface; rivals
// find what their formula needs (color field, normals) and sum over all pairs. All run as sph/ has
// them, eight neighbors at a time in float, for the widest instruction set of the machine.
//
// The truth on a shape: the force points along the inward normal, is proportional to the curvature,
// is zero inside, and sums up to zero. Strengths have no unit in common, so each model is scaled to
// the right mean. Models that pull particles together are not made for the first two alone: they
// pull at flat surfaces too, which pressure has to balance.
#pragma once

#include "support/table.hpp"
#include "support/timing.hpp"

#include <array>
#include <filesystem>
#include <vector>

namespace meniscus {

struct TensionStepOptions {
    double ball_radius = 5;                       ///< in support radii
    std::array<double, 3> half_axes = {8, 4, 4};  ///< of the ellipsoid, likewise
    std::vector<std::filesystem::path> snapshots; ///< in 3D, h = 2 spacings; nothing known of them
    int threads = 2;                              ///< of the parallel times
    TimingOptions timing;
};

/// A row for each state and model. Columns: state, particles, model, group; time (ns a particle of
/// the state, one thread) and time_parallel (on `threads` threads); over the outermost layer
/// `angle` (mean, degrees, between force and inward normal), `scatter` (root mean square of the
/// force along it less what the curvature asks for, over its mean) and `local_scatter` (the same of
/// means over all particles of the layer within h, so that only what a patch of the surface feels
/// counts); `inside` (part of the sum of |force| deeper than h) and `net` (|sum of forces| over the
/// sum of |force|). Snapshots have times and `net` alone. Throws as fill(), read_snapshot() and
/// fluid_state() do, and InputError for a snapshot in 2D.
Table tension_steps(const TensionStepOptions& options);

} // namespace meniscus
