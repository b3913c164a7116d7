#include "glass_shape.hpp"

#include <meniscus/data/particles/neighbor_search.hpp>
#include <meniscus/runtime/math/angles.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace meniscus {
namespace {

/// The particles of each connected body, the largest first.
std::vector<std::vector<std::size_t>> bodies_of(const Positions& positions, double support_radius) {
    std::vector<std::vector<std::size_t>> bodies;
    if (positions.empty())
        return bodies;
    const NeighborLists lists = find_neighbors(positions, support_radius);
    std::vector<bool> seen(positions.size());
    for (std::size_t first = 0; first < positions.size(); ++first) {
        if (seen[first])
            continue;
        std::vector<std::size_t> body = {first};
        seen[first] = true;
        for (std::size_t next = 0; next < body.size(); ++next)
            for (std::size_t n = lists.offsets[body[next]]; n < lists.offsets[body[next] + 1]; ++n)
                if (const std::size_t j = lists.neighbors[n]; !seen[j]) {
                    seen[j] = true;
                    body.push_back(j);
                }
        bodies.push_back(std::move(body));
    }
    std::stable_sort(bodies.begin(), bodies.end(),
                     [](const auto& a, const auto& b) { return a.size() > b.size(); });
    return bodies;
}

template <class Keep>
Positions chosen(const Positions& positions, const Keep& keep) {
    Positions some;
    std::copy_if(positions.begin(), positions.end(), std::back_inserter(some), keep);
    return some;
}

double distance_from_axis(const Place& place) {
    return std::hypot(place[0], place[2]);
}

bool is_in_glass(const Place& place, const Glass& glass) {
    return place[1] >= 0 && place[1] <= glass.height &&
           distance_from_axis(place) < glass.radius_at(place[1]);
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

} // namespace

Jet jet_of(const Positions& positions, const Glass& glass, double support_radius) {
    const Positions falling = chosen(positions, [&](const Place& place) {
        return place[1] > glass.height && place[1] < glass.lip;
    });
    const auto bodies = bodies_of(falling, support_radius);
    if (bodies.empty())
        return {};
    return {falling.size(), bodies.front().size(), bodies.size() - 1};
}

std::size_t in_glass(const Positions& positions, const Glass& glass) {
    return static_cast<std::size_t>(
        std::count_if(positions.begin(), positions.end(),
                      [&](const Place& place) { return is_in_glass(place, glass); }));
}

std::optional<Level> level_in(const Positions& positions, const Glass& glass, double spacing,
                              double support_radius) {
    const Positions inside =
        chosen(positions, [&](const Place& place) { return is_in_glass(place, glass); });
    const auto bodies = bodies_of(inside, support_radius);
    if (bodies.empty())
        return {};
    std::map<std::pair<long, long>, Place> highest; // of each square
    for (const std::size_t i : bodies.front()) {
        const Place& place = inside[i];
        const std::pair square{std::lround(place[0] / (2 * spacing)),
                               std::lround(place[2] / (2 * spacing))};
        const auto [found, is_new] = highest.emplace(square, place);
        if (!is_new && place[1] > found->second[1])
            found->second = place;
    }
    std::vector<double> middle;
    std::vector<double> at_wall;
    for (const auto& [square, place] : highest) {
        const double radius = glass.radius_at(place[1]);
        const double distance = distance_from_axis(place);
        if (distance < radius / 2)
            middle.push_back(place[1] + spacing / 2);
        else if (distance > radius - 2 * spacing)
            at_wall.push_back(place[1] + spacing / 2);
    }
    if (middle.empty() || at_wall.empty())
        return {};
    const double height = median(middle);
    return Level{height, median(at_wall) - height};
}

double rise_at_plane(double contact_angle, double capillary_length) {
    const double sine = std::sin(contact_angle * pi / 180);
    return std::copysign(std::sqrt(std::max(0.0, 2 * (1 - sine))) * capillary_length,
                         90 - contact_angle);
}

} // namespace meniscus
