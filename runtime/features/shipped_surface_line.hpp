// The line of the classifier that comes with the project for each dimension, for h = 2 spacings
// (classifier.hpp). Other lines, such as those for h = 2.5 spacings, have headers of their own.
#pragma once

#include "../coefficients/surface_2d.hpp"
#include "../coefficients/surface_3d.hpp"
#include "classifier.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// The line for 2 or 3 dimensions.
constexpr SurfaceLine<double> shipped_surface_line(int dimension) {
    return dimension == 2 ? surface_line<Surface2D, double>() : surface_line<Surface3D, double>();
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
