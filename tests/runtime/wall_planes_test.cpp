// Walls given by distances and normals do what a layer of boundary particles does.
#include "fluids.hpp"

#include <meniscus/runtime/neighbors/wall_planes.hpp>

#include <gtest/gtest.h>
#include <limits>

namespace meniscus {
namespace {

/// Fluid in a box without a lid, `counts` particles along each axis, spacing 1/2 and radius 1, half
/// a spacing from its walls; moved by up to `jitter` spacings.
template <int Dimension>
struct Box {
    Fluid<double, Dimension> fluid;
    std::array<int, 3> counts;

    Box(std::array<int, 3> of_axes, double jitter)
        : fluid(block<double, Dimension>(of_axes)), counts(of_axes) {
        Numbers numbers(3);
        auto places = fluid.positions;
        for (auto& place : places)
            for (double& coordinate : place)
                coordinate += 0.25 + jitter * (numbers.next() - 0.5);
        fluid = Fluid<double, Dimension>(places, 1);
    }

    /// All walls but the lid.
    template <class Visit>
    void operator()(std::size_t i, Visit&& visit) const {
        for (std::size_t axis = 0; axis < Dimension; ++axis)
            for (const bool at_end : {false, true}) {
                if (at_end && axis == Dimension - 1)
                    continue;
                std::array<double, Dimension> normal{};
                normal[axis] = at_end ? -1 : 1;
                const double at = fluid.positions[i][axis];
                visit(2 * axis + (at_end ? 1 : 0), at_end ? counts[axis] / 2.0 - at : at, normal);
            }
    }
};

template <int Dimension>
std::vector<SurfaceClass> classes_of(const SurfaceParticles<double, Dimension>& list) {
    std::vector<SurfaceClass> classes(list.slot_of.size(), SurfaceClass::interior);
    for (std::size_t slot = 0; slot < list.size(); ++slot)
        classes[list.particle[slot]] = list.surface_class[slot];
    return classes;
}

template <int Dimension>
std::size_t surface_below(const Box<Dimension>& box, double height,
                          const SurfaceParticles<double, Dimension>& list) {
    std::size_t found = 0;
    const auto classes = classes_of(list);
    for (std::size_t i = 0; i < classes.size(); ++i)
        found +=
            classes[i] == SurfaceClass::surface && box.fluid.positions[i][Dimension - 1] < height
                ? 1
                : 0;
    return found;
}

/// In a filled box only the particles below the lid are surface; without walls many more.
template <int Dimension>
void expect_surface_at_the_lid(CoverageMethod coverage) {
    const Box<Dimension> box({8, 8, 8}, 0.1);
    const double top = 3.5; // between the last two layers
    SurfaceTensionOptions options;
    options.coverage = coverage;
    SurfaceTension<double, Dimension> tension(options);
    const auto radii = box.fluid.radii();
    tension.step(box.fluid.view(), wall_planes_of<Dimension>(box, radii, 2), box.fluid.size(),
                 radii, nullptr, SerialLoop{});
    EXPECT_EQ(surface_below<Dimension>(box, top, tension.surface()), 0U);
    EXPECT_GT(surface_below<Dimension>(box, 4, tension.surface()), Dimension == 3 ? 60U : 7U);
    for (std::size_t slot = 0; slot < tension.surface().size(); ++slot)
        EXPECT_TRUE(tension.surface().surface_class[slot] == SurfaceClass::covered ||
                    tension.surface().normal[slot][Dimension - 1] > 0.9);
    tension.step(box.fluid.view(), box.fluid.size(), radii, SerialLoop{});
    EXPECT_GE(surface_below<Dimension>(box, top, tension.surface()), 20U);
}

TEST(WallPlanes, LeaveTheLidAsSurface) {
    expect_surface_at_the_lid<2>(CoverageMethod::sampled);
    expect_surface_at_the_lid<3>(CoverageMethod::sampled);
    expect_surface_at_the_lid<2>(CoverageMethod::exact);
    expect_surface_at_the_lid<3>(CoverageMethod::exact);
}

/// Particles above the foot of each lattice point are told the same by real boundary particles.
TEST(WallPlanes, AreALayerOfBoundaryParticles) {
    const auto fluid = block<double, 3>({7, 7, 5});
    const auto layer = [&](std::size_t i, auto&& visit) {
        for (int x = -6; x <= 12; ++x)
            for (int y = -6; y <= 12; ++y) {
                const std::array<double, 3> step = {0.5 * x - fluid.positions[i][0],
                                                    0.5 * y - fluid.positions[i][1],
                                                    -0.5 - fluid.positions[i][2]};
                visit(std::size_t{0}, step, wall_planes::weight_in_layer<3>(2));
            }
    };
    const auto plane = [&](std::size_t i, auto&& visit) {
        visit(std::size_t{0}, fluid.positions[i][2] + 0.25, std::array<double, 3>{0, 0, 2});
    };
    const BoundaryView<decltype(layer)> particles{layer};
    const auto walls = wall_planes_of<3>(plane, fluid.radii(), 2);
    SurfaceTensionOptions options;
    options.coverage = CoverageMethod::exact;
    SurfaceTension<double, 3> by_particles(options), by_walls(options);
    by_particles.step(fluid.view(), particles, fluid.size(), fluid.radii(), nullptr, SerialLoop{});
    by_walls.step(fluid.view(), walls, fluid.size(), fluid.radii(), nullptr, SerialLoop{});
    EXPECT_EQ(classes_of(by_walls.surface()), classes_of(by_particles.surface()));
    ASSERT_EQ(by_walls.surface().particle, by_particles.surface().particle);
    for (std::size_t slot = 0; slot < by_walls.surface().size(); ++slot)
        EXPECT_NEAR(by_walls.surface().uncovered_fraction[slot],
                    by_particles.surface().uncovered_fraction[slot], 1e-9);
}

/// Alone at a wall, a particle is left what lies on its side, wherever it is pressed to.
TEST(WallPlanes, CoverAtLeastTheirHalfSpace) {
    for (const double ratio : {1.5, 2.0, 2.5, 3.0, 4.0})
        for (const double distance : {-1.0, -0.1, 0.0, 0.1, 0.3}) {
            const auto plane = [&](std::size_t /*i*/, auto&& visit) {
                visit(std::size_t{0}, distance, std::array<double, 3>{0.36, 0.48, 0.8});
            };
            const UniformRadius<double> radii{1};
            ExactCoverage exact;
            const CoverageCells cells;
            wall_planes_of<3>(plane, radii,
                              ratio)(0, [&](std::size_t, const auto& step, double /*weight*/) {
                if (neighbor_range<double>(1, 0.8).contains(squared_length<double, 3>(step)))
                    add_cap<3>(exact.caps, step, 1, 0.8);
            });
            const UncoveredPart open = uncovered_part<3>(cells, exact);
            // The cap behind the plane through the layer, half a spacing deeper.
            const double depth = (std::max)(distance + 0.5 / ratio, 0.25);
            EXPECT_LE(open.fraction, (1 + depth) / 2 + 1e-9) << ratio << ' ' << distance;
            EXPECT_GT(open.fraction, 0.1) << ratio << ' ' << distance;
        }
}

TEST(WallPlanes, OutOfReachOrWithoutANumberDoNothing) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    struct Case {
        double distance;
        std::array<double, 3> normal;
    };
    for (const Case& given :
         {Case{0.75, {0, 0, 1}}, Case{infinity, {0, 0, 1}}, Case{-infinity, {0, 0, 1}},
          Case{nan, {0, 0, 1}}, Case{0.1, {0, 0, 0}}, Case{0.1, {0, nan, 1}}}) {
        const auto plane = [&](std::size_t /*i*/, auto&& visit) {
            visit(std::size_t{0}, given.distance, given.normal);
        };
        int visited = 0;
        wall_planes_of<3>(plane, UniformRadius<double>{1},
                          2)(0, [&](std::size_t, const auto&, double) { ++visited; });
        EXPECT_EQ(visited, 0) << given.distance;
    }
}

/// The surface meets each wall at the wall's own angle: normals change with it.
TEST(WallPlanes, HaveContactAnglesOfTheirOwn) {
    const Box<3> box({6, 6, 6}, 0);
    auto walls = wall_planes_of<3>(box, box.fluid.radii(), 2);
    SurfaceTension<double, 3> tension;
    const auto step = [&] {
        tension.step(box.fluid.view(), walls, box.fluid.size(), box.fluid.radii(), nullptr,
                     SerialLoop{});
        return tension.surface().normal;
    };
    const auto usual = step();
    const std::vector<float> angles(6, 60);
    walls.contact_angles = angles.data();
    const auto at_60 = step();
    EXPECT_NE(usual, at_60);
    walls.contact_angles = nullptr;
    tension.set_contact_angle(60);
    EXPECT_EQ(step(), at_60);
}

} // namespace
} // namespace meniscus
