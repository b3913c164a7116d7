#include "small_scenes.hpp"

#include <meniscus/sph/scene/methods.hpp>
#include <meniscus/sph/step/time_step.hpp>

#include <cmath>

namespace meniscus {
namespace {

/// A scene that no other condition bounds.
Scene free_scene() {
    Scene scene;
    scene.particle_spacing = 0.01;
    scene.support_radius = 0.02;
    scene.gravity = {0, 0, 0};
    scene.viscosity.kinematic = 0;
    scene.time_step.max = 1;
    scene.time_step.min = 0;
    scene.time_step.courant_factor = 1;
    return scene;
}

TEST(TimeStep, MovesTheFastestParticleByTwoFifthsOfASpacing) {
    const Scene scene = free_scene();
    const double speed = 3; // support radii a second
    const double step = time_step_for(scene, speed, 0, 1);
    EXPECT_DOUBLE_EQ(step * speed * scene.support_radius, 0.4 * scene.particle_spacing);
}

TEST(TimeStep, IsShorterWhereParticlesAreAccelerated) {
    const Scene scene = free_scene();
    const double acceleration = 1e4; // support radii over s^2
    EXPECT_DOUBLE_EQ(time_step_for(scene, 0, acceleration, 1), 0.4 * std::sqrt(0.5 / acceleration));
}

TEST(TimeStep, KeepsToTheBoundsOfTheScene) {
    Scene scene = free_scene();
    scene.time_step.min = 0.01;
    EXPECT_EQ(time_step_for(scene, 1000, 0, 1), 0.01);
    EXPECT_EQ(time_step_for(scene, 1000, 0, 0.004), 0.004);
    scene.time_step.fixed = 0.02;
    EXPECT_EQ(time_step_for(scene, 1000, 0, 1), 0.02);
}

TEST(TimeStep, LeavesAShortStepMoreTimeToSolve) {
    const Scene scene = free_scene();
    const double stable = 0.4 * 0.5 / 10; // at ten support radii a second
    EXPECT_FALSE(is_short_step(scene, stable / 4, 10));
    EXPECT_DOUBLE_EQ(solve_time(scene, stable / 4, 10), stable / 4);
    EXPECT_TRUE(is_short_step(scene, stable / 16, 10));
    EXPECT_DOUBLE_EQ(solve_time(scene, stable / 16, 10), stable / 4);
    EXPECT_DOUBLE_EQ(solve_time(scene, stable / 1000, 10), stable);
}

TEST(TimeStep, IsBoundByGravityAndSpacing) {
    Scene scene = tank_scene(empty_scene(3, "dfsph"), {6, 6, 6}, 4);
    EXPECT_NEAR(longest_stable_step(scene), 0.075 * std::sqrt(0.1 / 9.81), 1e-9);
    EXPECT_EQ(default_max_time_step(0.1), 5e-3);
    EXPECT_EQ(default_max_time_step(0.002), 1e-3);
}

} // namespace
} // namespace meniscus
