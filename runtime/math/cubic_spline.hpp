// The cubic spline of SPH (Monaghan 1992) in q, the distance over the support radius: for sums over
// neighbors one by one, and for vectors of neighbors, where no lane can branch. Without its
// normalization it is 1 at q = 0.
#pragma once

#include "angles.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// What the spline is multiplied by for its integral over the ball (in 2D the disk) to be 1.
template <int Dimension>
inline constexpr double cubic_spline_scale = Dimension == 2 ? 40 / (7 * pi) : 8 / pi;

/// The spline without its normalization; `q` is not negative.
template <class Real>
MENISCUS_HOST_DEVICE MENISCUS_INLINE Real cubic_spline(Real q) {
    if (q >= 1)
        return 0;
    const Real rest = 1 - q;
    return q <= static_cast<Real>(0.5) ? 6 * q * q * (q - 1) + 1 : 2 * rest * rest * rest;
}

/// scale (2 (1 - q)^3 - 8 (1/2 - q)^3) and its derivative by q, where a bracket below zero counts
/// as zero. Number: Real, or a vector of them as compilers have it; a comparison gives a mask.
template <class Real, class Number>
struct CubicSplinePieces {
    Number outer; ///< 1 - q, and
    Number inner; ///< 1/2 - q, at least 0

    MENISCUS_INLINE explicit CubicSplinePieces(const Number& q)
        : outer(positive(Real(1) - q)), inner(positive(Real(0.5) - q)) {}

    [[nodiscard]] MENISCUS_INLINE Number value(Real scale) const {
        return (2 * scale) * (outer * outer * outer) - (8 * scale) * (inner * inner * inner);
    }
    [[nodiscard]] MENISCUS_INLINE Number slope(Real scale) const {
        return (24 * scale) * (inner * inner) - (6 * scale) * (outer * outer);
    }

private:
    static MENISCUS_INLINE Number positive(const Number& a) { return a > Number{} ? a : Number{}; }
};

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
