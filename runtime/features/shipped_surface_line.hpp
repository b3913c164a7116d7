// The first line of the classifier that comes with the project for each dimension, for h around 2
// spacings (classifier.hpp). Those for larger radii have headers of their own.
#pragma once

#include "../coefficients/surface_2d.hpp"
#include "../coefficients/surface_3d.hpp"
#include "classifier.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// The first line for 2 or 3 dimensions at a support radius of so many spacings of particles at
/// rest, for hosts that apply it in their density loop; the second follows in the step
/// (surface/shipped_classifier.hpp).
constexpr SurfaceLine<double> shipped_surface_line(int dimension, double spacing_ratio = 2) {
    return dimension == 2 ? surface_line<Surface2D, double>(spacing_ratio)
                          : surface_line<Surface3D, double>(spacing_ratio);
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
