// Numbers that tell surface particles from others, each a sum over the neighbors, and any two of
// them by one pass over given lists: what a line could be drawn in.
#pragma once

#include "comparison/fluid_state.hpp"

#include <array>

namespace meniscus {

enum class Feature {
    offset,               ///< the paper's x: |mean of x_j - x_i| over h, of what is counted
    count,                ///< the paper's y: neighbors farther than 0.2 h
    unit_offset,          ///< the same as offset of directions: |mean of (x_j - x_i) / r_ij|
    squared_offset,       ///< the same of |mean of (x_j - x_i) r_ij| over h^2
    density,              ///< sum_j V_j W_ij, the particle itself among j, W the cubic spline
    eigenvalue,           ///< smallest of the renormalization matrix
    divergence,           ///< of position
    direction_eigenvalue, ///< smallest of sum_j (x_j - x_i)(x_j - x_i)^T / r_ij^2
    moment_eigenvalue,    ///< smallest of sum_j (x_j - x_i)(x_j - x_i)^T / h^2
};
inline constexpr std::size_t feature_count = 9;

/// For tables.
const char* feature_name(Feature feature);

/// One entry a particle. 0 where a feature has nothing to be the mean of.
using FeatureArrays = std::array<std::vector<float>, feature_count>;

/// Sets the arrays of both features (which may be the same one), in one pass; other arrays stay as
/// they are.
void find_features(const FluidState<float>& state, Feature a, Feature b, FeatureArrays& features);

/// Sets all of them.
FeatureArrays all_features(const FluidState<float>& state);

} // namespace meniscus
