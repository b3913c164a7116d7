#include "neyman_pearson.hpp"

#include "detail/best_slope.hpp"
#include "shift.hpp"

#include <meniscus/data/ranks/packing.hpp>
#include <meniscus/data/text/errors.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>

namespace meniscus {
namespace {

/// A particle in the plane of features.
struct Point {
    double x;
    double y;
};

/// The plane, or a reflection of it, so that surface lies below a line of slope 0 to max_slope.
struct Plane {
    const Campaign& campaign;
    double label_threshold;
    double x_sign;
    double y_sign;
    FeaturePair features;
    double max_slope;
    double x_margin; ///< bounds of what float adds to a feature
    double y_margin;

    Plane(const Campaign& all, double threshold, double sign_of_x, double sign_of_y)
        : campaign(all), label_threshold(threshold), x_sign(sign_of_x), y_sign(sign_of_y),
          features(all.heads.front().state.features), max_slope(meniscus::max_slope(features)),
          x_margin(x_feature().float_error), y_margin(y_feature().float_error) {}

    [[nodiscard]] const FeatureRow& x_feature() const { return feature_list[features.first]; }
    [[nodiscard]] const FeatureRow& y_feature() const { return feature_list[features.second]; }
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

/// y falling, x rising where y is the same.
void sort_points(std::vector<Point>& points) {
    std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) {
        return a.y > b.y || (a.y == b.y && a.x < b.x);
    });
}

/// Slope at which lines of equal height through both points coincide; b lies left of a and below.
double turning_slope(const Point& a, const Point& b) {
    return (a.y - b.y) / (a.x - b.x);
}

/// The hull of sorted points, whatever the slope.
Hull whole_hull(const std::vector<Point>& points) {
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
    return hull;
}

/// The same up to a slope.
Hull upper_hull(const std::vector<Point>& points, double max_slope) {
    Hull hull = whole_hull(points);
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

/// What the surface particles are to a line: their hull, and how far they reach.
struct SurfacePart {
    std::vector<Point> points; ///< vertices of the hulls of all states
    double reach_x = 0;        ///< largest |x|
    double reach_y = 0;
};

/// The hull of all is that of the hulls of each, so that no more than these is kept.
SurfacePart surface_part(const Plane& plane) {
    SurfacePart part;
    std::vector<double> vertices; // x and y of each
    plane.campaign.visit([&](std::size_t /*place*/, const LabelledState& state) {
        std::vector<Point> points;
        for (std::size_t i = 0; i < state.size(); ++i)
            if (plane.is_surface(state, i) && state.concerns_line(i)) {
                points.push_back(plane.point(state, i));
                part.reach_x = std::max(part.reach_x, std::abs(points.back().x));
                part.reach_y = std::max(part.reach_y, std::abs(points.back().y));
            }
        sort_points(points);
        for (const Point& vertex : whole_hull(points).vertices)
            vertices.insert(vertices.end(), {vertex.x, vertex.y});
    });
    Ranks& ranks = *plane.campaign.ranks;
    for (const std::string& said : gather(ranks, packed(vertices))) {
        const auto all = unpacked<std::vector<double>>(said);
        for (std::size_t n = 0; n < all.size(); n += 2)
            part.points.push_back({all[n], all[n + 1]});
    }
    if (part.points.empty())
        throw InputError("no surface particle has neighbors, so nothing holds the line; give other "
                         "files or a lower --label-threshold");
    sort_points(part.points);
    std::vector<double> reach = {part.reach_x, part.reach_y};
    ranks.max(reach);
    part.reach_x = reach[0];
    part.reach_y = reach[1];
    return part;
}

/// What a particle of each state weighs, in units so small that the weights of all particles of all
/// scenes fit an integer: then the sum is the same in every order.
std::vector<std::int64_t> particle_weights(const Campaign& campaign) {
    const SceneGroups groups = group_by_scene(campaign.states());
    std::vector<double> particles(groups.names.size());
    for (std::size_t s = 0; s < campaign.heads.size(); ++s)
        particles[groups.of_state[s]] += static_cast<double>(campaign.heads[s].particles);
    const double scene_weight = std::ldexp(1.0, 62) / static_cast<double>(groups.names.size());
    std::vector<std::int64_t> weights;
    for (std::size_t s = 0; s < campaign.heads.size(); ++s)
        weights.push_back(
            std::llround(scene_weight / std::max(1.0, particles[groups.of_state[s]])));
    return weights;
}

/// Visits the slopes at which this rank's interior particles begin (positive weight) or cease to be
/// told apart. Returns the weight of those that are told apart at slope 0.
/// `weights`: of a particle of each state.
std::int64_t visit_events(const Plane& plane, const std::vector<std::int64_t>& weights,
                          const Hull& hull, const std::function<void(const SlopeEvent&)>& visit) {
    std::int64_t weight_at_zero = 0;
    plane.campaign.visit([&](std::size_t place, const LabelledState& state) {
        for (std::size_t i = 0; i < state.size(); ++i) {
            if (plane.is_surface(state, i) || !state.concerns_line(i))
                continue;
            const SlopeInterval interval = told_apart(plane, hull, plane.point(state, i));
            if (interval.begin >= interval.end)
                continue;
            if (interval.begin == 0)
                weight_at_zero += weights[place];
            else
                visit({interval.begin, weights[place]});
            if (interval.end < plane.max_slope)
                visit({interval.end, -weights[place]});
        }
    });
    return weight_at_zero;
}

/// The best slope in one plane.
SlopeChoice choose_slope(const Plane& plane, const std::vector<std::int64_t>& weights,
                         const Hull& hull, double unit) {
    std::uint64_t particles = 0;
    for (const StateHead& head : plane.campaign.heads)
        particles += head.particles;
    return best_slope(
        [&](const std::function<void(const SlopeEvent&)>& visit) {
            return visit_events(plane, weights, hull, visit);
        },
        particles, plane.max_slope, unit, *plane.campaign.ranks);
}

/// What a feature spans: one where it is a fraction, else as far as the surface particles reach.
double span(const FeatureRow& feature, double reach) {
    if (feature.is_fraction)
        return 1;
    return reach > 0 ? reach : 1;
}

void check_interior(const Campaign& campaign) {
    for (const StateHead& head : campaign.heads)
        if (head.surface < head.particles)
            return;
    throw InputError("no interior particle to train on; give other files or a higher "
                     "--label-threshold");
}

} // namespace

double max_slope(const FeaturePair& features) {
    return 1 / feature_list[features.first].float_error;
}

Line best_line(const Campaign& campaign, double label_threshold) {
    const bool any_side = !is_of_paper(campaign.heads.front().state.features);
    const auto weights = particle_weights(campaign);
    SlopeChoice best;
    double k = 0;
    bool above = false;
    for (const auto [x_sign, y_sign] :
         {std::array{1.0, 1.0}, {-1.0, 1.0}, {1.0, -1.0}, {-1.0, -1.0}}) {
        const Plane plane(campaign, label_threshold, x_sign, y_sign);
        const SurfacePart surface = surface_part(plane);
        check_interior(campaign);
        const Hull hull = upper_hull(surface.points, plane.max_slope);
        const double unit =
            span(plane.y_feature(), surface.reach_y) / span(plane.x_feature(), surface.reach_x);
        const SlopeChoice choice = choose_slope(plane, weights, hull, unit);
        if (choice.weight > best.weight ||
            (choice.weight == best.weight && choice.width > best.width)) {
            best = choice;
            k = x_sign * y_sign * choice.slope(unit);
            above = y_sign < 0;
        }
        if (!any_side)
            break;
    }
    return shift_line(campaign, label_threshold, k, above);
}

Line min_false_positives(const std::vector<LabelledState>& states, double label_threshold) {
    return best_line(campaign_of(states, label_threshold), label_threshold);
}

} // namespace meniscus
