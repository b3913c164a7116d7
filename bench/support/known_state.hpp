// Clouds of data/ as states: what is measured on them can be held against normals, curvatures and
// depths that are known. All are in support radii (h = 1), as a rule with h = 2 spacings as
// SPlisHSPlasH has it.
#pragma once

#include "fluid_state.hpp"

#include <meniscus/data/clouds/clouds.hpp>

namespace meniscus {

/// Support radius over particle spacing.
inline constexpr double known_spacing_ratio = 2;

/// Particles are in the same order in both.
template <class Real>
struct KnownState {
    Cloud cloud;
    FluidState<Real> state;
};

/// A cloud of h = 1 with that many spacings in it; relaxed, seed 1.
CloudOptions known_cloud(double jitter = 0, double spacing_ratio = known_spacing_ratio);

/// Real is float or double. Throws as fill() does.
template <class Real>
KnownState<Real> known_state(const std::string& name, const Shape& shape,
                             const CloudOptions& options = known_cloud());

/// Whether the particle belongs to the outermost layer, where normals and forces are measured, and
/// nothing near it is cut off.
bool is_outermost(const Cloud& cloud, std::size_t i);

} // namespace meniscus
