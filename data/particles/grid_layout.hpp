// The cells of a neighbor search, told from the extent of a state alone: whoever works on a part of
// the state lays the same cells, and finds neighbors in the same order as on the whole.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

namespace meniscus {

/// How many particles there are, and between which corners (m).
struct ParticleExtent {
    std::uint64_t count = 0;
    std::array<double, 3> low{std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::infinity()};
    std::array<double, 3> high{-std::numeric_limits<double>::infinity(),
                               -std::numeric_limits<double>::infinity(),
                               -std::numeric_limits<double>::infinity()};

    /// Adds a particle at a finite position.
    void add(const std::array<double, 3>& position);
};

/// Where the cells of a state lie and how they are numbered, which decides the order of neighbors.
struct GridLayout {
    double radius = 0;              ///< m
    std::array<double, 3> origin{}; ///< m
    double inverse_cell_size = 0;   ///< 1/m; 0 where there is no particle
    std::array<std::int64_t, 3> cells{1, 1, 1};
    bool direct = true;            ///< a bucket is a cell; else cells share buckets
    std::uint64_t bucket_mask = 0; ///< number of shared buckets, less one
};

/// The layout of a state of that extent and one support radius (m). Throws InputError where the
/// extent exceeds what double can resolve against the radius (2^50 radii).
GridLayout grid_layout(double radius, const ParticleExtent& extent);

/// A coordinate (m) in cells, as a real number.
inline double scaled_coordinate(const GridLayout& layout, const std::array<double, 3>& position,
                                int axis) {
    return (position[axis] - layout.origin[axis]) * layout.inverse_cell_size;
}

/// The layer of cells along an axis that a position of the state lies in. Neighbors lie in the same
/// layer or in the one beside it.
std::int64_t layer_of(const GridLayout& layout, const std::array<double, 3>& position, int axis);

} // namespace meniscus
