// What `meniscus classify` adds to a classified snapshot: the surface as a solver with the runtime
// would find it, with normals, curvatures and forces.
#pragma once

#include "command_line.hpp"

#include <meniscus/classifier/classify_snapshot.hpp>

#include <optional>

namespace meniscus {

/// What the user asks of the runtime; what is not set is as in the runtime's own options, or with
/// `paper` as in the 2020 paper.
struct SurfaceChoices {
    bool paper = false;
    bool exact = false; ///< coverage in closed form, for all candidates
    std::optional<std::size_t> samples;
    std::optional<double> time_step;        ///< s
    std::optional<double> sampling_density; ///< 1/s
    bool drop_covered = false;
    std::optional<double> fade;
    bool no_fade = false;
    std::optional<int> normal_passes;
    std::optional<double> tau;
    std::optional<double> pca_share;
    std::string curvature; ///< closed, mapped or empty
    std::optional<int> curvature_passes;
    std::string force;                     ///< paper, calibrated or empty
    std::optional<double> surface_tension; ///< N/m
    bool balance_momentum = false;
};

/// Adds the options above to a verb.
void add_surface_options(CLI::App& verb, SurfaceChoices& choices);

/// What was found, in words for the line that is printed, and what there is to note.
struct SurfaceReport {
    std::string found;
    std::string note; ///< a line, or empty
};

/// Adds the arrays of the runtime (surface_class, runtime_*; docs/file_formats.md) to a snapshot
/// that was classified into `classes` by `model`, and says in its provenance how they were made.
/// The line's candidates are those of `classes`. Boundary particles cover, and bodies that touch
/// them keep their net force. `threads` 0 takes all cores; no bit depends on it. Throws InputError
/// where the boundary or the array `id` cannot be used, or the model's radius ratio is 1.
SurfaceReport add_surface(Snapshot& snapshot, const Classes& classes, const Model& model,
                          const SurfaceChoices& choices, int threads);

} // namespace meniscus
