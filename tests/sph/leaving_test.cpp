#include "small_scenes.hpp"

#include <meniscus/data/particles/particle_arrays.hpp>
#include <meniscus/sph/step/leaving.hpp>

#include <limits>

namespace meniscus {
namespace {

const Domain unit_box{Place{0, 0, 0}, Place{1, 1, 1}};

TEST(Leaving, ABoxOf2DHasNoBoundsAlongZ) {
    EXPECT_TRUE(is_in_domain({0.5, 0.5, 7}, unit_box, 2));
    EXPECT_FALSE(is_in_domain({0.5, 0.5, 7}, unit_box, 3));
    EXPECT_FALSE(is_in_domain({0.5, -0.1, 0}, unit_box, 2));
}

TEST(Leaving, WhatIsNotANumberIsOutside) {
    EXPECT_FALSE(is_in_domain({0.5, std::numeric_limits<double>::quiet_NaN(), 0.5}, unit_box, 3));
}

TEST(Leaving, AHundredthMayLeaveUnlessTheSceneSaysOtherwise) {
    EXPECT_EQ(max_removed(Leaving::few, 1000), 10U);
    EXPECT_EQ(max_removed(Leaving::few, 5), 1U);
    EXPECT_EQ(max_removed(Leaving::remove, 1000), 999U);
    EXPECT_EQ(max_removed(Leaving::stop, 1000), 0U);
}

TEST(Leaving, TakesOutAllOfAParticleAndKeepsTheOrderOfTheOthers) {
    SimulationState state;
    for (std::uint32_t i = 0; i < 4; ++i) {
        const double number = i;
        state.ids.push_back(10 + i);
        state.positions.push_back({i == 1 ? 2 : 0.5, 0.5, 0.5});
        state.velocities.push_back({number, 0, 0});
        state.pressures.push_back(100 * number);
        state.divergences.push_back(-number);
    }
    remove_outside(unit_box, 3, state);
    EXPECT_EQ(state.ids, (std::vector<std::uint32_t>{10, 12, 13}));
    EXPECT_EQ(state.velocities[1], (Place{2, 0, 0}));
    EXPECT_EQ(state.pressures, (std::vector<double>{0, 200, 300}));
    EXPECT_EQ(state.divergences, (std::vector<double>{0, -2, -3}));
    EXPECT_EQ(state.positions.size(), 3U);
}

TEST(Leaving, ParticlesAreRemovedAndCounted) {
    Scene scene = tank_scene(empty_scene(3, "dfsph"), {6, 6, 6}, 4);
    SceneParticles particles = fill_scene(scene);
    particles.positions.push_back({0.3, 1.2, 0.3});
    particles.velocities.assign(particles.positions.size(), {});
    particles.velocities.back() = {0, 20, 0};
    const auto simulation = simulate(scene, particles, 1);
    run_until(*simulation, 0.2);
    EXPECT_EQ(simulation->size(), particles.positions.size() - 1);
    const Snapshot frame = simulation->snapshot();
    EXPECT_EQ(frame.size(), simulation->size());
    EXPECT_EQ(scalar_values(frame, "id").back(), static_cast<double>(simulation->size()) - 1);

    scene.leaving = Leaving::stop;
    const auto stopped = simulate(scene, particles, 1);
    EXPECT_THROW(run_until(*stopped, 0.2), Divergence);
}

TEST(Leaving, MoreThanAHundredthEndsARunThatDoesNotSayOtherwise) {
    Scene scene = tank_scene(empty_scene(3, "dfsph"), {6, 6, 6}, 4);
    SceneParticles particles = fill_scene(scene);
    for (int k = 0; k < 4; ++k) {
        particles.positions.push_back({0.1 + 0.12 * k, 1.2, 0.3});
        particles.velocities.push_back({0, 20, 0});
    }
    EXPECT_THROW(run_until(*simulate(scene, particles, 1), 0.2), Divergence);
    scene.leaving = Leaving::remove;
    const auto simulation = simulate(scene, particles, 1);
    run_until(*simulation, 0.2);
    EXPECT_EQ(simulation->size(), particles.positions.size() - 4);
}

} // namespace
} // namespace meniscus
