#include "exact_reference.hpp"

#include <meniscus/runtime/math/vector3.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

namespace meniscus {
namespace {

constexpr double full_turn = 6.28318530717958647692;

struct Cap {
    Vector3 middle;
    double cosine, sine;
};

using Intervals = std::vector<std::pair<double, double>>;

std::vector<Cap> caps_of(const std::vector<Direction>& displacements, double radius_ratio) {
    std::vector<Cap> caps;
    for (const Direction& x : displacements) {
        const double square = dot(x, x);
        const double distance = std::sqrt(square);
        const double cosine = (square + 1 - radius_ratio * radius_ratio) / (2 * distance);
        if (cosine < 1)
            caps.push_back({scaled(1 / distance, x), cosine, std::sqrt(1 - cosine * cosine)});
    }
    return caps;
}

/// What cap `other` covers of the circle of `cap`, as angles in [0, 2 pi]; true where all.
bool add_covered(const Cap& cap, const Cap& other, const Frame& frame, Intervals& covered) {
    const double between = dot(cap.middle, other.middle);
    const double x = dot(other.middle, frame.first);
    const double y = dot(other.middle, frame.second);
    const double cosine =
        (other.cosine - cap.cosine * between) / (cap.sine * std::sqrt(x * x + y * y));
    if (cosine >= 1)
        return false;
    if (cosine <= -1)
        return true;
    const double half = std::acos(cosine);
    double begin = std::atan2(y, x) - half;
    if (begin < 0)
        begin += full_turn;
    covered.emplace_back(begin, std::min(begin + 2 * half, full_turn));
    if (begin + 2 * half > full_turn)
        covered.emplace_back(0, begin + 2 * half - full_turn);
    return false;
}

Vector3 point_at(const Cap& cap, const Frame& frame, double angle) {
    return sum(scaled(cap.cosine, cap.middle),
               sum(scaled(cap.sine * std::cos(angle), frame.first),
                   scaled(cap.sine * std::sin(angle), frame.second)));
}

/// Half the signed area of the triangle of three unit vectors, as the angle of a number (Van
/// Oosterom and Strackee 1983).
std::complex<double> triangle(const Vector3& a, const Vector3& b, const Vector3& c) {
    return {1 + dot(a, b) + dot(b, c) + dot(c, a), dot(a, cross(b, c))};
}

/// Area between the arc and the reference point.
double area_of_arc(const Cap& cap, const Frame& frame, double begin, double end,
                   const Vector3& reference) {
    const Vector3 from = point_at(cap, frame, begin);
    const Vector3 to = point_at(cap, frame, end);
    return (1 - cap.cosine) * (end - begin) - 2 * std::arg(triangle(cap.middle, from, to)) +
           2 * std::arg(triangle(reference, from, to));
}

} // namespace

double uncovered_fraction_reference(const std::vector<Direction>& displacements,
                                    double radius_ratio) {
    const std::vector<Cap> caps = caps_of(displacements, radius_ratio);
    if (caps.empty())
        return 1;
    const Cap& max = *std::min_element(
        caps.begin(), caps.end(), [](const Cap& a, const Cap& b) { return a.cosine < b.cosine; });
    const Vector3 reference = scaled(-1, max.middle);
    double area = 0; // of what is covered, up to whole spheres
    Intervals covered;
    for (const Cap& cap : caps) {
        const Frame frame(cap.middle);
        covered.clear();
        if (std::any_of(caps.begin(), caps.end(), [&](const Cap& other) {
                return &other != &cap && add_covered(cap, other, frame, covered);
            }))
            continue;
        std::sort(covered.begin(), covered.end());
        covered.emplace_back(full_turn, full_turn);
        double open_from = 0;
        for (const auto& [begin, end] : covered) {
            if (begin > open_from)
                area += area_of_arc(cap, frame, open_from, begin, reference);
            open_from = std::max(open_from, end);
        }
    }
    const double fraction = -area / (2 * full_turn);
    const double within = fraction - std::floor(fraction);
    return within > 1 - (1 - max.cosine) / 4 ? 0 : within; // less than nothing by rounding
}

} // namespace meniscus
