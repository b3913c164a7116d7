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

#include "blocks_and_caps.hpp"

#include <meniscus/runtime/simd/dispatch.hpp>

namespace meniscus {

/// Sorts directions into compact blocks. For a table that serves many particles.
DirectionBlocks compact_blocks(std::vector<Direction> directions);

/// Takes directions as they come: no block is ever dismissed whole. For directions that serve one
/// particle. Refills `blocks`, which keeps its memory.
void plain_blocks(const std::vector<Direction>& directions, DirectionBlocks& blocks);

/// Number of directions that no cap covers. `caps.displacements` and `caps.radius_ratio` are set by
/// the caller; the rest of `caps` is working memory. By the widest instruction set of this machine,
/// up to `widest`.
std::size_t count_uncovered(const DirectionBlocks& blocks, Caps& caps,
                            InstructionSet widest = widest_instruction_set);

/// The same count straight from the definition, one direction and one neighbor at a time in double,
/// in the order given: the oracle of the tests and the baseline of the benchmark.
std::size_t count_uncovered_reference(const std::vector<Direction>& directions,
                                      const std::vector<Direction>& displacements,
                                      double radius_ratio);

} // namespace meniscus
