// The map of curvature that comes with the project (curvature_map.hpp).
#pragma once

#include "curvature_coefficients.hpp"
#include "curvature_coefficients_2d.hpp"
#include "curvature_map.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// The map for 2 or 3 dimensions.
constexpr CurvatureMap shipped_curvature_map(int dimension) {
    return dimension == 2 ? curvature_map<CurvatureCoefficients2D>()
                          : curvature_map<CurvatureCoefficients>();
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
