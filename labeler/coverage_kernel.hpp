// The inner loop of coverage.cpp, compiled once for each instruction set.
#pragma once

#include <cstddef>

namespace meniscus {

struct DirectionBlocks;
struct Caps;

/// Arrays of caps are padded to this many, the lanes of the widest vectors.
inline constexpr std::size_t kernel_lanes = 16;

/// Bound on the error of a product of two vectors of length at most 1 calculated in float, and of
/// the threshold that it is compared with: each of the three products and two sums errs by at most
/// 2^-24, and so does each of the six inputs.
inline constexpr double kernel_float_error = 1e-6;

/// Number of uncovered directions; `caps` must have been prepared for `blocks`.
std::size_t run_coverage_kernel(const DirectionBlocks& blocks, const Caps& caps);

} // namespace meniscus
