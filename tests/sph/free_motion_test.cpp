// What a step must get right where hardly anything happens: free fall, particles alone or in one
// place, states that no simulation can start from, two dimensions, and units.
#include "small_scenes.hpp"

#include <meniscus/data/text/errors.hpp>

#include <cstring>
#include <limits>

#include "data/expected_errors.hpp"

namespace meniscus {
namespace {

constexpr std::array<std::string_view, 7> all_models = {
    "none", "meniscus", "becker_2007", "huber_2015", "akinci_2013", "he_2014", "color_field"};

constexpr std::array<Precision, 2> precisions = {Precision::float32, Precision::float64};

TEST(FreeFall, OfALooseDropIsExactForEachParticle) {
    for (const auto& [solver, name] : all_solvers)
        for (const int dimension : {2, 3})
            for (const Precision precision : precisions) {
                SCOPED_TRACE(name);
                Scene scene = drop_scene(empty_scene(dimension, solver, precision), 3);
                scene.volume_share = 0.7; // below the rest density: no pressure
                scene.gravity = {0, -9.81, 0};
                scene.fluid[0].velocity = {0.3, 2, 0};
                scene.time_step.fixed = 0.001;
                scene.domain = {{{-10, -10, -10}, {10, 10, 10}}};
                const auto simulation = start(scene);
                const Positions before = places_by_id(*simulation);
                for (int n = 0; n < 100; ++n)
                    simulation->step(1);
                const Positions after = places_by_id(*simulation);
                // Symplectic Euler: the velocity at the end of each step.
                const double fall = 0.2 - 9.81 * 0.1 * 0.101 / 2;
                const double bound = precision == Precision::float32 ? 2e-6 : 1e-13;
                for (std::size_t i = 0; i < before.size(); ++i) {
                    ASSERT_NEAR(after[i][0] - before[i][0], 0.03, bound);
                    ASSERT_NEAR(after[i][1] - before[i][1], fall, bound);
                    ASSERT_NEAR(after[i][2], before[i][2], bound);
                }
            }
}

TEST(FreeFall, OfACompressedDropIsExactForItsCenter) {
    for (const auto& [solver, name] : all_solvers)
        for (const int dimension : {2, 3}) {
            SCOPED_TRACE(name);
            Scene scene = drop_scene(empty_scene(dimension, solver, Precision::float64), 3);
            scene.volume_share = 1.1;
            scene.gravity = {0, -9.81, 0};
            scene.viscosity = {0.01, true, 0.1};
            scene.surface_tension.model = "meniscus";
            scene.surface_tension.coefficient = 1;
            scene.time_step.fixed = 0.001;
            const auto simulation = start(scene);
            const Place before = simulation->balance().center;
            for (int n = 0; n < 100; ++n)
                simulation->step(1);
            const Balance after = simulation->balance();
            EXPECT_GT(after.kinetic_energy, 0);
            EXPECT_NEAR(after.center[0], before[0], 1e-12);
            EXPECT_NEAR(after.center[1], before[1] - 9.81 * 0.1 * 0.101 / 2, 1e-12);
            EXPECT_NEAR(after.center[2], before[2], 1e-12);
        }
}

/// Velocities and places after some steps are numbers.
void expect_finite(const Simulation& simulation) {
    for (const Place& place : places_by_id(simulation))
        for (const double coordinate : place)
            ASSERT_TRUE(std::isfinite(coordinate));
    for (const Place& velocity : velocities_by_id(simulation))
        for (const double coordinate : velocity)
            ASSERT_TRUE(std::isfinite(coordinate));
}

/// Starts `count` particles in one place, with every solver, every model and every kernel.
void expect_finite_in_one_place(std::size_t count) {
    for (const auto& [solver, name] : all_solvers)
        for (const std::string_view model : all_models)
            for (const KernelKind kernel : {KernelKind::cubic_spline, KernelKind::mueller})
                for (const int dimension : {2, 3}) {
                    SCOPED_TRACE(std::string(name) + ", model " + std::string(model));
                    Scene scene = empty_scene(dimension, solver);
                    scene.kernel = kernel;
                    scene.surface_tension.model = model;
                    scene.surface_tension.coefficient = 0.1;
                    scene.viscosity = {0.01, true, 0.1};
                    scene.time_step.fixed = 0.001;
                    scene.domain = {{{-10, -10, -10}, {10, 10, 10}}};
                    const auto simulation = start_at(scene, Positions(count, Place{0.3, 0.2, 0}),
                                                     std::vector<Place>(count, Place{1, 0, 0}));
                    for (int n = 0; n < 10; ++n)
                        simulation->step(1);
                    expect_finite(*simulation);
                    const Snapshot frame = simulation->snapshot();
                    for (const double density : scalar_values(frame, "density"))
                        ASSERT_GT(density, 0);
                }
}

TEST(Particles, OneIsASimulation) {
    expect_finite_in_one_place(1);
}

TEST(Particles, TwoInOnePlaceStayFinite) {
    expect_finite_in_one_place(2);
}

TEST(Particles, ThatCannotStartAreRefused) {
    const Scene scene = empty_scene(3, "dfsph");
    const double inf = std::numeric_limits<double>::infinity();
    const auto refusal = [&](const Place& place, const Place& velocity) {
        return error_of<InputError>([&] {
            start_at(scene, {{0, 0, 0}, place}, {{0, 0, 0}, velocity});
        });
    };
    for (const double bad : {std::nan(""), inf, -inf})
        for (int axis = 0; axis < 3; ++axis) {
            Place place{1, 1, 1};
            place[axis] = bad;
            expect_mentions(refusal({1, 1, 1}, place), {"particle 1", "velocity", "not finite"});
            expect_mentions(refusal(place, {}), {"particle 1", "position", "not finite"});
        }
    expect_mentions(error_of<InputError>([&] { start_at(scene, {}, {}); }),
                    {"at least one particle"});
    expect_mentions(error_of<InputError>([&] {
                        start_at(scene, {{0, 0, 0}}, {});
                    }),
                    {"differ in length"});
}

TEST(Particles, BeyondWhatTheirNumbersResolveAreRefused) {
    for (const Precision precision : precisions) {
        const Scene scene = empty_scene(3, "dfsph", precision);
        for (const double far : {1e30, 1e300, -1e300})
            expect_mentions(error_of<InputError>([&] {
                                start_at(scene, {{0, 0, 0}, {far, 0, 0}}, {{}, {}});
                            }),
                            {"particle ", "support radii"});
        expect_mentions(error_of<InputError>([&] {
                            start_at(scene, {{0, 0, 0}}, {{}}, {{0, std::nan(""), 0}});
                        }),
                        {"wall particle 0", "not finite"});
    }
}

TEST(Domain, EndsTheRunWhereAParticleLeavesIt) {
    for (const auto& [solver, name] : all_solvers) {
        Scene scene = empty_scene(3, solver);
        scene.domain = {{{-1, -1, -1}, {1, 1, 1}}};
        scene.leaving = Leaving::stop;
        const auto simulation = start_at(scene, {{0, 0, 0}, {0, 0, 0.5}}, {{0, 0, 0}, {0, 0, 10}});
        const std::string message = error_of<Divergence>([&] { run_until(*simulation, 0.2); });
        expect_mentions(message, {"particle 1", "left the domain", "(0, 0, 1"});
        EXPECT_LT(simulation->time(), 0.07);
        expect_mentions(error_of<Divergence>([&] { simulation->step(1); }), {"cannot go on"});
        EXPECT_EQ(find_array(simulation->snapshot(), "density"), nullptr);
    }
}

TEST(Domain, EndsTheRunWhereAVelocityOverflows) {
    for (const Precision precision : precisions) {
        Scene scene = empty_scene(3, "dfsph", precision);
        scene.time_step.fixed = 1e-3;
        const auto simulation =
            start_at(scene, {{0, 0, 0}, {0, 0, 0.1}}, {{0, 0, 0}, {0, 0, 1e300}});
        expect_mentions(error_of<Divergence>([&] { run_until(*simulation, 0.2); }), {"particle"});
    }
}

TEST(TwoDimensions, KeepZAtZero) {
    for (const auto& [solver, name] : all_solvers)
        for (const std::string_view model : all_models) {
            SCOPED_TRACE(name);
            Scene scene = tank_scene(empty_scene(2, solver), {8, 8, 1}, 6);
            scene.fluid[0].velocity = {1, 0.5, 0};
            scene.viscosity = {0.01, true, 0.1};
            scene.surface_tension.model = model;
            scene.surface_tension.coefficient = 0.1;
            scene.time_step.fixed = 0.001;
            const auto simulation = start(scene);
            run_until(*simulation, 0.03);
            for (const Place& place : places_by_id(*simulation))
                ASSERT_EQ(place[2], 0);
            for (const Place& velocity : velocities_by_id(*simulation))
                ASSERT_EQ(velocity[2], 0);
            EXPECT_EQ(simulation->balance().momentum[2], 0);
        }
}

/// A block that falls into a tank with every force, where lengths are `scale` times as large and
/// densities `heavier` times, and times the same: gravity, speeds, viscosity and surface tension
/// are such that without units it is one and the same flow.
std::unique_ptr<Simulation> scaled_flow(int dimension, Precision precision, std::string_view solver,
                                        std::string_view model, double scale, double heavier) {
    Scene scene = empty_scene(dimension, solver, precision);
    scene.particle_spacing *= scale;
    scene.support_radius *= scale;
    scene.rest_density *= heavier;
    scene.pressure.sound_speed *= scale;
    scene = tank_scene(scene, {8, 8, 6}, 6);
    scene.gravity[1] = -9.81 * scale;
    scene.fluid[0].velocity = {0.5 * scale, -0.25 * scale, 0};
    scene.viscosity.kinematic = 0.01 * scale * scale;
    scene.viscosity.xsph = 0.05;
    scene.surface_tension.model = model;
    scene.surface_tension.coefficient = heavier * scale * scale * scale;
    SceneParticles particles = fill_scene(scene);
    for (std::size_t i = 0; i < particles.positions.size(); ++i) // off the lattice, where rounding
        for (int axis = 0; axis < dimension; ++axis)             // decides about neighbors
            particles.positions[i][axis] +=
                0.01 * scale * std::sin(7.0 * static_cast<double>(i) + 3.0 * axis);
    return simulate(scene, particles, 1);
}

/// The largest distance of two runs' particles after `steps`, in m of the first.
double distance_after(Simulation& one, Simulation& other, double scale, int steps) {
    for (int n = 0; n < steps; ++n) {
        one.step(1);
        other.step(1);
    }
    const Positions a = places_by_id(one);
    const Positions b = places_by_id(other);
    double max = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (int axis = 0; axis < 3; ++axis)
            max = std::max(max, std::abs(a[i][axis] - b[i][axis] / scale));
    return max;
}

TEST(Units, OfPowersOfTwoChangeNoBit) {
    for (const auto& [solver, name] : all_solvers)
        for (const Precision precision : precisions)
            for (const int dimension : {2, 3})
                for (const auto& [scale, heavier] :
                     {std::pair{0x1p-20, 1.0}, {0x1p20, 1.0}, {1.0, 0x1p10}}) {
                    SCOPED_TRACE(std::string(name) + ", scale " + std::to_string(scale));
                    const std::string_view model = "meniscus";
                    const auto plain = scaled_flow(dimension, precision, solver, model, 1, 1);
                    const auto scaled =
                        scaled_flow(dimension, precision, solver, model, scale, heavier);
                    EXPECT_EQ(distance_after(*plain, *scaled, scale, 20), 0);
                }
}

TEST(Units, FromMicrometresToMegametresAreTheSameFlow) {
    for (const auto& [solver, name] : all_solvers)
        for (const Precision precision : precisions)
            for (const double support_radius : {1e-6, 1e6}) {
                SCOPED_TRACE(std::string(name) + ", h = " + std::to_string(support_radius));
                const double scale = support_radius / 0.2;
                const auto plain = scaled_flow(3, precision, solver, "meniscus", 1, 1);
                const auto scaled = scaled_flow(3, precision, solver, "meniscus", scale, 1);
                const double bound = precision == Precision::float32 ? 1e-4 : 1e-12;
                EXPECT_LT(distance_after(*plain, *scaled, scale, 20), bound);
            }
}

} // namespace
} // namespace meniscus
