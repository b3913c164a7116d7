// The shape of a crown.
#pragma once

#include <meniscus/data/particles/snapshot.hpp>

namespace meniscus {

/// How steep the wall of a crown around the y axis is, degrees: 90 upright, less where it opens
/// upward, more where it closes. That of the least-squares line of the distance from the axis over
/// the height, of the particles above `height`; NaN where these are fewer than two.
double crown_slope(const Positions& positions, double height);

} // namespace meniscus
