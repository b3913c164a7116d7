// Longer runs of droplets: that they come to the shape and the rest that they should.
#include "simulation/droplet_runs.hpp"

#include <gtest/gtest.h>

namespace meniscus {
namespace {

const std::filesystem::path scenes = MENISCUS_SCENES;

TEST(DropletValidation, CubeBecomesABall) {
    for (const char* radius : {"0.1", "0.125"}) {
        const Scene scene = read_scene(scenes / "drop_formation.json", "",
                                       {std::string("support_radius=") + radius});
        const DropletRun run = run_droplet(scene);
        EXPECT_EQ(run.summary.failure, "") << radius;
        EXPECT_LT(run.deviation, 0.01) << radius;
        EXPECT_LT(run.speed, 0.03 * run.capillary_speed) << radius;
        EXPECT_TRUE(run.equilibrium) << radius;
    }
}

TEST(DropletValidation, TwoCubesBecomeABall) {
    const Scene scene =
        read_scene(scenes / "double_droplet.json", "", {"duration=6", "viscosity.kinematic=0.1"});
    const DropletRun run = run_droplet(scene);
    EXPECT_EQ(run.summary.failure, "");
    EXPECT_LT(run.deviation, 0.02);
    EXPECT_LT(run.aspect_ratio, 1.03);
}

TEST(DropletValidation, OscillatesWithLambsPeriodUnderEachSolver) {
    for (const char* const solver : {"wcsph", "pcisph", "iisph", "dfsph"}) {
        Scene scene = stretched_droplet(3, 10);
        scene.pressure.solver = solver;
        const Oscillation found = watch_oscillation(scene);
        EXPECT_NEAR(found.period / found.theory, 1, 0.1) << solver;
    }
}

} // namespace
} // namespace meniscus
