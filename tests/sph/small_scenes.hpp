// Small scenes for the tests of whole steps: all have a spacing of 0.1 m and h = 0.2 m unless a
// test says otherwise, run on one thread, and are moved by a Simulation as `meniscus simulate` does
// it.
#pragma once

#include <meniscus/sph/step/simulation.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <string>

namespace meniscus {

struct NamedSolver {
    std::string_view kind;
    const char* name;
};
inline constexpr std::array<NamedSolver, 4> all_solvers = {
    {{"wcsph", "WCSPH"}, {"pcisph", "PCISPH"}, {"iisph", "IISPH"}, {"dfsph", "DFSPH"}}};

/// A scene without fluid, walls and gravity.
inline Scene empty_scene(int dimension, std::string_view solver,
                         Precision precision = Precision::float32) {
    Scene scene;
    scene.name = "small";
    scene.dimension = dimension;
    scene.precision = precision;
    scene.particle_spacing = 0.1;
    scene.support_radius = 0.2;
    scene.duration = 1;
    scene.frame_interval = 0.1;
    scene.pressure.solver = solver;
    scene.pressure.sound_speed = 40;
    scene.time_step.max = 0.005;
    return scene;
}

/// A box of whole numbers of spacings from the origin on, or from `low`.
inline BoxShape box_of(const Scene& scene, const std::array<int, 3>& count, const Place& low = {}) {
    BoxShape box;
    box.low = low;
    for (int axis = 0; axis < scene.dimension; ++axis)
        box.high[axis] = low[axis] + count[axis] * scene.particle_spacing;
    return box;
}

/// A tank of so many spacings, filled to `depth` (in spacings), open above, under gravity.
inline Scene tank_scene(Scene scene, const std::array<int, 3>& count, int depth) {
    scene.gravity = {0, -9.81, 0};
    scene.fluid = {{box_of(scene, {count[0], depth, count[2]}), {}}};
    BoxShape tank = box_of(scene, count);
    for (int axis = 0; axis < scene.dimension; ++axis) {
        tank.low[axis] -= scene.particle_spacing / 2;
        tank.high[axis] += scene.particle_spacing / 2;
    }
    tank.open = {"+y"};
    scene.walls = {tank};
    return scene;
}

/// A ball (in 2D a disk) of so many spacings radius around the origin.
inline Scene drop_scene(Scene scene, double radius) {
    SphereShape ball;
    for (int axis = 0; axis < scene.dimension; ++axis)
        ball.half_axes[axis] = radius * scene.particle_spacing;
    scene.fluid = {{ball, {}}};
    scene.domain = {{{-10, -10, -10}, {10, 10, 10}}};
    return scene;
}

inline std::unique_ptr<Simulation> start(const Scene& scene) {
    return simulate(scene, fill_scene(scene), 1);
}

/// Starts particles of a mass of rest_density spacing^D from places and velocities.
inline std::unique_ptr<Simulation> start_at(const Scene& scene, Positions places,
                                            std::vector<Place> velocities,
                                            const Positions& walls = {}) {
    SceneParticles particles;
    particles.positions = std::move(places);
    particles.velocities = std::move(velocities);
    particles.walls = walls;
    particles.mass = scene.rest_density * std::pow(scene.particle_spacing, scene.dimension);
    return simulate(scene, particles, 1);
}

/// Steps until `time`; calls look(report) after each.
template <class Look>
void run_until(Simulation& simulation, double time, const Look& look) {
    while (simulation.time() < time - 1e-9)
        look(simulation.step(time - simulation.time()));
}
inline void run_until(Simulation& simulation, double time) {
    run_until(simulation, time, [](const StepReport&) {});
}

/// The state's places in the order of ids.
inline Positions places_by_id(const Simulation& simulation) {
    const SimulationState state = simulation.state();
    Positions places(state.positions.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        places[state.ids[i]] = state.positions[i];
    return places;
}

inline std::vector<Place> velocities_by_id(const Simulation& simulation) {
    const SimulationState state = simulation.state();
    std::vector<Place> velocities(state.velocities.size());
    for (std::size_t i = 0; i < velocities.size(); ++i)
        velocities[state.ids[i]] = state.velocities[i];
    return velocities;
}

} // namespace meniscus
