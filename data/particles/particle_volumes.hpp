// Volumes of particles, which files seldom say: how many fluid particles each boundary particle
// stands for where it counts in features (runtime/neighbors/boundary.hpp has the formula), and how
// many spacings the support radius has. The boundary's volumes come from its own spacing; that of
// the fluid at rest is stored by `meniscus simulate`, and otherwise measured in the same way.
#pragma once

#include "neighbor_search.hpp"
#include "snapshot.hpp"
#include "support_radii.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace meniscus {

/// The share of its volume that a boundary particle counts for unless somebody says otherwise
/// (docs/training.md).
inline constexpr double default_boundary_weight = 0.85;

/// The support radius over the spacing of particles at rest, the root of their volume V_0: the
/// snapshot's particle_volume or, without one, 1 / sum_j W_ij of the fluid with the cubic spline,
/// which only the quarter of least volume is below: particles inside, whatever part of the fluid is
/// surface; and at most particle_spacing to the power of the dimension, where the snapshot has it.
/// Where radii vary, each particle's own radius and volume. 1 where there is no particle. `threads`
/// 0 takes all cores. Throws InputError as the neighbor search does.
double measured_spacing_ratio(const Snapshot& snapshot, const SupportRadii& radii,
                              const std::vector<std::uint8_t>& valid, int threads);

// Its parts, for a state that is worked on in parts:

/// The ratio of the snapshot's particle_volume; nothing where it has to be measured.
std::optional<double> stored_spacing_ratio(const Snapshot& snapshot, const SupportRadii& radii);

/// h^D sum_j W_ij of each particle of a grid, itself included, in the grid's order. With
/// `without_crowds`, NaN for those of a crowd in one place, whose volume says nothing.
std::vector<double> kernel_sums(const NeighborGrid& grid, const SupportRadii& radii, int dimension,
                                int threads, bool without_crowds);

/// The one of this particle, whose neighbors were found in such a grid.
double kernel_sum(const FoundNeighbors& found, std::size_t particle, const SupportRadii& radii,
                  int dimension, bool without_crowds);

/// The place, in ascending order, of the sum that decides: among those that are numbers or, where
/// none is, among those with crowds.
inline std::uint64_t quartile_place(std::uint64_t sums) {
    return sums * 3 / 4;
}

/// The ratio by that sum.
double spacing_ratio_of_sum(double quartile, const Snapshot& snapshot, const SupportRadii& radii);

/// The same by all sums; nothing where none is a number.
std::optional<double> spacing_ratio_of_sums(std::vector<double> sums, const Snapshot& snapshot,
                                            const SupportRadii& radii);

struct BoundaryWeights {
    std::vector<double>
        at_radius;     ///< V_b / V_0 of each boundary particle for fluid of this radius:
    double radius = 1; ///< m

    /// V_b / V_0 for a fluid particle of that support radius (m), whose volume goes with its power
    /// of `dimension`.
    [[nodiscard]] double of(std::size_t boundary_particle, double support_radius,
                            int dimension) const;
};

/// The weights of a snapshot's boundary; none where it has no boundary. V_b = 1 / sum_b' W_bb' with
/// the cubic spline over the support radius, the median one where radii vary; `spacing_ratio` is
/// measured_spacing_ratio(). `threads` 0 takes all cores. Throws InputError as check_boundary and
/// the neighbor search do.
BoundaryWeights boundary_weights(const Snapshot& snapshot, const SupportRadii& radii,
                                 const std::vector<std::uint8_t>& valid, double spacing_ratio,
                                 int threads);

} // namespace meniscus
