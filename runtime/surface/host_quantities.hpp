// Two numbers that every host needs and has to get right once: how many particle spacings its
// support radius has, and how long a time step may be.
//
// The spacing is that of particles at rest, the root of the volume m / rho_0 that one of them
// stands for, which need not be the distance at which a scene places them. Where the volume is
// given that is settled: SPlisHSPlasH has V = 0.8 (2 r)^3 for particles of radius r that are placed
// 2 r apart, and h = 4 r, so that h is 2.15 spacings at rest, not 2.
#pragma once

#include "../errors.hpp"
#include "../features/line_features.hpp"
#include "../math/angles.hpp"

#include <cmath>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// SurfaceTensionOptions::spacing_ratio for a support radius (m) and the volume m / rho_0 (m^3, in
/// two dimensions m^2) of a particle at rest. Throws std::invalid_argument (errors.hpp) where one
/// is not positive and finite or the dimension is neither 2 nor 3.
inline double spacing_ratio_of(double support_radius, double volume, int dimension) {
    if (dimension != 2 && dimension != 3)
        refuse("dimension must be 2 or 3");
    if (!is_positive_and_finite(support_radius))
        refuse("support_radius must be positive and finite");
    if (!is_positive_and_finite(volume))
        refuse("volume must be positive and finite; it is the mass of a particle over the density "
               "of the fluid at rest");
    return support_radius / (dimension == 2 ? std::sqrt(volume) : std::cbrt(volume));
}

/// The longest time step (s) at which capillary waves of the shortest length that particles can
/// show stay stable, sqrt(rho spacing^3 / (2 pi sigma)) (Brackbill et al. 1992, eq. 61), for sigma
/// in N/m (`surface_tension` of the options, with ForceForm::calibrated), the density of the fluid
/// (kg/m^3) and the spacing of its particles (m). Infinite where sigma is 0. Throws
/// std::invalid_argument where sigma is negative, another is not positive, or one is not finite.
inline double capillary_time_step(double surface_tension, double density, double spacing) {
    if (!is_finite(surface_tension) || surface_tension < 0)
        refuse("surface_tension must be at least 0 and finite");
    if (!is_positive_and_finite(density))
        refuse("density must be positive and finite");
    if (!is_positive_and_finite(spacing))
        refuse("spacing must be positive and finite");
    if (surface_tension == 0)
        return std::numeric_limits<double>::infinity();
    return std::sqrt(density * spacing * spacing * spacing / (2 * pi * surface_tension));
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
