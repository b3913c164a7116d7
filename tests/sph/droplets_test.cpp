// Droplets without gravity under our surface tension, coarse: what docs/simulation.md measures at
// length.
#include "simulation/droplet_runs.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace meniscus {
namespace {

double size_of(const Place& vector) {
    return std::sqrt(vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2]);
}

/// A cube of 0.5 m of 10 x 10 x 10 particles.
Scene coarse_cube() {
    Scene scene = stretched_droplet(3, 10);
    scene.name = "cube";
    scene.fluid = {{LatticeShape{{-0.225, -0.225, -0.225}, {10, 10, 10}}, {}}};
    scene.viscosity.kinematic = 0.01;
    scene.duration = 1;
    return scene;
}

TEST(Droplets, OscillateWithLambsPeriod) {
    Scene scene = stretched_droplet(3, 7);
    scene.duration = 1.4; // three zeros
    const Oscillation found = watch_oscillation(scene);
    EXPECT_NEAR(found.theory, 1, 0.05);
    EXPECT_NEAR(found.period / found.theory, 1, 0.1);
}

TEST(Droplets, OscillateInTwoDimensions) {
    Scene scene = stretched_droplet(2, 10);
    scene.duration = 1.4;
    const Oscillation found = watch_oscillation(scene);
    EXPECT_NEAR(found.theory, 1, 0.05);
    EXPECT_NEAR(found.period / found.theory, 1, 0.1);
}

TEST(Droplets, OfACubeGetRoundWithTenSamples) {
    Scene scene = coarse_cube();
    scene.surface_tension.surface.samples = 10;
    scene.surface_tension.surface.verification = Verification::drop;
    const DropletRun run = run_droplet(scene);
    EXPECT_EQ(run.summary.failure, "");
    EXPECT_LT(run.deviation, 0.03); // of the cube 0.125
    EXPECT_LT(run.aspect_ratio, 1.03);
    const double outside = run.radius + scene.particle_spacing / 2;
    EXPECT_NEAR(outside / volume_radius(scene, fill_scene(scene)), 1, 0.05);
}

TEST(Droplets, KeepTheirMomentum) {
    for (const Precision precision : {Precision::float32, Precision::float64}) {
        Scene scene = coarse_cube();
        scene.precision = precision;
        scene.duration = 0.2;
        EXPECT_LT(run_droplet(scene).summary.max_momentum, 1e-6);
        scene.surface_tension.balance_momentum = false;
        scene.surface_tension.surface.samples = 10; // that the option is what keeps it
        EXPECT_GT(run_droplet(scene).summary.max_momentum, 1e-4);
    }
}

/// How far the fluid reaches from the x axis within a spacing of x = 0.
double neck_radius(const SimulationState& state, double spacing) {
    double radius = 0;
    for (const Place& place : state.positions)
        if (std::abs(place[0]) < spacing)
            radius = std::max(radius, size_of({0, place[1], place[2]}));
    return radius;
}

TEST(Droplets, ThatTouchMerge) {
    Scene scene = coarse_cube();
    scene.fluid = {{SphereShape{{-0.225, 0, 0}, {0.2, 0.2, 0.2}}, {}},
                   {SphereShape{{0.225, 0, 0}, {0.2, 0.2, 0.2}}, {}}};
    scene.viscosity.kinematic = 0.05;
    double first = -1;
    double last = 0;
    Positions positions;
    const RunSummary run = watch_run(
        scene, fill_scene(scene),
        [&](const Simulation& simulation, const StepReport&) {
            last = neck_radius(simulation.state(), scene.particle_spacing);
            if (first < 0)
                first = last;
            positions = simulation.state().positions;
        },
        1);
    EXPECT_EQ(run.failure, "");
    EXPECT_LT(first, 0.1);
    EXPECT_GT(last, 0.2);
    EXPECT_LT(aspect_ratio(positions, 3), 1.15); // two balls side by side: above 2
}

TEST(Droplets, AspectRatioOfABox) {
    Positions places;
    for (int i = 0; i < 8; ++i)
        places.push_back({i & 1 ? 3.0 : -3.0, i & 2 ? 2.0 : -2.0, i & 4 ? 1.0 : -1.0});
    EXPECT_NEAR(aspect_ratio(places, 3), 3, 1e-12);
    for (Place& place : places)
        place[2] = 0;
    EXPECT_NEAR(aspect_ratio(places, 2), 1.5, 1e-12);
}

} // namespace
} // namespace meniscus
