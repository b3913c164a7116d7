// Smoothing kernels, in units of the support radius h: they end at distance 1 and their integral
// over the ball (in 2D the disk) of radius 1 is 1. In SI units a value is divided by h^D, and a
// gradient once more by h. Each has
//     value(q^2)             W
//     gradient(q^2)          W'(q) / q, so that the gradient with respect to x_i is that times
//                            x_i - x_j; 0 beyond the support, and finite where two particles meet
// for one number or eight lanes of them.
#pragma once

#include "rows.hpp"

#include <meniscus/runtime/math/cubic_spline.hpp>
#include <meniscus/sph/scene/scene.hpp>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// Below this distance, in support radii, a pair counts as in one place.
inline constexpr double min_distance = 1e-6;

/// The cubic spline (Monaghan 1992).
template <class Real, int Dimension>
struct CubicSpline {
    static constexpr Real sigma = static_cast<Real>(cubic_spline_scale<Dimension>);

    MENISCUS_INLINE Lanes<Real> value(Lanes<Real> distance_squared) const {
        const Lanes<Real> q = square_root(distance_squared);
        return CubicSplinePieces<Real, Lanes<Real>>(q).value(sigma);
    }

    MENISCUS_INLINE Lanes<Real> gradient(Lanes<Real> distance_squared) const {
        const Lanes<Real> q = square_root(distance_squared);
        const Lanes<Real> slope = CubicSplinePieces<Real, Lanes<Real>>(q).slope(sigma);
        return slope / larger(q, all_lanes<Lanes<Real>>(static_cast<Real>(min_distance)));
    }
};

/// The kernels of Mueller et al. 2003, which Huber et al. 2015 use: poly6 for values, the spiky
/// kernel for gradients. In two dimensions the same functions with the constants that make their
/// integrals 1.
template <class Real, int Dimension>
struct MuellerKernels {
    static constexpr Real poly6 = static_cast<Real>(Dimension == 2 ? 4 / pi : 315 / (64 * pi));
    static constexpr Real spiky = static_cast<Real>(Dimension == 2 ? 10 / pi : 15 / pi);

    MENISCUS_INLINE Lanes<Real> value(Lanes<Real> distance_squared) const {
        const Lanes<Real> inside = larger(Real(1) - distance_squared, Lanes<Real>{});
        return poly6 * (inside * inside * inside);
    }

    MENISCUS_INLINE Lanes<Real> gradient(Lanes<Real> distance_squared) const {
        const Lanes<Real> q = square_root(distance_squared);
        const Lanes<Real> zero{};
        const Lanes<Real> inside = larger(Real(1) - q, zero);
        return (-3 * spiky) * (inside * inside) / larger(q, zero + static_cast<Real>(min_distance));
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
