// The step gives the same bits with every instruction set that this machine has, and with one
// thread as with two.
#include <meniscus/sph/scene/methods.hpp>
#include <meniscus/sph/step/step.hpp>

#include <cmath>
#include <cstring>
#include <functional>
#include <gtest/gtest.h>
#include <numeric>

namespace meniscus {
namespace {

/// A drop that falls on a floor, h = 0.1 m, with every force that a scene can have.
Scene drop_scene(int dimension, Precision precision, std::string_view solver,
                 std::string_view model) {
    Scene scene;
    scene.dimension = dimension;
    scene.precision = precision;
    scene.particle_spacing = 0.05;
    scene.support_radius = 0.1;
    scene.gravity = {0, -9.81, 0};
    scene.domain = {{{-2, -2, -2}, {2, 2, 2}}};
    scene.pressure.solver = solver;
    scene.pressure.sound_speed = 20;
    scene.pressure.max_iterations = 8; // the bits are the point, not the density
    scene.viscosity.kinematic = 0.01;
    scene.viscosity.xsph = 0.05;
    scene.viscosity.density_correction = true;
    scene.surface_tension.model = model;
    scene.surface_tension.coefficient = 0.1;
    scene.surface_tension.surface.samples = 32;
    scene.time_step.fixed = 0.001;
    return scene;
}

SceneParticles drop_particles(const Scene& scene) {
    const int depth = scene.dimension == 3 ? 1 : 0;
    const double spacing = scene.particle_spacing;
    SceneParticles particles;
    particles.mass = scene.rest_density * std::pow(spacing, scene.dimension);
    for (int x = -4; x <= 4; ++x)
        for (int y = 0; y <= 8; ++y)
            for (int z = -4 * depth; z <= 4 * depth; ++z) {
                // Off the lattice, so that sums round.
                const double bend = 0.1 * spacing * std::sin(3.0 * x + 5.0 * y + 7.0 * z);
                particles.positions.push_back(
                    {spacing * x + bend, spacing * y - bend, spacing * z + bend * depth});
            }
    particles.velocities.assign(particles.positions.size(), {0.3, -1, 0.1 * depth});
    for (int x = -8; x <= 8; ++x)
        for (int z = -8 * depth; z <= 8 * depth; ++z)
            particles.walls.push_back({spacing * x, -spacing, spacing * z});
    return particles;
}

/// After three steps, in the order that the step keeps.
SimulationState state_after_steps(const Scene& scene, int threads,
                                  InstructionSet set = InstructionSet::baseline) {
    const SceneParticles particles = drop_particles(scene);
    const auto step = make_step(scene, particles, threads, set);
    SimulationState state;
    const std::size_t count = particles.positions.size();
    state.positions = particles.positions;
    state.velocities = particles.velocities;
    state.ids.resize(count);
    std::iota(state.ids.begin(), state.ids.end(), 0U);
    state.pressures.assign(count, 0);
    state.divergences.assign(count, 0);
    for (int n = 0; n < 3; ++n)
        step->advance(state, 1);
    return state;
}

template <class Value>
bool same_bits(const std::vector<Value>& a, const std::vector<Value>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0;
}

void expect_same(const SimulationState& a, const SimulationState& b, const char* which) {
    EXPECT_EQ(a.ids, b.ids) << which;
    EXPECT_TRUE(same_bits(a.positions, b.positions)) << which;
    EXPECT_TRUE(same_bits(a.velocities, b.velocities)) << which;
    EXPECT_TRUE(same_bits(a.pressures, b.pressures)) << which;
    EXPECT_TRUE(same_bits(a.divergences, b.divergences)) << which;
}

void expect_same_everywhere(const Scene& scene) {
    const SimulationState baseline = state_after_steps(scene, 1);
    ASSERT_EQ(baseline.steps, 3U);
    for (const InstructionSet set : instruction_sets)
        if (set != InstructionSet::baseline && is_supported(set))
            expect_same(state_after_steps(scene, 1, set), baseline, name_of(set));
}

/// All models of surface tension, and none.
std::vector<std::string> tension_names() {
    std::vector<std::string> names{"none"};
    for (const TensionModelRow& model : tension_models())
        names.emplace_back(model.name);
    return names;
}

/// Calls body(dimension, precision) for all four.
void for_each_kind(const std::function<void(int, Precision)>& body) {
    for (const int dimension : {2, 3})
        for (const Precision precision : {Precision::float32, Precision::float64})
            body(dimension, precision);
}

TEST(InstructionSets, GiveTheSameBitsWithEachPressureSolver) {
    for (const PressureSolverRow& row : pressure_solvers())
        for_each_kind([&, solver = row.name](int dimension, Precision precision) {
            SCOPED_TRACE(solver);
            expect_same_everywhere(drop_scene(dimension, precision, solver, "akinci_2013"));
        });
}

TEST(InstructionSets, GiveTheSameBitsWithEachSurfaceTension) {
    for (const std::string& model : tension_names())
        for (const KernelKind kernel : {KernelKind::cubic_spline, KernelKind::mueller})
            for_each_kind([&](int dimension, Precision precision) {
                SCOPED_TRACE(model);
                Scene scene = drop_scene(dimension, precision, "dfsph", model);
                scene.kernel = kernel;
                expect_same_everywhere(scene);
            });
}

TEST(InstructionSets, GiveTheSameBitsWithForcesOnTheSurfaceOnly) {
    for_each_kind([](int dimension, Precision precision) {
        Scene scene = drop_scene(dimension, precision, "iisph", "he_2014");
        scene.surface_tension.restrict_to_surface = true;
        expect_same_everywhere(scene);
    });
}

TEST(InstructionSets, GiveTheSameBitsInShortSteps) {
    for (const PressureSolverRow& row : pressure_solvers())
        for_each_kind([&, solver = row.name](int dimension, Precision precision) {
            SCOPED_TRACE(solver);
            Scene scene = drop_scene(dimension, precision, solver, "akinci_2013");
            scene.time_step.fixed = 1e-7;
            expect_same_everywhere(scene);
        });
}

TEST(Steps, GoOnFromAStateAlone) {
    // Of usual length, then short: what a step keeps beside the state must not count.
    for (const PressureSolverRow& row : pressure_solvers())
        for_each_kind([&, solver = row.name](int dimension, Precision precision) {
            const Scene scene = drop_scene(dimension, precision, solver, "akinci_2013");
            const SceneParticles particles = drop_particles(scene);
            SimulationState state = state_after_steps(scene, 1);
            SimulationState other = state;
            const auto step = make_step(scene, particles, 1, InstructionSet::baseline);
            for (const double longest : {1.0, 1e-7, 1e-7, 1e-7, 1.0}) {
                step->advance(state, longest);
                make_step(scene, particles, 1, InstructionSet::baseline)->advance(other, longest);
                expect_same(state, other, solver);
            }
        });
}

TEST(Threads, ChangeNoBit) {
    for (const std::string_view model : {"meniscus", "akinci_2013"}) {
        const Scene scene = drop_scene(3, Precision::float32, "dfsph", model);
        expect_same(state_after_steps(scene, 2), state_after_steps(scene, 1), "two threads");
    }
}

TEST(SurfaceTensionModels, OfASceneChangeItsMotion) {
    // Each model is there, and is another than the others.
    std::vector<SimulationState> states;
    const std::vector<std::string> models = tension_names();
    for (const std::string& model : models)
        states.push_back(state_after_steps(drop_scene(3, Precision::float64, "dfsph", model), 1));
    for (std::size_t a = 0; a < states.size(); ++a)
        for (std::size_t b = 0; b < a; ++b)
            EXPECT_FALSE(same_bits(states[a].velocities, states[b].velocities))
                << models[a] << " and " << models[b];
}

} // namespace
} // namespace meniscus
