// The runtime on a stored snapshot: what a solver that uses the model would see at that instant.
// The audit compares it with the labels, `meniscus classify` writes it down.
#pragma once

#include "model.hpp"

#include <meniscus/data/particles/neighbor_search.hpp>
#include <meniscus/data/particles/particle_volumes.hpp>
#include <meniscus/data/particles/snapshot.hpp>
#include <meniscus/data/slabs/part_of_state.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace meniscus {

/// What features are summed over.
struct Neighborhoods {
    NeighborLists lists;
    NeighborLists boundary_lists;     ///< indices of boundary particles; empty where none counts
    std::vector<double> masses;       ///< kg, one a particle; empty where all are equal
    BoundaryWeights boundary_weights; ///< of the boundary particles in the lists
    SupportRadii radii = 0;           ///< h in m
    double spacing_ratio = 1;         ///< measured_spacing_ratio()
    std::vector<std::uint8_t> valid;
};

/// The boundary particles closer than its support radius to each particle whose `valid` is not 0,
/// in compressed rows; empty where there is no boundary. Throws InputError where the boundary
/// cannot be used, or the neighbor search refuses.
NeighborLists find_boundary_neighbors(const Snapshot& snapshot, const SupportRadii& radii,
                                      const std::vector<std::uint8_t>& valid, int threads);

/// The neighborhoods of the particles whose `valid` is not 0: a `phase` array keeps phases apart, a
/// `mass` array weights the features. With a `boundary_weight` the snapshot's boundary particles
/// are neighbors too, whatever the phase, with their volumes (data/particles/particle_volumes.hpp);
/// where radii vary, each with the radius of the particle that it is a neighbor of. `threads` 0
/// takes all cores. Throws InputError where such an array cannot be used, where the mass of a valid
/// particle is not positive, or where the neighbor search refuses; likewise for a boundary that
/// counts.
Neighborhoods find_neighborhoods(const Snapshot& snapshot, const SupportRadii& radii,
                                 const std::vector<std::uint8_t>& valid, double boundary_weight,
                                 int threads);

/// One entry a particle, in the snapshot's order.
struct Predictions {
    std::vector<std::uint8_t> surface;  ///< 1 surface, 0 interior
    std::vector<double> neighbor_count; ///< feature y; whole for one radius, no boundary
};

/// Runs the runtime's classifier with positions, masses, radii and line in the given precision. A
/// relative line is scaled to the median neighbor count of the valid particles.
Predictions predict(const Model& model, const Snapshot& snapshot,
                    const Neighborhoods& neighborhoods, Precision precision);

struct ClassifyOptions {
    bool skip_invalid = false; ///< leave particles with non-finite positions out
    int threads = 0;           ///< 0: all cores; the classes do not depend on it
};

/// One entry a particle, in the snapshot's order.
struct Classes {
    std::vector<std::uint8_t> surface;  ///< 1 surface, 0 interior or not valid
    std::vector<std::uint8_t> valid;    ///< 0 where left out
    std::vector<double> neighbor_count; ///< feature y; whole for one radius, no boundary
    std::vector<std::string> warnings;  ///< one line each, for standard error
    Neighborhoods neighborhoods;        ///< that the classes were found over
};

/// Classifies a snapshot in double. Its boundary particles count where the model says that they do.
/// Throws InputError where it has no support radius, where the
/// model is of another dimension, where positions cannot be worked with (checked_positions) unless
/// skip_invalid, and as find_neighborhoods does.
Classes classify_snapshot(const Snapshot& snapshot, const Model& model,
                          const ClassifyOptions& options);

/// What classify_snapshot finds for the particles of a part of a state, of which the whole has that
/// spacing ratio, without warnings. It is right for the own ones and, where the part's halo is
/// deep enough, for their neighbors.
Classes classify_part(const Snapshot& snapshot, const PartOfState& part, const Model& model,
                      double spacing_ratio, int threads);

/// A line where a state is outside what a model was trained for, by its spacing ratio and the
/// median neighbor count of its particles that are no candidates; else empty.
std::string range_warning(const Model& model, double spacing_ratio,
                          std::optional<double> interior_neighbor_count);

} // namespace meniscus
