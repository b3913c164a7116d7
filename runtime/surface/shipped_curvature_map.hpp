// The map of curvature that comes with the project (curvature_map.hpp).
#pragma once

#include "../coefficients/curvature_2d.hpp"
#include "../coefficients/curvature_3d.hpp"
#include "curvature_map.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// The map for 2 or 3 dimensions.
constexpr CurvatureMap shipped_curvature_map(int dimension) {
    return dimension == 2 ? curvature_map<Curvature2D>() : curvature_map<Curvature3D>();
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
