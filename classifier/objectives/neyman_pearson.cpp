#include "neyman_pearson.hpp"

#include "shift.hpp"

#include <meniscus/data/text/errors.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace meniscus {
namespace {

/// A particle in the plane of features.
struct Point {
    double x;
    double y;
};

/// The plane, or a reflection of it, so that surface lies below a line of slope 0 to max_slope.
struct Plane {
    const std::vector<LabelledState>& states;
    double label_threshold;
    double x_sign;
    double y_sign;
    double max_slope;
    double x_margin; ///< bounds of what float adds to a feature
    double y_margin;

    Plane(const std::vector<LabelledState>& all, double threshold, double sign_of_x,
          double sign_of_y)
        : states(all), label_threshold(threshold), x_sign(sign_of_x), y_sign(sign_of_y),
          max_slope(meniscus::max_slope(all.front().features)), x_margin(x_feature().float_error),
          y_margin(y_feature().float_error) {}

    [[nodiscard]] const FeatureRow& x_feature() const {
        return feature_list[states.front().features.first];
    }
    [[nodiscard]] const FeatureRow& y_feature() const {
        return feature_list[states.front().features.second];
    }
    [[nodiscard]] Point point(const LabelledState& state, std::size_t i) const {
        return {x_sign * state.x(i), y_sign * state.y(i)};
    }
    [[nodiscard]] bool is_surface(const LabelledState& state, std::size_t i) const {
        return state.uncovered_fraction[i] > label_threshold;
    }
};

/// The part of the surface particles' convex hull on which a line of slope 0 to max_slope rests
/// from above, y falling and x falling from vertex to vertex. The line turns from vertex j to j + 1
/// at slope turns[j].
struct Hull {
    std::vector<Point> vertices;
    std::vector<double> turns;
    std::vector<double> constants; ///< y - k x of the line at turns[j]
};

/// The surface particles with neighbors, y falling, x rising where y is the same.
std::vector<Point> surface_points(const Plane& plane) {
    std::vector<Point> points;
    for (const LabelledState& state : plane.states)
        for (std::size_t i = 0; i < state.size(); ++i)
            if (plane.is_surface(state, i) && state.concerns_line(i))
                points.push_back(plane.point(state, i));
    if (points.empty())
        throw InputError("no surface particle has neighbors, so nothing holds the line; give other "
                         "files or a lower --label-threshold");
    std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) {
        return a.y > b.y || (a.y == b.y && a.x < b.x);
    });
    return points;
}

/// Slope at which lines of equal height through both points coincide; b lies left of a and below.
double turning_slope(const Point& a, const Point& b) {
    return (a.y - b.y) / (a.x - b.x);
}

/// `points` as surface_points() has them.
Hull upper_hull(const std::vector<Point>& points, double max_slope) {
    Hull hull;
    for (const Point& point : points) {
        if (!hull.vertices.empty() && point.x >= hull.vertices.back().x)
            continue;
        while (!hull.turns.empty() &&
               turning_slope(hull.vertices.back(), point) <= hull.turns.back()) {
            hull.vertices.pop_back();
            hull.turns.pop_back();
        }
        if (!hull.vertices.empty())
            hull.turns.push_back(turning_slope(hull.vertices.back(), point));
        hull.vertices.push_back(point);
    }
    while (!hull.turns.empty() && hull.turns.back() >= max_slope) {
        hull.vertices.pop_back();
        hull.turns.pop_back();
    }
    for (std::size_t j = 0; j < hull.turns.size(); ++j)
        hull.constants.push_back(hull.vertices[j].y - hull.turns[j] * hull.vertices[j].x);
    return hull;
}

/// The first index in [begin, end) from which on `holds` is true, else end.
template <class Predicate>
std::size_t first_index(std::size_t begin, std::size_t end, const Predicate& holds) {
    while (begin < end) {
        const std::size_t middle = begin + (end - begin) / 2;
        if (holds(middle))
            end = middle;
        else
            begin = middle + 1;
    }
    return begin;
}

/// The open interval of slopes at which a particle is told apart from all surface particles; empty
/// where begin >= end.
struct SlopeInterval {
    double begin = 0;
    double end = 0;
};

/// How far a particle lies below the line of slope k that rests on the hull (its depth) is a convex
/// function of k: it falls while the line rests on vertices right of the particle and rises
/// afterwards. The particle is told apart where its depth is negative, between at most two roots.
SlopeInterval told_apart(const Plane& plane, const Hull& hull, const Point& particle) {
    const auto& vertices = hull.vertices;
    const std::size_t turns = hull.turns.size();
    // d has its margin on top; moving the particle by it has the same effect.
    const Point p = {particle.x + plane.x_margin, particle.y - plane.y_margin};
    const auto depth_at_turn = [&](std::size_t j) {
        return hull.constants[j] + hull.turns[j] * p.x - p.y;
    };
    const auto root = [&](std::size_t j) { return (p.y - vertices[j].y) / (p.x - vertices[j].x); };
    const std::size_t rising =
        first_index(0, vertices.size(), [&](std::size_t j) { return vertices[j].x <= p.x; });
    SlopeInterval interval{0, plane.max_slope};
    if (p.y <= vertices[0].y) {
        const std::size_t entry = first_index(0, std::min(rising, turns),
                                              [&](std::size_t j) { return depth_at_turn(j) < 0; });
        if (entry == rising)
            return {};
        interval.begin = root(entry);
    }
    const std::size_t exit = first_index(std::min(rising, turns), turns,
                                         [&](std::size_t j) { return depth_at_turn(j) >= 0; });
    if (vertices[exit].x < p.x)
        interval.end = std::min(plane.max_slope, root(exit));
    return interval;
}

