// How many directions on the sphere around a particle no neighbor covers: the Monte Carlo estimate
// of the uncovered fraction lambda (2020 paper, section 3.2, eq. 2). In units of the support radius
// the particle's sphere has radius 1, and the sphere of radius rho (the radius ratio) around a
// neighbor at displacement x covers the cap of directions p with |p - x| < rho, that is
// p . x > (|x|^2 + 1 - rho^2) / 2.
//
// The fast kernel sorts the directions once into compact blocks. A block that lies inside one cap
// is dismissed whole, one that meets no cap counts whole, and only the rest is tested direction by
// direction, in SIMD lanes picked at run time, against the caps that meet the block, the largest
// first. Lanes calculate in float; what float cannot decide is decided in double, so the count is
// that of the plain scalar reference in double on every machine.
#pragma once

#include "directions.hpp"

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

/// Sorts directions into compact blocks. For a table that serves many particles.
DirectionBlocks compact_blocks(std::vector<Direction> directions);

/// Takes directions as they come: no block is ever dismissed whole. For directions that serve one
/// particle. Refills `blocks`, which keeps its memory.
void plain_blocks(const std::vector<Direction>& directions, DirectionBlocks& blocks);

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

/// Number of directions that no cap covers. `caps.displacements` and `caps.radius_ratio` are set by
/// the caller; the rest of `caps` is working memory.
std::size_t count_uncovered(const DirectionBlocks& blocks, Caps& caps);

/// The same count straight from the definition, one direction and one neighbor at a time in double,
/// in the order given: the oracle of the tests and the baseline of the benchmark.
std::size_t count_uncovered_reference(const std::vector<Direction>& directions,
                                      const std::vector<Direction>& displacements,
                                      double radius_ratio);

/// Name of the instruction set that the kernel runs with on this machine.
const char* coverage_instruction_set();

} // namespace meniscus
