// Walls: particles at a wall are not at the free surface. A block of fluid in a tank that is open
// above, with two layers of boundary particles around it. Without the boundary all six sides are
// surface, with it the top alone.
#include <meniscus/data/particles/neighbor_search.hpp>
#include <meniscus/runtime/surface/surface_tension.hpp>

#include <algorithm>
#include <cstdio>

namespace {

constexpr long edge = 10; // particles
constexpr double h = 2;   // support radius; the spacing is 1

/// All places from `low` up to below `high` along x and y, and to below `top` along z, but for
/// those of the fluid where `around` says so.
meniscus::Positions lattice(long low, long high, long top, bool around) {
    meniscus::Positions places;
    for (long x = low; x < high; ++x)
        for (long y = low; y < high; ++y)
            for (long z = low; z < top; ++z)
                if (!around || std::min({x, y, z}) < 0 || std::max(x, y) >= edge)
                    places.push_back({double(x), double(y), double(z)});
    return places;
}

/// The boundary particles around each particle of the fluid, as compressed rows.
meniscus::NeighborLists boundary_lists(const meniscus::Positions& fluid,
                                       const meniscus::Positions& walls) {
    const meniscus::NeighborGrid grid(walls, h);
    meniscus::NeighborLists lists{{0}, {}};
    meniscus::FoundNeighbors found;
    for (const auto& place : fluid) {
        grid.find_around(place, h, found);
        lists.neighbors.insert(lists.neighbors.end(), found.particles.begin(),
                               found.particles.end());
        lists.offsets.push_back(lists.neighbors.size());
    }
    return lists;
}

/// A view of them: visit(b, x_b - x_i, V_b / V_0), here with particles as large as the fluid's.
struct Walls {
    const meniscus::Positions& fluid;
    const meniscus::Positions& walls;
    const meniscus::NeighborLists& lists;

    template <class Visit>
    void operator()(std::size_t i, const Visit& visit) const {
        for (std::size_t n = lists.offsets[i]; n < lists.offsets[i + 1]; ++n) {
            const std::size_t b = lists.neighbors[n];
            visit(b,
                  std::array<double, 3>{walls[b][0] - fluid[i][0], walls[b][1] - fluid[i][1],
                                        walls[b][2] - fluid[i][2]},
                  1.0);
        }
    }
};

template <class Boundary>
long count_surface(const meniscus::Positions& fluid, const Boundary& boundary) {
    const meniscus::NeighborLists lists = meniscus::find_neighbors(fluid, h);
    const meniscus::CsrNeighborhood<double, 3> view{fluid[0].data(), nullptr, lists.offsets.data(),
                                                    lists.neighbors.data()};
    meniscus::SurfaceTensionOptions options;
    options.spacing_ratio = h;
    meniscus::SurfaceTension<double, 3> tension(options);
    tension.step(view, boundary, fluid.size(), meniscus::UniformRadius<double>{h}, nullptr,
                 meniscus::SerialLoop{});
    const auto& classes = tension.surface().surface_class;
    return std::count(classes.begin(), classes.end(), meniscus::SurfaceClass::surface);
}

} // namespace

int main() { // NOLINT(bugprone-exception-escape): what is thrown ends the example
    const meniscus::Positions fluid = lattice(0, edge, edge, false);
    const meniscus::Positions walls = lattice(-2, edge + 2, edge, true);
    const meniscus::NeighborLists lists = boundary_lists(fluid, walls);
    const long alone = count_surface(fluid, meniscus::NoBoundary{});
    const long in_tank = count_surface(fluid, meniscus::BoundaryView<Walls>{{fluid, walls, lists}});
    std::printf("%zu particles: %ld surface alone, %ld in the tank\n", fluid.size(), alone,
                in_tank);
    const long inner = edge - 2;
    return alone == edge * edge * edge - inner * inner * inner && in_tank == edge * edge ? 0 : 1;
}
