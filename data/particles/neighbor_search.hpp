// All pairs of particles closer than a radius, by a uniform grid of cells of that size: only the
// 27 (in 2D 9) cells around a particle need a look. Cells that fit a small box are indexed
// directly; scattered ones (two droplets a million radii apart) share a table of buckets that
// never outgrows the number of particles, so time and memory are linear in the particles whatever
// the extent of the scene.
//
// Where each particle has its own radius, pairs count that are closer than the mean of theirs.
// Particles whose radii differ by less than a factor of two then share a grid, so that the large
// cells of a coarse region are not full of the particles of a fine one.
#pragma once

#include "grid_layout.hpp"
#include "snapshot.hpp"
#include "support_radii.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace meniscus {

/// Neighbor lists in compressed rows: the neighbors of particle i are
/// neighbors[offsets[i]] ... neighbors[offsets[i + 1] - 1], without i itself, in an order that
/// depends on the positions alone.
struct NeighborLists {
    std::vector<std::size_t> offsets; ///< size: particles + 1
    std::vector<std::uint32_t> neighbors;
};

/// Neighbors nearer than this share of the support radius cover nothing and count in no feature
/// where the covering spheres have 0.8 of it: below 0.2, where runtime and rounding decide.
inline constexpr double crowd_radius = 0.1998;

/// Lists hold no more neighbors a particle, on average, so that their memory is linear in the
/// number of particles whatever the radius: nobody simulates with support radii of more than some
/// eight spacings in space, or 25 in the plane.
inline constexpr std::size_t max_listed_neighbors = 2000;

/// Of neighbors as near, lists need hold no more than so many.
inline constexpr std::size_t usual_max_crowd = 100;

class NeighborGrid;

/// What leaves pairs out of the lists. The first two are empty or have one entry a particle.
struct NeighborFilter {
    const std::vector<std::uint8_t>* valid = nullptr; ///< particles with 0 have no neighbors
    const std::vector<std::int64_t>* phase = nullptr; ///< pairs of different phase do not count
    /// Neighbors nearer than crowd_radius beyond the first so many are left out of lists, whose
    /// memory is then linear in the number of particles even where all lie in one place.
    std::size_t max_crowd = std::numeric_limits<std::size_t>::max();
};

/// Neighbors of one particle, or of one place. Reused from one to the next.
struct FoundNeighbors {
    std::vector<std::uint32_t> particles;
    std::vector<std::array<double, 3>> displacements; ///< from the particle or place, m

    [[nodiscard]] std::size_t size() const { return particles.size(); }

    void clear() {
        particles.clear();
        displacements.clear();
    }
    void add(std::uint32_t particle, const std::array<double, 3>& displacement) {
        particles.push_back(particle);
        displacements.push_back(displacement);
    }
};

/// Particles sorted into cells, for one pass over all neighborhoods without lists. Any number of
/// threads may ask at a time.
class NeighborGrid {
public:
    /// Throws as find_neighbors does, but for the number of neighbors.
    NeighborGrid(const Positions& positions, const SupportRadii& radii,
                 const NeighborFilter& filter = {}, int threads = 0);
    /// A part of a state of that layout, its particles in the order that they have there: each
    /// finds those of its neighbors that are in the part, in the order in which it finds them in
    /// the whole. Throws as the other does.
    NeighborGrid(const Positions& positions, const GridLayout& whole, const NeighborFilter& filter,
                 int threads);
    NeighborGrid(NeighborGrid&&) noexcept;
    NeighborGrid& operator=(NeighborGrid&&) noexcept;
    ~NeighborGrid();

    /// Number of valid particles. Each has a place in the sorted order, where neighbors are close
    /// in memory.
    [[nodiscard]] std::size_t size() const;

    /// The particle at a place.
    [[nodiscard]] std::uint32_t particle(std::size_t place) const;

    /// Replaces `found` by the neighbors of the particle at a place, in the order of
    /// find_neighbors.
    void find(std::size_t place, FoundNeighbors& found) const;

    /// Replaces `found` by all particles, whatever their phase and own radius, closer than
    /// `radius` (m) to any finite position (m).
    void find_around(const std::array<double, 3>& center, double radius,
                     FoundNeighbors& found) const;

    struct Cells;
    struct Levels;

private:
    friend NeighborLists list_neighbors(const NeighborGrid&, std::size_t, const SupportRadii&,
                                        std::size_t, int);

    std::unique_ptr<Levels> levels;
};

/// Radii that differ by more than this factor are refused: nobody simulates that, and the usual
/// cause is a damaged value or another unit.
inline constexpr double max_radius_range = 1000;

/// The neighbors of each particle at a distance strictly below its radius (m), or where radii vary,
/// below the mean of the pair's. `threads` 0 takes all cores; the result does not depend on it.
/// Throws InputError where a radius is not positive and finite or its square would leave the range
/// of double (below 1e-150, above 1e150), where a valid particle's position is not finite, where
/// there are more than 2^32 - 1 particles, or where the extent exceeds what double can resolve
/// against the radius (2^50 radii). Where radii vary, also where there is not one for each
/// particle, where they differ by more than max_radius_range, or where the large ones reach
/// over so many particles that a particle would be compared with more than 100,000 others on
/// average. And where there would be more than max_listed_neighbors a particle on average.
NeighborLists find_neighbors(const Positions& positions, const SupportRadii& radii,
                             const NeighborFilter& filter = {}, int threads = 0);

/// The same for a part of a state of that layout, its particles in the order that they have there:
/// of each particle's list in the whole, those that are in the part.
NeighborLists find_neighbors(const Positions& positions, const GridLayout& whole,
                             const NeighborFilter& filter, int threads);

} // namespace meniscus