/// A slope at which a particle begins (positive weight) or ceases to be told apart.
struct Event {
    double k;
    std::int64_t weight;
};

struct Sweep {
    std::vector<Event> events;
    std::int64_t weight_at_zero = 0; ///< of the particles that are told apart at k = 0
};

/// What a particle of each state weighs, in units so small that the weights of all particles of all
/// scenes fit an integer: then the sum is the same in every order.
std::vector<std::int64_t> particle_weights(const std::vector<LabelledState>& states) {
    const SceneGroups groups = group_by_scene(states);
    std::vector<double> particles(groups.names.size());
    for (std::size_t s = 0; s < states.size(); ++s)
        particles[groups.of_state[s]] += static_cast<double>(states[s].size());
    const double scene_weight = std::ldexp(1.0, 62) / static_cast<double>(groups.names.size());
    std::vector<std::int64_t> weights;
    for (std::size_t s = 0; s < states.size(); ++s)
        weights.push_back(
            std::llround(scene_weight / std::max(1.0, particles[groups.of_state[s]])));
    return weights;
}

/// `weights`: of a particle of each state.
Sweep collect_events(const Plane& plane, const std::vector<std::int64_t>& weights,
                     const Hull& hull) {
    Sweep sweep;
    for (std::size_t s = 0; s < plane.states.size(); ++s) {
        const LabelledState& state = plane.states[s];
        for (std::size_t i = 0; i < state.size(); ++i) {
            if (plane.is_surface(state, i) || !state.concerns_line(i))
                continue;
            const SlopeInterval interval = told_apart(plane, hull, plane.point(state, i));
            if (interval.begin >= interval.end)
                continue;
            if (interval.begin == 0)
                sweep.weight_at_zero += weights[s];
            else
                sweep.events.push_back({interval.begin, weights[s]});
            if (interval.end < plane.max_slope)
                sweep.events.push_back({interval.end, -weights[s]});
        }
    }
    return sweep;
}

/// A slope in the middle of the widest of the best intervals between events.
struct Choice {
    std::int64_t weight = -1; ///< told apart
    double begin = 0;         ///< of the interval, as an angle
    double width = 0;

    [[nodiscard]] double slope(double unit) const { return std::tan(begin + width / 2) * unit; }
};

Choice best_slope(Sweep& sweep, double max_slope, double slope_unit) {
    // Between events closer than this, rounding decides which particles are told apart.
    constexpr double narrowest = 1e-10;
    auto& events = sweep.events;
    std::sort(events.begin(), events.end(),
              [](const Event& a, const Event& b) { return a.k < b.k; });
    std::int64_t weight = sweep.weight_at_zero;
    Choice best;
    double begin = 0;
    for (std::size_t e = 0; e <= events.size(); ++e) {
        const double end = std::atan((e < events.size() ? events[e].k : max_slope) / slope_unit);
        const double width = end - begin;
        if (width > narrowest &&
            (weight > best.weight || (weight == best.weight && width > best.width)))
            best = {weight, begin, width};
        begin = end;
        if (e < events.size())
            weight += events[e].weight;
    }
    return best;
}

/// What a feature spans: one where it is a fraction, else as far as the surface particles reach.
double span(const FeatureRow& feature, const std::vector<Point>& points, double Point::*member) {
    if (feature.is_fraction)
        return 1;
    double max = 0;
    for (const Point& point : points)
        max = std::max(max, std::abs(point.*member));
    return max > 0 ? max : 1;
}

void check_interior(const std::vector<LabelledState>& states, double label_threshold) {
    for (const LabelledState& state : states)
        for (const double lambda : state.uncovered_fraction)
            if (lambda <= label_threshold)
                return;
    throw InputError("no interior particle to train on; give other files or a higher "
                     "--label-threshold");
}

} // namespace

double max_slope(const FeaturePair& features) {
    return 1 / feature_list[features.first].float_error;
}

Line min_false_positives(const std::vector<LabelledState>& states, double label_threshold) {
    const bool any_side = !is_of_paper(states.front().features);
    const auto weights = particle_weights(states);
    Choice best;
    double k = 0;
    bool above = false;
    for (const auto [x_sign, y_sign] :
         {std::array{1.0, 1.0}, {-1.0, 1.0}, {1.0, -1.0}, {-1.0, -1.0}}) {
        const Plane plane(states, label_threshold, x_sign, y_sign);
        const auto points = surface_points(plane);
        check_interior(states, label_threshold);
        const Hull hull = upper_hull(points, plane.max_slope);
        Sweep sweep = collect_events(plane, weights, hull);
        const double unit =
            span(plane.y_feature(), points, &Point::y) / span(plane.x_feature(), points, &Point::x);
        const Choice choice = best_slope(sweep, plane.max_slope, unit);
        if (choice.weight > best.weight ||
            (choice.weight == best.weight && choice.width > best.width)) {
            best = choice;
            k = x_sign * y_sign * choice.slope(unit);
            above = y_sign < 0;
        }
        if (!any_side)
            break;
    }
    return shift_line(states, label_threshold, k, above);
}

} // namespace meniscus
