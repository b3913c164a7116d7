// Angles from sums, products, quotients and square roots alone, which every machine rounds alike.
// The C library's sine, cosine and arc tangent differ in their last bit between machines; labels
// and sampling schemes must not.
#pragma once

#include "../simd/instruction_set.hpp"

#include <array>
#include <cmath>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

inline constexpr double pi = 3.14159265358979323846;

/// Arc tangent of z in [0, 1], within 2e-16: taken from the nearest quarter, where what is left is
/// at most 1/8 and nine terms of the series do.
MENISCUS_HOST_DEVICE inline double arctangent_to_one(double z) {
    constexpr double of_quarters[] = {0, 0.24497866312686415417, 0.46364760900080611621,
                                      0.64350110879328438680, 0.78539816339744830962};
    const int quarter = static_cast<int>(z * 4 + 0.5); // NOLINT: rounds well, z is not negative
    const double nearest = quarter * 0.25;
    const double rest = (z - nearest) / (1 + z * nearest);
    const double square = rest * rest;
    double series = 0;
    for (int order = 17; order >= 1; order -= 2)
        series = 1.0 / order - square * series;
    return of_quarters[quarter] + rest * series;
}

/// Angle of the point (x, y) from the x axis, in [-pi, pi]; 0 at the origin.
MENISCUS_HOST_DEVICE inline double arctangent(double y, double x) {
    const double across = std::fabs(y);
    const double along = std::fabs(x);
    double angle = 0;
    if (across > along)
        angle = pi / 2 - arctangent_to_one(along / across);
    else if (along > 0)
        angle = arctangent_to_one(across / along);
    if (x < 0)
        angle = pi - angle;
    return y < 0 ? -angle : angle;
}

/// Sine and cosine of 2 pi times `turn` in [0, 1). The C library's differ in the last bit between
/// machines; a Taylor series within an eighth of a turn does not, and is as exact.
MENISCUS_HOST_DEVICE inline std::array<double, 2> cosine_and_sine_of_turn(double turn) {
    const auto octant = static_cast<int>(turn * 8);
    // Even octants count up from their start, odd ones down from their end.
    const double part = octant % 2 == 0 ? turn - octant / 8.0 : (octant + 1) / 8.0 - turn;
    const double angle = 2 * pi * part;
    const double square = angle * angle;
    double cosine = 1;
    double sine = 1;
    for (int order = 18; order >= 2; order -= 2) {
        cosine = 1 - cosine * square / (order * (order - 1));
        sine = 1 - sine * square / (order * (order + 1));
    }
    sine *= angle;
    switch (octant) {
    case 0:
        return {cosine, sine};
    case 1:
        return {sine, cosine};
    case 2:
        return {-sine, cosine};
    case 3:
        return {-cosine, sine};
    case 4:
        return {-cosine, -sine};
    case 5:
        return {-sine, -cosine};
    case 6:
        return {sine, -cosine};
    default:
        return {cosine, -sine};
    }
}

/// A number that grows with the angle of (x, y), from -2 to 2 as the angle goes from -pi to pi, and
/// is 2 apart for opposite points. For putting points on a circle in order without an arc tangent,
/// and without a branch. Any number in that range where both are 0.
inline double turn_order(double x, double y) {
    return std::copysign(1 - x / (std::fabs(x) + std::fabs(y) + 1e-300), y);
}

/// The unit vector at a turn_order, which may be up to a turn beyond 2.
inline std::array<double, 3> unit_vector(double turn) {
    turn -= turn < 2 ? 0 : 4;
    const double x = 1 - std::fabs(turn);
    const double y = std::copysign(1 - std::fabs(x), turn);
    const double scale = 1 / std::sqrt(x * x + y * y);
    return {x * scale, y * scale, 0};
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
