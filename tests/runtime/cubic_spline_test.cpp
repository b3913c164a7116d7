#include <meniscus/runtime/math/cubic_spline.hpp>

#include <gtest/gtest.h>

namespace meniscus {
namespace {

/// As Monaghan 1992 prints it, but for a radius of 1 in place of 2; not normalized.
double plain_spline(double q) {
    const double r = 2 * q;
    if (r > 2)
        return 0;
    return r < 1 ? 1 - 1.5 * r * r + 0.75 * r * r * r : 0.25 * (2 - r) * (2 - r) * (2 - r);
}

TEST(CubicSpline, IsThePublishedOne) {
    for (int n = 0; n <= 1500; ++n)
        EXPECT_NEAR(cubic_spline(n / 1000.0), plain_spline(n / 1000.0), 1e-14) << n;
}

TEST(CubicSpline, IntegratesToOneWithItsScale) {
    constexpr int steps = 10000;
    double disk = 0;
    double ball = 0;
    for (int n = 0; n < steps; ++n) {
        const double q = (n + 0.5) / steps;
        disk += cubic_spline(q) * 2 * pi * q / steps;
        ball += cubic_spline(q) * 4 * pi * q * q / steps;
    }
    EXPECT_NEAR(cubic_spline_scale<2> * disk, 1, 1e-7);
    EXPECT_NEAR(cubic_spline_scale<3> * ball, 1, 1e-7);
}

TEST(CubicSpline, HasTheSameValueInVectorsAndTheSlopeThatBelongsToIt) {
    using Vector = double __attribute__((vector_size(16)));
    using Pieces = CubicSplinePieces<double, Vector>;
    constexpr double step = 1e-6;
    for (double q = 0.01; q < 1.2; q += 0.0123) {
        const Vector at = {q, q + step};
        const Vector value = Pieces(at).value(3);
        EXPECT_NEAR(value[0], 3 * cubic_spline(q), 1e-14);
        EXPECT_NEAR(value[1], 3 * cubic_spline(q + step), 1e-14);
        const double middle = Pieces(at + step / 2 - Vector{0, step}).slope(3)[0];
        EXPECT_NEAR(middle, (value[1] - value[0]) / step, 1e-8) << q;
    }
}

} // namespace
} // namespace meniscus
