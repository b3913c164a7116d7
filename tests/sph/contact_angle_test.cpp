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
        EXPECT_LT(largest_energy(*simulation, 0.01), 1.002);
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

/// Of a wide tank, at 120 degrees: the contact line lies lower than the middle by
/// sqrt(2 (1 - sin theta)) capillary lengths; the particles counted, up to 1.6 spacings off the
/// wall, lie on its slope, higher by about a tenth of that.
TEST(ContactAngle, AMeniscusThatDoesNotWetComesToRest) {
    constexpr double coarse = 2.5e-4;
    Scene scene = water_scene(120, 2e-5);
    scene.particle_spacing = coarse;
    scene.support_radius = 2 * coarse;
    scene.time_step.max = default_max_time_step(coarse);
    scene.gravity = {0, -9.81, 0};
    scene.fluid = {{BoxShape{{0, 0, 0}, {16e-3, 5e-3, 0}, {}}, {}}};
    scene.walls = {BoxShape{{-coarse / 2, -coarse / 2, 0}, {16e-3 + coarse / 2, 16e-3, 0}, {"+y"}}};
    const auto simulation = start(scene);
    run_until(*simulation, 0.25);
    EXPECT_LT(simulation->balance().max_speed, 0.02);
    const Snapshot frame = simulation->snapshot();
    const auto classes = scalar_values(frame, "surface_class");
    double at_walls = 0, middle = 0;
    int at_walls_count = 0, middle_count = 0;
    for (std::size_t i = 0; i < frame.size(); ++i) {
        if (classes[i] != 2)
            continue;
        const Place& place = frame.positions[i];
        const double from_wall = std::min(place[0], 16e-3 - place[0]);
        if (from_wall < 1.6 * coarse) {
            at_walls += place[1];
            ++at_walls_count;
        } else if (from_wall > 6e-3) {
            middle += place[1];
            ++middle_count;
        }
    }
    const double expected = std::sqrt(2 * (1 - std::sqrt(3) / 2) * sigma / (1000 * 9.81));
    ASSERT_GT(at_walls_count, 0);
    EXPECT_NEAR(middle / middle_count - at_walls / at_walls_count, 0.85 * expected,
                0.15 * expected);
    EXPECT_EQ(simulation->size(), 1280U);
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

TEST(Suction, HoldsANeckTogether) {
    Scene scene = water_scene(90, 2e-5);
    const SphereShape low{{0, -1.25e-3, 0}, {1.2e-3, 1.2e-3, 0}};
    const SphereShape high{{0, 1.25e-3, 0}, {1.2e-3, 1.2e-3, 0}};
    scene.fluid = {{low, {}}, {high, {}}};
    const auto simulation = start(scene);
    EXPECT_LT(largest_energy(*simulation, 0.006), 1.02);
}

} // namespace
} // namespace meniscus
