// How fast a wave on a jet grows: as cosh(omega t), without viscosity (Rayleigh 1878), with
//     omega^2 = sigma / (rho R^3) kR (1 - (kR)^2) I_1(kR) / I_0(kR)
#pragma once

#include <cmath>

namespace meniscus {

/// omega sqrt(rho R^3 / sigma) of the wave number k times the radius R, between 0 and 1.
inline double rayleigh_rate(double kr) {
    return std::sqrt(kr * (1 - kr * kr) * std::cyl_bessel_i(1, kr) / std::cyl_bessel_i(0, kr));
}

} // namespace meniscus
