// How many spacings the support radius has, told by how close particles come to each other. Unlike
// the volumes (particle_volumes.hpp) it needs no neighbors within the radius, and so tells a radius
// that is far off.
#pragma once

#include "snapshot.hpp"
#include "support_radii.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace meniscus {

/// Ratios that kernels of SPH have in use, with room to both sides.
inline constexpr std::array<double, 2> plausible_spacing_ratios = {1.6, 5};

/// The support radius over the distance to the nearest particle, which nine of ten valid particles
/// exceed; infinite where particles lie in one place. Some thousand particles are looked at.
/// Nothing where there are fewer than two.
std::optional<double> nearest_spacing_ratio(const Snapshot& snapshot, const SupportRadii& radii,
                                            const std::vector<std::uint8_t>& valid);

/// A sentence for whoever gave the support radius where the ratio is implausible; else empty, as
/// for states of few particles.
std::string doubtful_support_radius(const Snapshot& snapshot, const SupportRadii& radii,
                                    const std::vector<std::uint8_t>& valid);

} // namespace meniscus
