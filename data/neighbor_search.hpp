// All pairs of particles closer than a radius, by a uniform grid of cells of that size: only the
// 27 (in 2D 9) cells around a particle need a look. Cells that fit a small box are indexed
// directly; scattered ones (two droplets a million radii apart) share a table of buckets that
// never outgrows the number of particles, so time and memory are linear in the particles whatever
// the extent of the scene.
#pragma once

#include "snapshot.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace meniscus {

/// Neighbor lists in compressed rows: the neighbors of particle i are
/// neighbors[offsets[i]] ... neighbors[offsets[i + 1] - 1], without i itself, in an order that
/// depends on the positions alone.
struct NeighborLists {
    std::vector<std::size_t> offsets; ///< size: particles + 1
    std::vector<std::uint32_t> neighbors;
};

/// What leaves pairs out of the lists. Both are empty or have one entry a particle.
struct NeighborFilter {
    const std::vector<std::uint8_t>* valid = nullptr; ///< particles with 0 have no neighbors
    const std::vector<std::int64_t>* phase = nullptr; ///< pairs of different phase do not count
};

/// The neighbors of each particle at a distance strictly below `radius` (m). `threads` 0 takes all
/// cores; the result does not depend on it. Throws InputError where radius is not positive and
/// finite or its square would leave the range of double (below 1e-150, above 1e150), where a valid
/// particle's position is not finite, where there are more than 2^32 - 1 particles, or where the
/// extent exceeds what double can resolve against the radius (2^50 radii).
NeighborLists find_neighbors(const Positions& positions, double radius,
                             const NeighborFilter& filter = {}, int threads = 0);

/// The neighbors among `others` (boundary particles, say) of each particle of `positions`,
/// likewise: entries of the lists are places in `others`. `valid` has one entry a particle; those
/// with 0 have no neighbors. Throws as find_neighbors does, for either set.
NeighborLists find_neighbors_among(const Positions& others, const Positions& positions,
                                   double radius, const std::vector<std::uint8_t>& valid,
                                   int threads = 0);

} // namespace meniscus
