#include "comparison/half_plane.hpp"

#include <meniscus/data/errors.hpp>
#include <meniscus/runtime/angles.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace meniscus {
namespace {

PlanePoint operator-(const PlanePoint& a, const PlanePoint& b) {
    return {a.x - b.x, a.y - b.y};
}

double cross(const PlanePoint& a, const PlanePoint& b) {
    return a.x * b.y - a.y * b.x;
}

double dot(const PlanePoint& a, const PlanePoint& b) {
    return a.x * b.x + a.y * b.y;
}

/// Lengths along the axes by which the surface particles spread: angles are measured where both are
/// one, so that units do not matter.
struct Spread {
    double x;
    double y;

    [[nodiscard]] PlanePoint scaled(const PlanePoint& point) const {
        return {point.x / x, point.y / y};
    }
};

Spread spread_of_surface(const LabelledPoints& particles) {
    PlanePoint least = {std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
    PlanePoint most = {-least.x, -least.y};
    for (std::size_t i = 0; i < particles.points.size(); ++i)
        if (particles.surface[i] != 0) {
            const PlanePoint& point = particles.points[i];
            least = {std::min(least.x, point.x), std::min(least.y, point.y)};
            most = {std::max(most.x, point.x), std::max(most.y, point.y)};
        }
    const Spread spread = {most.x - least.x, most.y - least.y};
    if (!(spread.x > 0 && spread.y > 0))
        throw InputError("the surface particles do not span a plane of features, so no line rests "
                         "on them; give more files");
    return spread;
}

/// Counterclockwise, without points in the middle of an edge (Andrew's monotone chain).
std::vector<PlanePoint> convex_hull(std::vector<PlanePoint> points) {
    std::sort(points.begin(), points.end(), [](const PlanePoint& a, const PlanePoint& b) {
        return a.x < b.x || (a.x == b.x && a.y < b.y);
    });
    std::vector<PlanePoint> hull;
    const auto add = [&](const PlanePoint& point, std::size_t least) {
        while (hull.size() >= least + 2 &&
               cross(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0)
            hull.pop_back();
        hull.push_back(point);
    };
    for (const PlanePoint& point : points)
        add(point, 0);
    const std::size_t lower = hull.size() - 1;
    for (auto point = points.rbegin() + 1; point != points.rend(); ++point)
        add(*point, lower);
    hull.pop_back();
    return hull;
}

/// The open interval of directions, in radians, that tell a particle apart; empty where both ends
/// are the same. `begin` in [0, 2 pi), `end` less than pi beyond it.
struct Arc {
    double begin = 0;
    double end = 0;
};

Arc told_apart(const std::vector<PlanePoint>& hull, const PlanePoint& point) {
    // The edges that the particle sees from outside follow each other; the tangents touch where
    // they begin and end.
    const auto sees = [&](std::size_t k) {
        const PlanePoint& from = hull[k];
        const PlanePoint& to = hull[k + 1 < hull.size() ? k + 1 : 0];
        return cross(to - from, point - from) < 0;
    };
    std::size_t first = hull.size();
    std::size_t behind_last = hull.size();
    bool before = sees(hull.size() - 1);
    for (std::size_t k = 0; k < hull.size(); ++k) {
        const bool now = sees(k);
        if (now && !before)
            first = k;
        if (!now && before)
            behind_last = k;
        before = now;
    }
    if (first == hull.size() || behind_last == hull.size())
        return {};
    const PlanePoint a = hull[first] - point;
    const PlanePoint b = hull[behind_last] - point;
    const double between = std::atan2(cross(b, a), dot(b, a));
    double begin = std::atan2(a.y, a.x) + pi / 2;
    if (begin < 0)
        begin += 2 * pi;
    if (begin >= 2 * pi)
        begin -= 2 * pi;
    return {begin, begin + pi - between};
}

struct Event {
    double angle;
    std::int64_t weight;
};

/// Middle of the widest of the intervals between events where the weight told apart is largest.
double best_angle(std::vector<Event>& events, std::int64_t weight) {
    // Between events closer than this, rounding decides which particles are told apart.
    constexpr double narrowest = 1e-10;
    std::sort(events.begin(), events.end(),
              [](const Event& a, const Event& b) { return a.angle < b.angle; });
    std::int64_t best_weight = -1;
    double best_begin = 0;
    double best_width = 0;
    double begin = 0;
    for (std::size_t e = 0; e <= events.size(); ++e) {
        const double end = e < events.size() ? events[e].angle : 2 * pi;
        const double width = end - begin;
        if (width > narrowest &&
            (weight > best_weight || (weight == best_weight && width > best_width))) {
            best_weight = weight;
            best_begin = begin;
            best_width = width;
        }
        begin = end;
        if (e < events.size())
            weight += events[e].weight;
    }
    return best_begin + best_width / 2;
}

/// The line of that direction that rests on the surface particles.
HalfPlane resting(const LabelledPoints& particles, double x, double y) {
    HalfPlane half = {x, y, -std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < particles.points.size(); ++i)
        if (particles.surface[i] != 0)
            half.limit =
                std::max(half.limit, x * particles.points[i].x + y * particles.points[i].y);
    return half;
}

std::int64_t false_positives(const LabelledPoints& particles, const HalfPlane& half) {
    std::int64_t weight = 0;
    for (std::size_t i = 0; i < particles.points.size(); ++i)
        if (particles.surface[i] == 0 && half.contains(particles.points[i]))
            weight += particles.weight[i];
    return weight;
}

} // namespace

HalfPlane tightest_half_plane(const LabelledPoints& particles) {
    const Spread spread = spread_of_surface(particles);
    std::vector<PlanePoint> surface;
    for (std::size_t i = 0; i < particles.points.size(); ++i)
        if (particles.surface[i] != 0)
            surface.push_back(spread.scaled(particles.points[i]));
    const auto hull = convex_hull(std::move(surface));
    if (hull.size() < 3)
        throw InputError("the surface particles lie on one line of the plane of features; give "
                         "more files");
    std::vector<Event> events;
    std::int64_t weight_at_zero = 0;
    for (std::size_t i = 0; i < particles.points.size(); ++i) {
        if (particles.surface[i] != 0)
            continue;
        const Arc arc = told_apart(hull, spread.scaled(particles.points[i]));
        if (arc.begin == arc.end)
            continue;
        const std::int64_t weight = particles.weight[i];
        events.push_back({arc.begin, weight});
        if (arc.end < 2 * pi) {
            events.push_back({arc.end, -weight});
        } else {
            events.push_back({arc.end - 2 * pi, -weight});
            weight_at_zero += weight;
        }
    }
    const double angle = best_angle(events, weight_at_zero);
    return resting(particles, std::cos(angle) / spread.x, std::sin(angle) / spread.y);
}

HalfPlane tightest_threshold(const LabelledPoints& particles) {
    const HalfPlane below = resting(particles, 1, 0);
    const HalfPlane above = resting(particles, -1, 0);
    return false_positives(particles, below) <= false_positives(particles, above) ? below : above;
}

} // namespace meniscus
