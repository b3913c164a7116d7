// A solver with its own particles and its own way to find neighbors classifies them in the three
// ways that the runtime offers. They must agree. And has surface tension on its own threads.
#include EXPORTED

#include <meniscus/runtime/coefficients/surface_3d.hpp>
#include <meniscus/runtime/coverage/exact_coverage.hpp>
#include <meniscus/runtime/features/classifier.hpp>
#include <meniscus/runtime/surface/shipped_curvature_map.hpp>
#include <meniscus/runtime/surface/surface_tension.hpp>

#include <array>
#include <cstdint>
#include <cstdio>
#include <thread>
#include <vector>

namespace {

using Real = float;
using Vector = std::array<Real, 3>;

constexpr Real support_radius = 1;
constexpr Real mass = 0.125F;
constexpr double spacing_ratio = 1 / 0.45;
constexpr int edge = 10;

std::vector<Vector> block_of_particles() {
    std::vector<Vector> positions;
    for (int z = 0; z < edge; ++z)
        for (int y = 0; y < edge; ++y)
            for (int x = 0; x < edge; ++x)
                positions.push_back({0.45F * static_cast<Real>(x), 0.45F * static_cast<Real>(y),
                                     0.45F * static_cast<Real>(z)});
    return positions;
}

Vector between(const Vector& from, const Vector& to) {
    return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
}

Real squared(const Vector& vector) {
    return vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2];
}

/// In the loop that sums densities anyway; a paraboloid stands for the kernel.
template <class Line>
std::vector<std::uint8_t> fused(const std::vector<Vector>& positions) {
    const auto range = meniscus::neighbor_range<Real>(support_radius, Line::radius_ratio);
    const auto line = meniscus::surface_line<Line, Real>(spacing_ratio);
    const double scale = meniscus::count_scale<Line>(spacing_ratio);
    const meniscus::UniformRadius<Real> radii{support_radius};
    std::vector<std::uint8_t> surface;
    Real density = 0;
    for (const Vector& center : positions) {
        meniscus::FeatureSum<Real, 3> sum;
        meniscus::LineSum<typename Line::SecondLine, Real, 3> second;
        for (const Vector& other : positions) {
            const Vector displacement = between(center, other);
            const Real distance_squared = squared(displacement);
            if (distance_squared < support_radius * support_radius)
                density += mass * (1 - distance_squared);
            sum.add(displacement, distance_squared, mass, range);
            second.add(displacement, mass, 0, 0, radii, range);
        }
        const bool by_both =
            meniscus::is_surface(sum, line, support_radius) && meniscus::is_surface(second, scale);
        surface.push_back(by_both ? 1 : 0);
    }
    return density > 0 ? surface : std::vector<std::uint8_t>();
}

/// Over a view that is a callable: all particles, the particle itself included.
template <class Line>
std::vector<std::uint8_t> by_callable(const std::vector<Vector>& positions) {
    const auto view = [&](std::size_t i, auto&& visit) {
        for (std::size_t j = 0; j < positions.size(); ++j)
            visit(j, between(positions[i], positions[j]), mass);
    };
    std::vector<std::uint8_t> surface(positions.size());
    meniscus::classify<Line, Real, 3>(view, meniscus::NoBoundary{}, 0, positions.size(),
                                      meniscus::UniformRadius<Real>{support_radius}, spacing_ratio,
                                      surface.data());
    return surface;
}

/// Over lists in compressed rows.
template <class Line>
std::vector<std::uint8_t> by_lists(const std::vector<Vector>& positions) {
    std::vector<int> offsets = {0};
    std::vector<int> neighbors;
    for (const Vector& center : positions) {
        for (std::size_t j = 0; j < positions.size(); ++j)
            if (squared(between(center, positions[j])) < support_radius * support_radius)
                neighbors.push_back(static_cast<int>(j));
        offsets.push_back(static_cast<int>(neighbors.size()));
    }
    const meniscus::CsrNeighborhood<Real, 3, 3, int, int> view{positions[0].data(), nullptr,
                                                               offsets.data(), neighbors.data()};
    std::vector<std::uint8_t> surface(positions.size());
    meniscus::classify<Line, Real, 3>(view, meniscus::NoBoundary{}, 0, positions.size(),
                                      meniscus::UniformRadius<Real>{support_radius}, spacing_ratio,
                                      surface.data());
    return surface;
}

