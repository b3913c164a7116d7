// What a number type can hold. Far from the origin the numbers of a type lie far apart: at 1e6
// support radii a float coordinate moves in steps of 1/16 of a radius, and what it says of
// directions between neighbors is wrong, though every number is finite. And a radius whose square
// leaves the range of the type makes every distance 0 or infinite. Both look like a fluid without
// neighbors, all surface; so whoever takes positions from outside asks here first.
#pragma once

#include "neighborhood.hpp"
#include "support_radius.hpp"

#include <cmath>
#include <limits>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// Steps between coordinates, in support radii, from which on positions are refused: a neighbor at
/// h / 2 may then stand 6 degrees off where it was, as much as separates covered from uncovered on
/// a lattice.
inline constexpr double coarsest_position_step = 1.0 / 32;

/// Steps above which labels are doubtful: particles with lambda below about as much may be either,
/// and so may neighbors that stand at the support radius.
inline constexpr double doubtful_position_step = 1e-4;

/// The distance between two numbers of a type with so many digits of mantissa, where a finite
/// coordinate (m) lies. The difference of two coordinates may be off by as much.
inline double position_step(double coordinate, int mantissa_digits) {
    int exponent = 0;
    std::frexp(coordinate, &exponent);
    return coordinate == 0 ? 0 : std::ldexp(1, exponent - mantissa_digits);
}

/// The largest of the steps along each axis of a finite position, over its support radius, which
/// is positive.
template <class Position>
double position_step(const Position& position, int dimension, double support_radius,
                     int mantissa_digits) {
    double max = 0;
    for (int axis = 0; axis < dimension; ++axis) {
        const double step =
            position_step(static_cast<double>(position[axis]), mantissa_digits) / support_radius;
        max = step > max ? step : max;
    }
    return max;
}

/// The support radii (m) that a step can calculate with in Real: their squares, and those of their
/// parts, keep all digits.
template <class Real>
inline constexpr double min_support_radius = std::is_same_v<Real, float> ? 1e-16 : 1e-150;
template <class Real>
inline constexpr double max_support_radius = 1 / min_support_radius<Real>;

/// True for radii in that range.
template <class Real>
bool is_usable_radius(double radius) {
    return is_positive_and_finite(radius) && radius >= min_support_radius<Real> &&
           radius <= max_support_radius<Real>;
}

/// How much larger the largest support radius of a fluid may be than the smallest: what lies around
/// a particle, in radii of another, then keeps all digits, too.
inline constexpr double max_radius_contrast = 1e6;

/// The smallest and the largest support radius. Where one is not positive, or not a number, so is
/// the largest.
template <class Real>
struct RadiusExtent {
    Real min, max;
};

template <class Real>
RadiusExtent<Real> extent_of(const UniformRadius<Real>& radii, std::size_t /*count*/) {
    return {radii.radius, radii.radius};
}

/// By bits: those of negative numbers and of what is none are the largest. `count` at least 1.
template <class Real>
RadiusExtent<Real> extent_of(const VaryingRadii<Real>& radii, std::size_t count) {
    auto min = bits_of(radii.of(0));
    auto max = min;
    for (std::size_t i = 1; i < count; ++i) {
        const auto bits = bits_of(radii.of(i));
        min = bits < min ? bits : min;
        max = bits > max ? bits : max;
    }
    RadiusExtent<Real> extent;
    std::memcpy(&extent.min, &min, sizeof min);
    std::memcpy(&extent.max, &max, sizeof max);
    return extent;
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
