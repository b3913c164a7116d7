// Drops of R = 0.5 m without gravity, in the units that their surface tension gives: the capillary
// time sqrt(rho R^3 / sigma) and speed sqrt(sigma / (rho R)).
#pragma once

#include "scene_runs.hpp"

#include <cmath>

namespace meniscus {

/// Of the ball (in 2D the disk) of as much volume as the scene's particles have, m.
double volume_radius(const Scene& scene, std::size_t particles);

inline double capillary_speed(const Scene& scene, double radius) {
    return std::sqrt(scene.surface_tension.coefficient / (scene.rest_density * radius));
}

/// From when on a run is looked at: its last fifth, s.
inline double last_fifth(const Scene& scene) {
    return 0.8 * scene.duration;
}

} // namespace meniscus
