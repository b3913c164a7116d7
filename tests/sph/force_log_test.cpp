// What a run logs of forces, and samples that follow the time step.
#include "small_scenes.hpp"

#include "data/test_folder.hpp"

#include <meniscus/data/text/files.hpp>
#include <meniscus/sph/run/run.hpp>

#include <cmath>

namespace meniscus {
namespace {

double mean_size(const std::vector<Place>& velocities) {
    double sum = 0;
    for (const Place& velocity : velocities)
        sum += std::hypot(velocity[0], velocity[1], velocity[2]);
    return sum / static_cast<double>(velocities.size());
}

Scene logging(Scene scene) {
    scene.log.forces = true;
    scene.time_step.fixed = 1e-3;
    return scene;
}

TEST(ForceLog, TensionIsWhatMovesAPair) {
    Scene scene = logging(empty_scene(3, "wcsph", Precision::float64));
    scene.surface_tension.model = "becker_2007";
    scene.surface_tension.coefficient = 0.5;
    scene.domain = {{{-5, -5, -5}, {5, 5, 5}}};
    const auto simulation = start_at(scene, {{0, 0, 0}, {0.12, 0, 0}}, {{0, 0, 0}, {0, 0, 0}});
    const StepReport report = simulation->step(1);
    const double mass = scene.rest_density * std::pow(scene.particle_spacing, 3);
    const double force = mass * mean_size(velocities_by_id(*simulation)) / report.time_step;
    EXPECT_GT(force, 0);
    EXPECT_NEAR(report.tension_forces.mean, force, 1e-9 * force);
    EXPECT_NEAR(report.tension_forces.deviation, 0, 1e-9 * force);
    EXPECT_EQ(report.pressure_forces.mean, 0);
}

TEST(ForceLog, PressureIsWhatMovesACompressedBlock) {
    for (const NamedSolver& solver : all_solvers) {
        Scene scene = logging(empty_scene(3, solver.kind, Precision::float64));
        scene.domain = {{{-5, -5, -5}, {5, 5, 5}}};
        Positions places;
        for (int i = 0; i < 5; ++i)
            for (int j = 0; j < 5; ++j)
                for (int k = 0; k < 5; ++k)
                    places.push_back({0.098 * i, 0.098 * j, 0.098 * k});
        const auto simulation = start_at(scene, places, std::vector<Place>(places.size(), Place{}));
        const StepReport report = simulation->step(1);
        const double mass = scene.rest_density * std::pow(scene.particle_spacing, 3);
        const double force = mass * mean_size(velocities_by_id(*simulation)) / report.time_step;
        EXPECT_GT(force, 0) << solver.name;
        EXPECT_NEAR(report.pressure_forces.mean, force, 1e-6 * force) << solver.name;
        EXPECT_GT(report.pressure_forces.deviation, 0) << solver.name;
        EXPECT_EQ(report.tension_forces.mean, 0) << solver.name;
    }
}

TEST(ForceLog, LookingChangesNoBit) {
    for (const NamedSolver& solver : all_solvers) {
        Scene scene = drop_scene(empty_scene(3, solver.kind), 3);
        scene.surface_tension.model = "meniscus";
        scene.surface_tension.coefficient = 10;
        const auto plain = start(scene);
        scene.log.forces = true;
        const auto logged = start(scene);
        run_until(*plain, 0.02);
        run_until(*logged, 0.02);
        EXPECT_EQ(places_by_id(*plain), places_by_id(*logged)) << solver.name;
    }
}

class Logs : public TestFolder {};

TEST_F(Logs, HaveTheColumnsThatASceneAsksFor) {
    Scene scene = drop_scene(empty_scene(2, "iisph"), 3);
    scene.duration = scene.frame_interval = 0.01;
    RunOptions options;
    options.folder = folder;
    run_scene(scene, options);
    const auto log = [&] { return read_whole(log_file(scene, folder)); };
    EXPECT_EQ(log().find("tension_force"), std::string::npos);
    EXPECT_NE(log().find("mean_speed"), std::string::npos);
    scene.log = {true, true};
    options.restart = true;
    run_scene(scene, options);
    EXPECT_NE(log().find("pressure_force_deviation,bodies,largest_body"), std::string::npos);
}

/// A drop that surface tension pulls at, after some steps of 1 ms.
Positions pulled_drop(double sampling_density, std::size_t samples) {
    Scene scene = drop_scene(empty_scene(3, "iisph"), 3);
    scene.surface_tension.model = "meniscus";
    scene.surface_tension.coefficient = 10;
    scene.surface_tension.sampling_density = sampling_density;
    scene.surface_tension.min_samples = 32;
    scene.surface_tension.surface.samples = samples;
    scene.time_step.fixed = 1e-3;
    const auto simulation = start(scene);
    for (int n = 0; n < 3; ++n)
        simulation->step(1);
    (void)simulation->balance(); // looks at the surface
    simulation->step(1);
    return places_by_id(*simulation);
}

TEST(SamplingDensity, TimesTheStepIsTheNumberOfSamples) {
    EXPECT_EQ(pulled_drop(64'001, 16), pulled_drop(0, 64));
    EXPECT_NE(pulled_drop(128'001, 16), pulled_drop(0, 64));
}

TEST(SamplingDensity, LeavesTheLeast) {
    EXPECT_EQ(pulled_drop(1'000, 16), pulled_drop(0, 32));
}

} // namespace
} // namespace meniscus
