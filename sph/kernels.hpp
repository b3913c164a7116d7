// Smoothing kernels, in units of the support radius h: they end at distance 1 and their integral
// over the ball (in 2D the disk) of radius 1 is 1. In SI units a value is divided by h^D, and a
// gradient once more by h. Each has
//     value(q^2)             W
//     gradient(q^2)          W'(q) / q, so that the gradient with respect to x_i is that times
//                            x_i - x_j; 0 beyond the support, and finite where two particles meet
// for one number or eight lanes of them.
#pragma once

#include "lanes.hpp"
#include "scene.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

inline constexpr double circle_ratio = 3.14159265358979323846;

/// Below this distance, in support radii, a pair counts as in one place.
inline constexpr double least_distance = 1e-6;

/// The cubic spline (Monaghan 1992) with support 1:
/// W = sigma (2 (1 - q)^3 - 8 (1/2 - q)^3), where a bracket below zero counts as zero.
template <class Real, int Dimension>
struct CubicSpline {
    static constexpr Real sigma =
        static_cast<Real>(Dimension == 2 ? 40 / (7 * circle_ratio) : 8 / circle_ratio);

    MENISCUS_INLINE Lanes<Real> value(Lanes<Real> distance_squared) const {
        const Lanes<Real> q = square_root_of<Real>(distance_squared);
        const Lanes<Real> zero{};
        const Lanes<Real> outer = larger_of<Real>(Real(1) - q, zero);
        const Lanes<Real> inner = larger_of<Real>(Real(0.5) - q, zero);
        return (2 * sigma) * (outer * outer * outer) - (8 * sigma) * (inner * inner * inner);
    }

    MENISCUS_INLINE Lanes<Real> gradient(Lanes<Real> distance_squared) const {
        const Lanes<Real> q = square_root_of<Real>(distance_squared);
        const Lanes<Real> zero{};
        const Lanes<Real> outer = larger_of<Real>(Real(1) - q, zero);
        const Lanes<Real> inner = larger_of<Real>(Real(0.5) - q, zero);
        const Lanes<Real> slope = (24 * sigma) * (inner * inner) - (6 * sigma) * (outer * outer);
        return slope / larger_of<Real>(q, zero + static_cast<Real>(least_distance));
    }
};

/// The kernels of Mueller et al. 2003, which Huber et al. 2015 use: poly6 for values, the spiky
/// kernel for gradients. In two dimensions the same functions with the constants that make their
/// integrals 1.
template <class Real, int Dimension>
struct MuellerKernels {
    static constexpr Real poly6 =
        static_cast<Real>(Dimension == 2 ? 4 / circle_ratio : 315 / (64 * circle_ratio));
    static constexpr Real spiky =
        static_cast<Real>(Dimension == 2 ? 10 / circle_ratio : 15 / circle_ratio);

    MENISCUS_INLINE Lanes<Real> value(Lanes<Real> distance_squared) const {
        const Lanes<Real> inside = larger_of<Real>(Real(1) - distance_squared, Lanes<Real>{});
        return poly6 * (inside * inside * inside);
    }

    MENISCUS_INLINE Lanes<Real> gradient(Lanes<Real> distance_squared) const {
        const Lanes<Real> q = square_root_of<Real>(distance_squared);
        const Lanes<Real> zero{};
        const Lanes<Real> inside = larger_of<Real>(Real(1) - q, zero);
        return (-3 * spiky) * (inside * inside) /
               larger_of<Real>(q, zero + static_cast<Real>(least_distance));
    }
};

/// Calls body(kernel) with the one of that kind: a loop inside is compiled for each.
template <class Real, int Dimension, class Body>
MENISCUS_INLINE decltype(auto) with_kernel(KernelKind kind, Body&& body) {
    if (kind == KernelKind::mueller)
        return body(MuellerKernels<Real, Dimension>{});
    return body(CubicSpline<Real, Dimension>{});
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
