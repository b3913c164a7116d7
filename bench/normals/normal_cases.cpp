#include "normal_cases.hpp"

#include "support/fluid_state.hpp"

#include <meniscus/labeler/sampling/directions.hpp>

#include <functional>
#include <utility>

namespace meniscus {
namespace {

using IsCandidate = std::function<bool(std::size_t particle)>;

NormalCase case_of(Cloud cloud, const IsCandidate& is_candidate) {
    NormalCase made;
    const NeighborGrid grid(cloud.positions, cloud.support_radius);
    FoundNeighbors found;
    made.lists.offsets.push_back(0);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        const bool wanted = is_candidate(i);
        found.clear();
        if (wanted)
            grid.find_around(cloud.positions[i], cloud.support_radius, found);
        made.candidate.push_back(wanted ? 1 : 0);
        made.neighbor_count.push_back(static_cast<std::int32_t>(found.size()));
        made.lists.neighbors.insert(made.lists.neighbors.end(), found.particles.begin(),
                                    found.particles.end());
        made.lists.offsets.push_back(made.lists.neighbors.size());
    }
    made.outermost.resize(cloud.size());
    made.measured.resize(cloud.size());
    made.cloud = std::move(cloud);
    return made;
}

void mark_outermost(NormalCase& some) {
    SurfaceParticles<double, 3> list;
    SurfaceTensionOptions exact;
    exact.coverage = CoverageMethod::exact;
    expose<3>(some, {}, exact, list);
    const Cloud& cloud = some.cloud;
    for (std::size_t slot = 0; slot < list.size(); ++slot) {
        const std::size_t i = list.particle[slot];
        const bool is_outermost =
            cloud.trusted[i] != 0 && cloud.depth[i] < outermost_depth * cloud.spacing;
        some.outermost[i] = is_outermost ? 1 : 0;
        some.measured[i] =
            is_outermost && list.uncovered_fraction[slot] > min_measured_fraction ? 1 : 0;
    }
}

/// In units of the support radius.
NormalCase relaxed_case(const Shape& shape, double radius_in_spacings, std::uint64_t seed) {
    CloudOptions options;
    options.spacing = 1 / radius_in_spacings;
    options.support_radius = 1;
    options.seed = seed;
    Cloud cloud = fill(shape, options);
    // The third layer has no part in the surface.
    const std::vector<double> depth = cloud.depth;
    NormalCase made =
        case_of(std::move(cloud), [&](std::size_t i) { return depth[i] < 2 * options.spacing; });
    mark_outermost(made);
    return made;
}

/// Whether the particle touches an empty ball of the grid's radius in one of the directions.
bool touches_empty_ball(const Positions& positions, std::size_t i, double radius,
                        const std::vector<Direction>& directions, const NeighborGrid& grid) {
    FoundNeighbors found;
    for (const Direction& direction : directions) {
        std::array<double, 3> center = positions[i];
        for (int axis = 0; axis < 3; ++axis)
            center[axis] += 1.0001 * radius * direction[axis]; // the particle itself is out of it
        grid.find_around(center, radius, found);
        if (found.size() == 0)
            return true;
    }
    return false;
}

} // namespace

NormalCase circle_case(double radius, std::uint64_t seed) {
    constexpr double neighbors = 1000;
    constexpr double share_on_circle = 0.16;
    CloudOptions options;
    options.support_radius = 1;
    options.spacing = std::sqrt(pi * (1 - share_on_circle) / neighbors);
    options.arrangement = Arrangement::random;
    options.surface_share = share_on_circle;
    options.seed = seed;
    options.threads = 1;
    Cloud cloud = fill(circle(radius), options);
    // What lies deeper than r1 - r2 is covered by points on the circle.
    const std::vector<double> depth = cloud.depth;
    NormalCase made = case_of(std::move(cloud), [&](std::size_t i) { return depth[i] < 0.2; });
    for (std::size_t i = 0; i < depth.size(); ++i)
        made.measured[i] = made.outermost[i] = depth[i] < 1e-9 ? 1 : 0;
    return made;
}

NormalCase saddle_case(double radius_in_spacings, std::uint64_t seed) {
    constexpr double curvature = 0.25;
    return relaxed_case(paraboloid(curvature / 2, curvature / 2, 10), radius_in_spacings, seed);
}

NormalCase ball_case(std::uint64_t seed) {
    return relaxed_case(sphere(5), 2, seed);
}

NormalCase state_case(const std::filesystem::path& file) {
    constexpr std::size_t directions_tried = 512;
    const Snapshot snapshot = read_snapshot_in_3d(file);
    Cloud cloud;
    cloud.support_radius = *snapshot.support_radius;
    cloud.positions = snapshot.positions;
    std::vector<Direction> directions(directions_tried);
    sampling_scheme("halton").fill(3, 0, 0, directions);
    const Positions& positions = snapshot.positions;
    const NeighborGrid grid(positions, cloud.support_radius);
    cloud.trusted.assign(positions.size(), 1);
    NormalCase made = case_of(std::move(cloud), [](std::size_t) { return true; });
    for (std::size_t i = 0; i < positions.size(); ++i)
        made.outermost[i] =
            touches_empty_ball(positions, i, *snapshot.support_radius, directions, grid) ? 1 : 0;
    return made;
}

} // namespace meniscus
