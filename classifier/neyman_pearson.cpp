#include "neyman_pearson.hpp"

#include <meniscus/data/errors.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace meniscus {
namespace {

/// A particle in the plane of features.
struct Point {
    double x; ///< mass offset
    double y; ///< neighbor count
};

/// The part of the surface particles' convex hull on which a line of slope 0 to largest_slope rests
/// from above, y falling and x falling from vertex to vertex. The line turns from vertex j to j + 1
/// at slope turns[j].
struct Hull {
    std::vector<Point> vertices;
    std::vector<double> turns;
    std::vector<double> constants; ///< y - k x of the line at turns[j]
};

/// For each neighbor count, the surface particle that the line clears last.
std::vector<Point> outermost_surface_particles(const std::vector<LabelledState>& states,
                                               double label_threshold) {
    std::map<double, double, std::greater<>> smallest_offset;
    for (const LabelledState& state : states)
        for (std::size_t i = 0; i < state.size(); ++i)
            if (state.uncovered_fraction[i] > label_threshold && state.neighbor_count[i] != 0) {
                const double x = state.mass_offset[i];
                const auto entry = smallest_offset.try_emplace(state.scaled_count(i), x).first;
                entry->second = std::min(entry->second, x);
            }
    if (smallest_offset.empty())
        throw InputError("no surface particle has neighbors, so nothing holds the line; give other "
                         "files or a lower --label-threshold");
    std::vector<Point> points;
    points.reserve(smallest_offset.size());
    for (const auto& [count, offset] : smallest_offset)
        points.push_back({offset, count});
    return points;
}

/// Slope at which lines of equal height through both points coincide; b lies left of a and below.
double turning_slope(const Point& a, const Point& b) {
    return (a.y - b.y) / (a.x - b.x);
}

/// `points`: y falling.
Hull upper_hull(const std::vector<Point>& points) {
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
    while (!hull.turns.empty() && hull.turns.back() >= largest_slope) {
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
SlopeInterval told_apart(const Hull& hull, const Point& particle) {
    const auto& vertices = hull.vertices;
    const std::size_t turns = hull.turns.size();
    // d has its margin on top; moving the particle by it has the same effect.
    const Point p = {particle.x + margin_per_slope, particle.y - margin_without_slope};
    const auto depth_at_turn = [&](std::size_t j) {
        return hull.constants[j] + hull.turns[j] * p.x - p.y;
    };
    const auto root = [&](std::size_t j) { return (p.y - vertices[j].y) / (p.x - vertices[j].x); };
    const std::size_t rising =
        first_index(0, vertices.size(), [&](std::size_t j) { return vertices[j].x <= p.x; });
    SlopeInterval interval{0, largest_slope};
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
        interval.end = std::min(largest_slope, root(exit));
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

Sweep collect_events(const std::vector<LabelledState>& states, double label_threshold,
                     const Hull& hull) {
    const auto weights = particle_weights(states);
    Sweep sweep;
    std::size_t interior = 0;
    for (const LabelledState& state : states)
        for (const double lambda : state.uncovered_fraction)
            interior += static_cast<std::size_t>(lambda <= label_threshold);
    if (interior == 0)
        throw InputError("no interior particle to train on; give other files or a higher "
                         "--label-threshold");
    sweep.events.reserve(2 * interior);
    for (std::size_t s = 0; s < states.size(); ++s)
        for (std::size_t i = 0; i < states[s].size(); ++i) {
            const double count = states[s].scaled_count(i);
            if (states[s].uncovered_fraction[i] > label_threshold || count == 0)
                continue;
            const SlopeInterval interval = told_apart(hull, {states[s].mass_offset[i], count});
            if (interval.begin >= interval.end)
                continue;
            if (interval.begin == 0)
                sweep.weight_at_zero += weights[s];
            else
                sweep.events.push_back({interval.begin, weights[s]});
            if (interval.end < largest_slope)
                sweep.events.push_back({interval.end, -weights[s]});
        }
    return sweep;
}

/// The slope in the middle of the widest of the best intervals between events.
double best_slope(Sweep& sweep, double slope_unit) {
    // Between events closer than this, rounding decides which particles are told apart.
    constexpr double narrowest = 1e-10;
    auto& events = sweep.events;
    std::sort(events.begin(), events.end(),
              [](const Event& a, const Event& b) { return a.k < b.k; });
    std::int64_t weight = sweep.weight_at_zero;
    std::int64_t best_weight = -1;
    double best_begin = 0;
    double best_width = 0;
    double begin = 0;
    for (std::size_t e = 0; e <= events.size(); ++e) {
        const double end =
            std::atan((e < events.size() ? events[e].k : largest_slope) / slope_unit);
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
    return std::tan(best_begin + best_width / 2) * slope_unit;
}

} // namespace

Line fewest_false_positives(const std::vector<LabelledState>& states, double label_threshold) {
    const Hull hull = upper_hull(outermost_surface_particles(states, label_threshold));
    Sweep sweep = collect_events(states, label_threshold, hull);
    const double k = best_slope(sweep, hull.vertices.front().y);
    return shift_line(states, label_threshold, k);
}

} // namespace meniscus
