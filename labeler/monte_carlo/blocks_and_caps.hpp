// What the Monte Carlo estimate (coverage.hpp) compares: directions in blocks, and the caps that
// the neighbors of a particle cover.
#pragma once

#include <meniscus/labeler/sampling/directions.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace meniscus {

/// Directions sorted into blocks of at most block_size; all blocks but the last are full.
struct DirectionBlocks {
    static constexpr std::size_t block_size = 64;

    std::vector<Direction> directions; ///< in block order
    /// The same in float, one array a coordinate, padded to whole blocks.
    std::vector<float> x, y, z;
    std::vector<Direction> centers; ///< unit vector in the middle of each block
    double cos_radius = -1;         ///< of the largest angle between a center and its directions
    double sin_radius = 0;

    [[nodiscard]] std::size_t size() const { return directions.size(); }
};

/// The caps that the neighbors of one particle cover, prepared for the kernel. Reused from
/// particle to particle without allocation.
struct Caps {
    std::vector<Direction> displacements; ///< in units of the support radius, as given to add_cap
    double radius_ratio = 0.8;

    // Filled by prepare(), the largest cap first, padded to whole vectors with caps that are empty:
    std::vector<Direction> sorted;        ///< displacements in double
    std::vector<double> threshold_double; ///< (|x|^2 + 1 - rho^2) / 2
    std::vector<float> x, y, z, threshold;
    std::vector<float> inner; ///< a block whose center's product exceeds this lies inside the cap
    std::vector<float> outer; ///< a block whose center's product does not exceed this is outside
    std::vector<std::uint32_t> order;
    std::vector<double> cosine; ///< of the angular radius of each given cap
};

} // namespace meniscus
