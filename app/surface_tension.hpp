// What `meniscus classify` adds to a classified snapshot: the surface as a solver with the runtime
// would find it, with normals, curvatures and forces.
#pragma once

#include "command_line.hpp"

#include <meniscus/classifier/model/classify_snapshot.hpp>
#include <meniscus/runtime/surface/surface_options.hpp>

#include <map>
#include <optional>
#include <string>

namespace meniscus {

/// What the user asks of the runtime.
struct SurfaceChoices {
    bool paper = false;
    /// Options of the runtime's table by name, as texts that were checked; empty: not asked for.
    std::map<std::string, std::string> options;
    std::optional<double> time_step;        ///< s
    std::optional<double> sampling_density; ///< 1/s
    bool balance_momentum = false;
};

/// Adds options to a verb: those of the runtime's table that neither model nor input give, and
/// what the choices have besides.
void add_surface_options(CLI::App& verb, SurfaceChoices& choices);

/// The options that the choices make, over the runtime's own or, with `paper`, over the 2020
/// paper's. Throws InputError where one has no meaning beside another.
SurfaceTensionOptions surface_options(const SurfaceChoices& choices);

/// The options that have a meaning beside each other, by name, as texts; those of the line left
/// out.
std::map<std::string, std::string> surface_option_texts(const SurfaceTensionOptions& options);

/// What was found, in words for the line that is printed, and what there is to note.
struct SurfaceReport {
    std::string found;
    std::string note; ///< a line, or empty
};

struct SurfaceCounts {
    std::uint64_t candidates = 0;
    std::uint64_t surface = 0; ///< of these
};

/// Adds the arrays of the runtime (surface_class, runtime_*; docs/file_formats.md) to a snapshot
/// that was classified into `classes` by `model`. The line's candidates are those of `classes`;
/// model and classes give radius_ratio and spacing_ratio of the options. Boundary particles cover.
/// `balanced`: bodies that touch none of them have no net force and torque. `threads` 0 takes all
/// cores; no bit depends on it. Throws InputError where the boundary or the array `id` cannot be
/// used, or the model's radius ratio is 1.
SurfaceCounts find_surface(Snapshot& snapshot, const Classes& classes, const Model& model,
                           SurfaceTensionOptions options, bool balanced, int threads);

/// Says in a snapshot's provenance how these arrays were made, and what there is to say of them.
SurfaceReport note_surface(Snapshot& snapshot, const SurfaceCounts& found, const Model& model,
                           SurfaceTensionOptions options, double spacing_ratio, bool balanced);

/// Both.
SurfaceReport add_surface(Snapshot& snapshot, const Classes& classes, const Model& model,
                          const SurfaceTensionOptions& options, bool balanced, int threads);

} // namespace meniscus
