// The line of the classifier that comes with the project for each dimension, for h = 2 spacings
// (classifier.hpp). Other lines, such as those for h = 2.5 spacings, have headers of their own.
#pragma once

#include "classifier.hpp"
#include "surface_coefficients.hpp"
#include "surface_coefficients_2d.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// The line for 2 or 3 dimensions.
constexpr SurfaceLine<double> shipped_surface_line(int dimension) {
    return dimension == 2 ? surface_line<SurfaceCoefficients2D, double>()
                          : surface_line<SurfaceCoefficients, double>();
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
