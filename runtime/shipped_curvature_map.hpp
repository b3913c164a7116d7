// The map of curvature that comes with the project (curvature_map.hpp).
#pragma once

#include "curvature_map.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// The map for 2 or 3 dimensions. Until it is trained the turning of the normals as it is.
constexpr CurvatureMap shipped_curvature_map(int dimension) {
    return {dimension, {0, 1, 0, 0, 0, 0}, -1, 1};
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
