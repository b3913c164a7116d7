// A fluid as thin as water under surface tension: waves as short as the spacing must not make
// energy, and what slows them down must leave longer motion alone.
#include "small_scenes.hpp"

namespace meniscus {
namespace {

constexpr double spacing = 1e-4;
constexpr double sigma = 0.072;

/// An ellipse of water in the plane, of the area of a disk of 20 spacings.
Scene ellipse(double stretch) {
    Scene scene = empty_scene(2, "dfsph");
    scene.particle_spacing = spacing;
    scene.support_radius = 2 * spacing;
    scene.time_step.max = default_max_time_step(spacing);
    scene.viscosity.kinematic = 1e-6;
    scene.surface_tension.model = "meniscus";
    scene.surface_tension.coefficient = sigma;
    scene.fluid = {{SphereShape{{0, 0, 0}, {2e-3 * stretch, 2e-3 / stretch, 0}}, {}}};
    scene.domain = {{{-8e-3, -8e-3, 0}, {8e-3, 8e-3, 0}}};
    return scene;
}

double energy_of(const Simulation& simulation) {
    const Balance balance = simulation.balance();
    return balance.kinetic_energy + sigma * balance.surface_area;
}

double width_over_height(const Simulation& simulation) {
    double across = 0, along = 0;
    for (const Place& place : simulation.state().positions) {
        across += place[0] * place[0];
        along += place[1] * place[1];
    }
    return std::sqrt(across / along);
}

TEST(Ripples, ADropThatSwingsWidelyStaysWhole) {
    for (const auto& [solver, name] : all_solvers) {
        if (solver == "wcsph")
            continue; // sound that fast needs steps that take minutes
        SCOPED_TRACE(name);
        Scene scene = ellipse(1.5);
        scene.pressure.solver = solver;
        const auto simulation = start(scene);
        const std::size_t count = simulation->size();
        const double first = energy_of(*simulation);
        double max = 0, narrowest = 10;
        for (int part = 1; part <= 20; ++part) {
            run_until(*simulation, 0.03 * part / 20);
            max = std::max(max, energy_of(*simulation));
            narrowest = std::min(narrowest, width_over_height(*simulation));
        }
        EXPECT_LT(max, 1.005 * first);
        EXPECT_LT(narrowest, 0.6); // it swung through
        EXPECT_EQ(simulation->size(), count);
    }
}

TEST(Ripples, AreSlowedDownWithoutTurningABody) {
    const Scene scene = ellipse(1);
    const SceneParticles particles = fill_scene(scene);
    constexpr double turning = 100; // 1/s
    std::vector<Place> velocities;
    for (const Place& place : particles.positions)
        velocities.push_back({-turning * place[1], turning * place[0], 0});
    const auto simulation = start_at(scene, particles.positions, velocities);
    const auto angular_momentum = [&] {
        const SimulationState state = simulation->state();
        double sum = 0;
        for (std::size_t i = 0; i < state.positions.size(); ++i)
            sum += state.positions[i][0] * state.velocities[i][1] -
                   state.positions[i][1] * state.velocities[i][0];
        return sum;
    };
    const double first = angular_momentum();
    run_until(*simulation, 0.02);
    EXPECT_NEAR(angular_momentum(), first, 1e-3 * first);
    const Balance balance = simulation->balance();
    EXPECT_LT(std::hypot(balance.momentum[0], balance.momentum[1]), 1e-4 * balance.momentum_size);
}

/// What is left of the kinetic energy of a disk whose outermost particles move in and out by turns.
double left_of_ripples(double damping) {
    Scene scene = ellipse(1);
    scene.surface_tension.ripple_damping = damping;
    const SceneParticles particles = fill_scene(scene);
    std::vector<Place> velocities;
    for (const Place& place : particles.positions) {
        const double radius = std::hypot(place[0], place[1]);
        const bool out = std::fmod(std::atan2(place[1], place[0]) + 7, 0.1) < 0.05;
        const double speed = radius > 1.85e-3 ? (out ? 0.2 : -0.2) / radius : 0;
        velocities.push_back({speed * place[0], speed * place[1], 0});
    }
    const auto simulation = start_at(scene, particles.positions, velocities);
    const double first = simulation->balance().kinetic_energy;
    run_until(*simulation, 2e-4);
    return simulation->balance().kinetic_energy / first;
}

TEST(Ripples, DieOut) {
    EXPECT_LT(left_of_ripples(0.3), 0.8 * left_of_ripples(0));
}

} // namespace
} // namespace meniscus
