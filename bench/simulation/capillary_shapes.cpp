#include "capillary_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <meniscus/runtime/math/angles.hpp>
#include <stdexcept>
#include <vector>

namespace meniscus {

namespace {

struct ProfilePoint {
    double x = 0, z = 0, angle = 0;
    double volume = 0; ///< between the level point and here; in 2D on both sides
};

/// The equation of a profile.
struct Profile {
    int dimension;
    double first_curvature; ///< of one direction, at the level point
    double capillary_length;

    [[nodiscard]] ProfilePoint slope(const ProfilePoint& at) const {
        const double sine = std::sin(at.angle), cosine = std::cos(at.angle);
        const double pressure =
            (dimension - 1) * first_curvature + at.z / (capillary_length * capillary_length);
        const double around = dimension == 2 ? 0 : at.x > 0 ? sine / at.x : first_curvature;
        const double width = dimension == 2 ? 2 * at.x : pi * at.x * at.x;
        return {cosine, sine, pressure - around, width * sine};
    }
};

ProfilePoint plus(const ProfilePoint& at, double scale, const ProfilePoint& slope) {
    return {at.x + scale * slope.x, at.z + scale * slope.z, at.angle + scale * slope.angle,
            at.volume + scale * slope.volume};
}

/// By Runge and Kutta's fourth order.
ProfilePoint advanced(const Profile& profile, const ProfilePoint& at, double step) {
    const ProfilePoint first = profile.slope(at);
    const ProfilePoint second = profile.slope(plus(at, step / 2, first));
    const ProfilePoint third = profile.slope(plus(at, step / 2, second));
    const ProfilePoint fourth = profile.slope(plus(at, step, third));
    ProfilePoint next = plus(at, step / 6, first);
    next = plus(next, step / 3, second);
    next = plus(next, step / 3, third);
    return plus(next, step / 6, fourth);
}

/// Points from the level one on, until `value` of one is at least `limit`: the last has just it,
/// unless the profile is still about level after so many points.
template <class Value>
std::vector<ProfilePoint> points_until(const Profile& profile, double step, double limit,
                                       const Value& value) {
    constexpr int max_points = 40000;
    std::vector<ProfilePoint> points(1);
    for (int n = 0; n < max_points; ++n) {
        const ProfilePoint next = advanced(profile, points.back(), step);
        if (value(next) >= limit) {
            const double before = value(points.back());
            points.push_back(
                advanced(profile, points.back(), step * (limit - before) / (value(next) - before)));
            break;
        }
        points.push_back(next);
    }
    return points;
}

void require(bool is_right) {
    if (!is_right)
        throw std::invalid_argument("capillary shape: an angle between 0 and pi and lengths above "
                                    "0 were expected");
}

/// Where `is_above` turns from false to true, between two values of which the first is below;
/// halves the interval of logarithms.
template <class IsAbove>
double first_above(double low, double high, const IsAbove& is_above) {
    for (int n = 0; n < 100; ++n) {
        const double middle = std::sqrt(low * high);
        (is_above(middle) ? high : low) = middle;
    }
    return high;
}

} // namespace

SessileDrop sessile_drop(int dimension, double contact_angle, double capillary_length,
                         double volume) {
    require(contact_angle > 0 && contact_angle < pi && capillary_length > 0 && volume > 0);
    const double size = std::pow(volume, 1.0 / dimension);
    const auto profile_of = [&](double curvature) {
        return points_until({dimension, curvature, capillary_length}, size / 2000, contact_angle,
                            [](const ProfilePoint& at) { return at.angle; });
    };
    const double curvature = first_above(1e-9 / size, 1e3 / size, [&](double guess) {
        const ProfilePoint last = profile_of(guess).back();
        return last.angle > contact_angle / 2 && last.volume < volume;
    });
    const std::vector<ProfilePoint> points = profile_of(curvature);
    const auto widest =
        std::max_element(points.begin(), points.end(),
                         [](const ProfilePoint& a, const ProfilePoint& b) { return a.x < b.x; });
    return {points.back().z, points.back().x, widest->x};
}

PlateMeniscus plate_meniscus(double contact_angle, double capillary_length, double gap,
                             double from_plate) {
    require(contact_angle > 0 && contact_angle < pi && capillary_length > 0 && gap > 0 &&
            from_plate >= 0 && from_plate < gap / 2);
    const double last_angle = std::abs(pi / 2 - contact_angle);
    if (last_angle == 0)
        return {};
    const auto points_to = [&](double curvature, double x) {
        return points_until(
            {2, curvature, capillary_length}, gap / 4000, x,
            [](const ProfilePoint& at) { return at.angle < pi / 2 ? at.x : 1e300; });
    };
    const double curvature = first_above(1e-9 / gap, 2 / gap, [&](double guess) {
        return points_to(guess, gap / 2).back().angle >= last_angle;
    });
    const double sign = contact_angle < pi / 2 ? 1 : -1;
    return {sign * curvature * capillary_length * capillary_length,
            sign * points_to(curvature, gap / 2 - from_plate).back().z};
}

} // namespace meniscus
