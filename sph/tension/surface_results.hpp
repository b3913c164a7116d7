// The surface as a surface-tension model, or what restricts its forces to the surface, found it.
#pragma once

#include <meniscus/sph/scene/scene.hpp>

#include <cstdint>
#include <vector>

namespace meniscus {

/// One entry a particle; empty where the model knows no surface.
struct SurfaceResults {
    std::vector<std::uint8_t> surface_class; ///< 0 interior, 1 covered, 2 surface
    std::vector<double> curvature;           ///< mean curvature, 1/m
    std::vector<Place> normal;               ///< unit vectors out of the fluid, or zero
    double area = 0;                         ///< of the surface, m^2 (in 2D m)
};

} // namespace meniscus
