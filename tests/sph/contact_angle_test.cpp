// Fluid at rest at walls, held by surface tension: layers, drops that start at rest, and drops that
// find their contact angle. In water of two dimensions, particles a tenth of a millimetre apart.
#include "small_scenes.hpp"

#include <meniscus/data/particles/particle_arrays.hpp>

namespace meniscus {
namespace {

constexpr double spacing = 1e-4;
constexpr double sigma = 0.072;

Scene water_scene(double contact_angle, double kinematic) {
    Scene scene = empty_scene(2, "dfsph");
    scene.particle_spacing = spacing;
    scene.support_radius = 2 * spacing;
    scene.time_step.max = default_max_time_step(spacing);
    scene.viscosity.kinematic = kinematic;
    scene.surface_tension.model = "meniscus";
    scene.surface_tension.coefficient = sigma;
    scene.surface_tension.surface.contact_angle = contact_angle;
    scene.surface_tension.surface.ambient_pressure = default_ambient_pressure(true);
    return scene;
}

/// A wall in y = 0, with sides far away.
Scene on_a_wall(Scene scene, FluidBody body) {
    scene.fluid = {std::move(body)};
    scene.walls = {BoxShape{{-8e-3, 0, 0}, {8e-3, 6e-3, 0}, {"+y"}}};
    return scene;
}

double energy_of(const Balance& balance) {
    return balance.kinetic_energy + balance.potential_energy + sigma * balance.surface_area;
}

/// The largest energy on the way over that at the start.
double largest_energy(Simulation& simulation, double duration) {
    const double first = energy_of(simulation.balance());
    double max = first;
    for (int part = 1; part <= 10; ++part) {
        run_until(simulation, duration * part / 10);
        max = std::max(max, energy_of(simulation.balance()));
    }
    return max / first;
}

TEST(ContactAngle, ALevelLayerBetweenWallsRests) {
    for (const auto& [solver, name] : all_solvers) {
        if (std::string_view(solver) == "wcsph")
            continue; // sound that fast needs steps that take minutes
        SCOPED_TRACE(name);
        Scene scene = water_scene(90, 1e-5);
        scene.pressure.solver = solver;
        scene.gravity = {0, -9.81, 0};
        scene.fluid = {{BoxShape{{5e-5, 5e-5, 0}, {2.05e-3, 1.05e-3, 0}, {}}, {}}};
        scene.walls = {BoxShape{{0, 0, 0}, {2.1e-3, 2e-3, 0}, {"+y"}}};
        const auto simulation = start(scene);
        EXPECT_LT(largest_energy(*simulation, 0.02), 1.002);
        EXPECT_LT(simulation->balance().max_speed, 0.05); // 0.8 m/s is the capillary speed
        EXPECT_EQ(simulation->size(), 200U);
    }
}

TEST(ContactAngle, ALayerAsThinAsWaterRestsSinceItsContactLinesHaveFriction) {
    Scene scene = water_scene(90, 1e-6);
    scene.gravity = {0, -9.81, 0};
    scene.fluid = {{BoxShape{{0, 0, 0}, {4e-3, 3e-3, 0}, {}}, {}}};
    scene.walls = {BoxShape{{-5e-5, -5e-5, 0}, {4.05e-3, 6e-3, 0}, {"+y"}}};
    for (const double courant_factor : {1.0, 0.8}) { // what rattles, does so at one of them
        scene.time_step.courant_factor = courant_factor;
        const auto simulation = start(scene);
        EXPECT_LT(largest_energy(*simulation, 0.05), 1.005);
        EXPECT_LT(simulation->balance().max_speed, 0.1);
        EXPECT_EQ(simulation->size(), 1200U);
    }
}

Scene scene_in_gravity(double contact_angle, double coarse) {
    Scene scene = water_scene(contact_angle, 2e-5);
    scene.particle_spacing = coarse;
    scene.support_radius = 2 * coarse;
    scene.time_step.max = default_max_time_step(coarse);
    scene.gravity = {0, -9.81, 0};
    return scene;
}

constexpr double pi = 3.14159265358979;
constexpr double weight = 1000 * 9.81;

/// Heights of a surface between two walls after Young and Laplace, over where it would be without
/// them, from the middle to a wall in equal steps: z' = tan(psi), sigma psi' = rho g z / cos(psi).
std::vector<double> meniscus_between(double width, double contact_angle) {
    const double at_wall = std::abs(90 - contact_angle) * pi / 180;
    std::vector<double> heights(2001);
    const double step = width / 2 / static_cast<double>(heights.size() - 1);
    double low = 0, high = std::sqrt(sigma / weight);
    for (int halving = 0; halving < 60; ++halving) {
        heights[0] = (low + high) / 2;
        double psi = 0;
        for (std::size_t k = 1; k < heights.size() && psi < 1.5; ++k) {
            psi += step * weight / sigma * heights[k - 1] / std::cos(psi);
            heights[k] = heights[k - 1] + step * std::tan(psi);
        }
        (psi < at_wall ? low : high) = heights[0];
    }
    for (double& height : heights)
        height *= contact_angle < 90 ? 1 : -1;
    return heights;
}

/// How much higher the surface lies at the walls of a tank than in its middle, and how much it
/// should, for the surface particles up to 1.6 spacings off the walls.
struct Rise {
    double found = 0, expected = 0;
};

Rise rise_at_walls(const Snapshot& frame, double width, double coarse, double contact_angle) {
    const auto classes = scalar_values(frame, "surface_class");
    const std::vector<double> exact = meniscus_between(width, contact_angle);
    Rise at_walls, middle;
    int at_walls_count = 0, middle_count = 0;
    for (std::size_t i = 0; i < frame.size(); ++i) {
        const Place& place = frame.positions[i];
        const double off_middle = std::abs(place[0] - width / 2) / (width / 2);
        const bool is_at_wall = (1 - off_middle) * width / 2 < 1.6 * coarse;
        if (classes[i] != 2 || (!is_at_wall && off_middle > 0.2))
            continue;
        Rise& sum = is_at_wall ? at_walls : middle;
        sum.found += place[1];
        sum.expected += exact[static_cast<std::size_t>(std::min(off_middle, 1.0) *
                                                       static_cast<double>(exact.size() - 1))];
        ++(is_at_wall ? at_walls_count : middle_count);
    }
    EXPECT_GT(at_walls_count, 1);
    EXPECT_GT(middle_count, 1);
    return {at_walls.found / at_walls_count - middle.found / middle_count,
            at_walls.expected / at_walls_count - middle.expected / middle_count};
}

TEST(ContactAngle, MenisciOfAllSolversComeToRest) {
    constexpr double coarse = 2.5e-4, width = 12e-3;
    for (const auto& [solver, name] : all_solvers)
        for (const double angle : {60.0, 120.0}) {
            if (std::string_view(solver) == "wcsph")
                continue; // sound that fast needs steps that take minutes
            if (angle > 90 && std::string_view(solver) != "dfsph")
                continue; // nothing hangs there
            SCOPED_TRACE(std::string(name) + ", " + std::to_string(angle));
            Scene scene = scene_in_gravity(angle, coarse);
            scene.pressure.solver = solver;
            scene.fluid = {{BoxShape{{0, 0, 0}, {width, 3e-3, 0}, {}}, {}}};
            scene.walls = {
                BoxShape{{-coarse / 2, -coarse / 2, 0}, {width + coarse / 2, 8e-3, 0}, {"+y"}}};
            const auto simulation = start(scene);
            run_until(*simulation, 0.25);
            EXPECT_LT(simulation->balance().max_speed, 0.02);
            const Rise rise = rise_at_walls(simulation->snapshot(), width, coarse, angle);
            EXPECT_NEAR(rise.found, rise.expected, 0.12 * std::abs(rise.expected));
            EXPECT_EQ(simulation->size(), 576U);
        }
}

/// Between plates that dip into a tank: Jurin's height is 2 sigma cos(theta) / (rho g width), of
/// the mean over a gap. Fluid rises between plates and tank, too.
TEST(ContactAngle, WaterRisesBetweenPlates) {
    constexpr double coarse = 1.5e-4;
    constexpr double tank = 12e-3, plates = 1.5e-3, bottom = 1.2e-3, top = 14e-3;
    constexpr double left = (tank - plates) / 2, right = left + plates;
    constexpr double thick = 3 * coarse;
    Scene scene = scene_in_gravity(60, coarse);
    const auto fill = [&](double low, double high, double height) {
        scene.fluid.push_back({BoxShape{{low, 0, 0}, {high, height, 0}, {}}, {}});
    };
    fill(0, left - thick, 3.6e-3);
    fill(left - thick, left, bottom);
    fill(left, right, 3.6e-3);
    fill(right, right + thick, bottom);
    fill(right + thick, tank, 3.6e-3);
    const double half = coarse / 2;
    scene.walls = {BoxShape{{-half, -half, 0}, {tank + half, top, 0}, {"+y"}},
                   BoxShape{{left - thick + half, bottom + half, 0}, {left - half, top, 0}, {}},
                   BoxShape{{right + half, bottom + half, 0}, {right + thick - half, top, 0}, {}}};
    const auto simulation = start(scene);
    const std::size_t count = simulation->size();
    run_until(*simulation, 0.3);
    EXPECT_LT(simulation->balance().max_speed, 0.02);
    EXPECT_EQ(simulation->size(), count);
    const double area = coarse * coarse;
    double between = 0, outside = 0;
    for (const Place& place : simulation->snapshot().positions) {
        between += place[0] > left && place[0] < right ? area : 0;
        outside += place[0] < left - thick || place[0] > right + thick ? area : 0;
    }
    const double gaps = tank - plates - 2 * thick;
    const double rise = between / plates - outside / gaps;
    const double expected = 2 * sigma * std::cos(pi / 3) / weight * (1 / plates - 2 / gaps);
    EXPECT_NEAR(rise, expected, 0.1 * expected);
}

TEST(ContactAngle, AHalfDiscThatStartsHalfASpacingFromTheWallRests) {
    Scene scene = water_scene(90, 2e-5);
    SceneParticles particles = fill_scene(
        on_a_wall(scene, {BoxShape{{-1.2e-3, 1.5e-4, 0}, {1.2e-3, 1.35e-3, 0}, {}}, {}}));
    Positions half;
    for (Place place : particles.positions) {
        place[1] -= 1.5e-4; // the first row half a spacing from the wall
        if (std::hypot(place[0], place[1]) < 1.2e-3)
            half.push_back(place);
    }
    const std::size_t count = half.size();
    const auto simulation = start_at(scene, half, std::vector<Place>(count), particles.walls);
    EXPECT_GT(simulation->parted(), 10U);
    // What was moved off leaves an uneven surface, of which the area is known to a few percent.
    const double first = energy_of(simulation->balance());
    EXPECT_LT(largest_energy(*simulation, 0.01), 1.02);
    EXPECT_LT(energy_of(simulation->balance()), first);
    EXPECT_LT(simulation->balance().max_speed, 0.01);
}

TEST(ContactAngle, ADropThatTouchesAWallSpreadsWithoutMakingEnergy) {
    const auto simulation = start(
        on_a_wall(water_scene(90, 2e-5), {SphereShape{{0, 2.05e-3, 0}, {2e-3, 2e-3, 0}}, {}}));
    const double height = simulation->balance().center[1];
    EXPECT_LT(largest_energy(*simulation, 0.015),
              1.03); // contact closes over a hole, whose area counts
    EXPECT_LT(simulation->balance().center[1], 0.85 * height);
}

/// The circle through the surface particles, which stand half a spacing inside of it.
double fitted_angle(const Simulation& simulation) {
    const Snapshot frame = simulation.snapshot();
    const auto classes = scalar_values(frame, "surface_class");
    double xx = 0, yy = 0, xy = 0, x = 0, y = 0, xs = 0, ys = 0, s = 0, n = 0;
    for (std::size_t i = 0; i < frame.size(); ++i) {
        if (classes[i] != 2)
            continue;
        const double a = frame.positions[i][0] / spacing;
        const double b = frame.positions[i][1] / spacing;
        const double square = a * a + b * b;
        xx += a * a, yy += b * b, xy += a * b, x += a, y += b;
        xs += a * square, ys += b * square, s += square, n += 1;
    }
    // Least squares of |p|^2 = 2 c . p + r^2 - c^2, about the mean.
    const double cxx = xx - x * x / n, cyy = yy - y * y / n, cxy = xy - x * y / n;
    const double cxs = xs - x * s / n, cys = ys - y * s / n;
    const double determinant = cxx * cyy - cxy * cxy;
    const double cx = (cxs * cyy - cys * cxy) / determinant / 2;
    const double cy = (cys * cxx - cxs * cxy) / determinant / 2;
    const double radius = std::sqrt(s / n - 2 * (cx * x + cy * y) / n + cx * cx + cy * cy) + 0.5;
    const double wall = 0.5; // halfway between wall particles and fluid
    return std::acos(-(cy - wall) / radius) * 180 / 3.14159265358979;
}

TEST(ContactAngle, DropsFindTheirs) {
    for (const double angle : {60.0, 120.0}) {
        SCOPED_TRACE(angle);
        const auto simulation =
            start(on_a_wall(water_scene(angle, 1e-4),
                            {BoxShape{{-1.2e-3, 5e-5, 0}, {1.2e-3, 1.25e-3, 0}, {}}, {}}));
        run_until(*simulation, 0.02);
        EXPECT_NEAR(fitted_angle(*simulation), angle, 6); // ten particles make the radius
    }
}

TEST(ContactAngle, EachWallMayHaveItsOwn) {
    Scene scene = on_a_wall(water_scene(90, 1e-4),
                            {BoxShape{{-1.6e-3, 5e-5, 0}, {1.6e-3, 1.65e-3, 0}, {}}, {}});
    scene.walls[0].contact_angle = 60;
    Scene same = scene;
    same.walls[0].contact_angle.reset();
    same.surface_tension.surface.contact_angle = 60;
    const auto simulation = start(scene);
    const auto other = start(same);
    run_until(*simulation, 0.001);
    run_until(*other, 0.001);
    EXPECT_EQ(places_by_id(*simulation), places_by_id(*other));
}

/// The neck is hollow: its surface pulls outward. Without air, the energy of water rises.
TEST(AmbientPressure, HoldsANeckTogether) {
    Scene scene = water_scene(90, 1e-6);
    scene.surface_tension.surface.ambient_pressure = default_ambient_pressure(false);
    const SphereShape low{{0, -1.25e-3, 0}, {1.2e-3, 1.2e-3, 0}};
    const SphereShape high{{0, 1.25e-3, 0}, {1.2e-3, 1.2e-3, 0}};
    scene.fluid = {{low, {}}, {high, {}}};
    const auto simulation = start(scene);
    EXPECT_LT(largest_energy(*simulation, 0.012), 1.1);
}

} // namespace
} // namespace meniscus