/// Corners are surface, the middle is not, and all ways agree.
template <class Line>
bool works(const std::vector<Vector>& positions) {
    const auto surface = fused<Line>(positions);
    constexpr int middle = edge / 2 * (1 + edge + edge * edge);
    return surface == by_callable<Line>(positions) && surface == by_lists<Line>(positions) &&
           surface.front() == 1 && surface.back() == 1 && surface.at(middle) == 0;
}

/// Exact coverage: a corner of the block is uncovered outwards, the middle is covered.
bool covers(const std::vector<Vector>& positions) {
    const meniscus::CoverageCells cells;
    meniscus::ExactCoverage coverage;
    const auto range = meniscus::neighbor_range<Real>(support_radius, 0.8);
    const auto part_of = [&](const Vector& center) {
        coverage.caps.clear();
        for (const Vector& other : positions) {
            const Vector displacement = between(center, other);
            if (range.contains(squared(displacement)))
                meniscus::add_cap<3>(coverage.caps, displacement, support_radius,
                                     0.8 * support_radius);
        }
        return meniscus::uncovered_part<3>(cells, coverage);
    };
    constexpr int middle = edge / 2 * (1 + edge + edge * edge);
    const auto corner = part_of(positions.front());
    return corner.fraction > 0.4 && corner.moment[0] < 0 && corner.moment[1] < 0 &&
           corner.moment[2] < 0 && part_of(positions.at(middle)).fraction == 0;
}

/// How the runtime spreads its work over a host's own threads: each has a part.
struct ThreadLoop {
    static int workers() { return 4; }

    template <class Body>
    void operator()(std::size_t count, const Body& body) const {
        std::vector<std::thread> threads;
        constexpr std::size_t parts = 4;
        for (std::size_t n = 0; n < parts; ++n)
            threads.emplace_back(body, count * n / parts, count * (n + 1) / parts,
                                 static_cast<int>(n));
        for (std::thread& thread : threads)
            thread.join();
    }
};

template <class View, class Loop>
std::vector<Vector> forces(const View& view, const Loop& loop) {
    meniscus::SurfaceTensionOptions options;
    options.spacing_ratio = spacing_ratio;
    meniscus::SurfaceTension<Real, 3> tension(options);
    tension.step(view, edge * edge * edge, meniscus::UniformRadius<Real>{support_radius}, loop);
    return tension.surface().force;
}

/// Surface tension over a callable: the same on any loop, and a corner is drawn inwards.
bool pulls(const std::vector<Vector>& positions) {
    const auto view = [&](std::size_t i, auto&& visit) {
        for (std::size_t j = 0; j < positions.size(); ++j)
            visit(j, between(positions[i], positions[j]), mass);
    };
    const auto on_one = forces(view, meniscus::SerialLoop{});
    const Vector& of_corner = on_one.front();
    return on_one == forces(view, ThreadLoop{}) && of_corner[0] > 0 && of_corner[1] > 0 &&
           of_corner[2] > 0;
}

} // namespace

int main() {
    const auto positions = block_of_particles();
    if (!pulls(positions)) {
        std::puts("surface tension is wrong");
        return 1;
    }
    if (!covers(positions)) {
        std::puts("exact coverage is wrong");
        return 1;
    }
    if (works<meniscus::Surface3D>(positions) && works<meniscus::Exported>(positions))
        return 0;
    std::puts("the ways to classify disagree");
    return 1;
}
