// Numbers by which scenes are filled, which the estimate of their size shares.
#pragma once

namespace meniscus {

inline constexpr double max_particles = 5e8; ///< of fluid, and of walls

/// Between irregular samples of a wall are holes of up to their spacing, through which a fluid
/// would be pressed if that were the particles'.
inline constexpr double irregular_share = 0.7;

} // namespace meniscus
