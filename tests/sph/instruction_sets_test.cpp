// The step gives the same bits with every instruction set that this machine has, and with one
// thread as with two.
#include <meniscus/sph/step.hpp>

#include <cmath>
#include <cstring>
#include <functional>
#include <gtest/gtest.h>
#include <numeric>

namespace meniscus {
namespace {

using MakeStep = std::unique_ptr<Step> (*)(const Scene&, const SceneParticles&, int);

/// A drop that falls on a floor, h = 0.1 m, with every force that a scene can have.
Scene drop_scene(int dimension, Precision precision, PressureSolverKind solver,
                 TensionModel model) {
    Scene scene;
    scene.dimension = dimension;
    scene.precision = precision;
    scene.particle_spacing = 0.05;
    scene.support_radius = 0.1;
    scene.gravity = {0, -9.81, 0};
    scene.domain = {{{-2, -2, -2}, {2, 2, 2}}};
    scene.pressure.solver = solver;
    scene.pressure.sound_speed = 20;
    scene.pressure.most_iterations = 8; // the bits are the point, not the density
    scene.viscosity.kinematic = 0.01;
    scene.viscosity.xsph = 0.05;
    scene.viscosity.density_correction = true;
    scene.surface_tension.model = model;
    scene.surface_tension.coefficient = 0.1;
    scene.surface_tension.samples = 32;
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
SimulationState state_after_steps(MakeStep make, const Scene& scene, int threads) {
    const SceneParticles particles = drop_particles(scene);
    const auto step = make(scene, particles, threads);
    SimulationState state;
    if (!step)
        return state;
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
    const SimulationState baseline = state_after_steps(make_step_baseline, scene, 1);
    ASSERT_EQ(baseline.steps, 3U);
    for (const auto& [name, make] :
         {std::pair<const char*, MakeStep>{"avx2", make_step_avx2}, {"avx512", make_step_avx512}}) {
        const SimulationState wide = state_after_steps(make, scene, 1);
        if (!wide.ids.empty()) // a set that this machine has
            expect_same(wide, baseline, name);
    }
}

constexpr std::array<std::pair<PressureSolverKind, const char*>, 4> solvers = {
    {{PressureSolverKind::wcsph, "WCSPH"},
     {PressureSolverKind::pcisph, "PCISPH"},
     {PressureSolverKind::iisph, "IISPH"},
     {PressureSolverKind::dfsph, "DFSPH"}}};

constexpr std::array<std::pair<TensionModel, const char*>, 7> models = {
    {{TensionModel::none, "none"},
     {TensionModel::meniscus, "meniscus"},
     {TensionModel::becker_2007, "Becker"},
     {TensionModel::huber_2015, "Huber"},
     {TensionModel::akinci_2013, "Akinci"},
     {TensionModel::he_2014, "He"},
     {TensionModel::color_field, "color field"}}};

/// Calls body(dimension, precision) for all four.
void for_each_kind(const std::function<void(int, Precision)>& body) {
    for (const int dimension : {2, 3})
        for (const Precision precision : {Precision::float32, Precision::float64})
            body(dimension, precision);
}

TEST(InstructionSets, GiveTheSameBitsWithEachPressureSolver) {
    for (const auto& [solver, name] : solvers)
        for_each_kind([&, solver = solver, name = name](int dimension, Precision precision) {
            SCOPED_TRACE(name);
            expect_same_everywhere(
                drop_scene(dimension, precision, solver, TensionModel::akinci_2013));
        });
}

TEST(InstructionSets, GiveTheSameBitsWithEachSurfaceTension) {
    for (const auto& [model, name] : models)
        for (const KernelKind kernel : {KernelKind::cubic_spline, KernelKind::mueller})
            for_each_kind([&, model = model, name = name](int dimension, Precision precision) {
                SCOPED_TRACE(name);
                Scene scene = drop_scene(dimension, precision, PressureSolverKind::dfsph, model);
                scene.kernel = kernel;
                expect_same_everywhere(scene);
            });
}

TEST(InstructionSets, GiveTheSameBitsWithForcesOnTheSurfaceOnly) {
    for_each_kind([](int dimension, Precision precision) {
        Scene scene =
            drop_scene(dimension, precision, PressureSolverKind::iisph, TensionModel::he_2014);
        scene.surface_tension.restrict_to_surface = true;
        expect_same_everywhere(scene);
    });
}

TEST(InstructionSets, GiveTheSameBitsInShortSteps) {
    for (const auto& [solver, name] : solvers)
        for_each_kind([&, solver = solver, name = name](int dimension, Precision precision) {
            SCOPED_TRACE(name);
            Scene scene = drop_scene(dimension, precision, solver, TensionModel::akinci_2013);
            scene.time_step.fixed = 1e-7;
            expect_same_everywhere(scene);
        });
}

TEST(Steps, GoOnFromAStateAlone) {
    // Of usual length, then short: what a step keeps beside the state must not count.
    for (const auto& [solver, name] : solvers)
        for_each_kind([&, solver = solver, name = name](int dimension, Precision precision) {
            const Scene scene = drop_scene(dimension, precision, solver, TensionModel::akinci_2013);
            const SceneParticles particles = drop_particles(scene);
            SimulationState state = state_after_steps(make_step_baseline, scene, 1);
            SimulationState other = state;
            const auto step = make_step_baseline(scene, particles, 1);
            for (const double longest : {1.0, 1e-7, 1e-7, 1e-7, 1.0}) {
                step->advance(state, longest);
                make_step_baseline(scene, particles, 1)->advance(other, longest);
                expect_same(state, other, name);
            }
        });
}

TEST(Threads, ChangeNoBit) {
    for (const TensionModel model : {TensionModel::meniscus, TensionModel::akinci_2013}) {
        const Scene scene = drop_scene(3, Precision::float32, PressureSolverKind::dfsph, model);
        expect_same(state_after_steps(make_step_baseline, scene, 2),
                    state_after_steps(make_step_baseline, scene, 1), "two threads");
    }
}

TEST(SurfaceTensionModels, OfASceneChangeItsMotion) {
    // Each model is there, and is another than the others.
    std::vector<SimulationState> states;
    for (const auto& [model, name] : models)
        states.push_back(state_after_steps(
            make_step_baseline, drop_scene(3, Precision::float64, PressureSolverKind::dfsph, model),
            1));
    for (std::size_t a = 0; a < states.size(); ++a)
        for (std::size_t b = 0; b < a; ++b)
            EXPECT_FALSE(same_bits(states[a].velocities, states[b].velocities))
                << models[a].second << " and " << models[b].second;
}

} // namespace
} // namespace meniscus
