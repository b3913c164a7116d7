// The features that a line could be drawn in (runtime/features/list.hpp), any two of them by one
// pass over given lists.
#pragma once

#include "support/fluid_state.hpp"

#include <meniscus/runtime/features/list.hpp>

#include <array>

namespace meniscus {

/// One entry a particle, by place in the list. Those that are sums over a kernel are multiplied by
/// the volume that a particle stands for over h^D, which a solver knows.
using FeatureArrays = std::array<std::vector<float>, feature_count>;

/// Sets the arrays of both features (which may be the same one), in one pass; other arrays stay as
/// they are.
void find_features(const FluidState<float>& state, const FeaturePair& features,
                   FeatureArrays& arrays);

/// Sets all of them.
FeatureArrays all_features(const FluidState<float>& state);

} // namespace meniscus
