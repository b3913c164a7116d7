// The inner loop of coverage.cpp, compiled for each instruction set.
#pragma once

#include <meniscus/labeler/monte_carlo/blocks_and_caps.hpp>
#include <meniscus/runtime/simd/dispatch.hpp>

namespace meniscus {

/// Arrays of caps are padded to this many, the lanes of the widest vectors.
inline constexpr std::size_t kernel_lanes = 16;

/// Bound on the error of a product of two vectors of length at most 1 calculated in float, and of
/// the threshold that it is compared with: each of the three products and two sums errs by at most
/// 2^-24, and so does each of the six inputs.
inline constexpr double kernel_float_error = 1e-6;

/// Number of uncovered directions; `caps` must have been prepared for `blocks`. `near_places` is
/// working memory for one number a cap.
MENISCUS_KERNEL(std::size_t, count_uncovered_by_kernel, const DirectionBlocks& blocks,
                const Caps& caps, std::uint32_t* near_places);

} // namespace meniscus
