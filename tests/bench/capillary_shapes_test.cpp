#include "simulation/capillary_shapes.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <meniscus/runtime/math/angles.hpp>
#include <stdexcept>

namespace meniscus {
namespace {

TEST(CapillaryShapes, ASmallDropIsACap) {
    for (const double angle : {pi / 6, pi / 2, 5 * pi / 6}) {
        const double area = angle - std::sin(angle) * std::cos(angle); // of radius 1
        const SessileDrop flat = sessile_drop(2, angle, 1000, area);
        EXPECT_NEAR(flat.height, 1 - std::cos(angle), 1e-5);
        EXPECT_NEAR(flat.contact_radius, std::sin(angle), 1e-5);
        const double cosine = std::cos(angle);
        const double volume = pi / 3 * (2 + cosine) * (1 - cosine) * (1 - cosine);
        const SessileDrop round = sessile_drop(3, angle, 1000, volume);
        EXPECT_NEAR(round.height, 1 - cosine, 1e-5);
        EXPECT_NEAR(round.max_radius, angle > pi / 2 ? 1 : std::sin(angle), 1e-5);
    }
}

TEST(CapillaryShapes, APuddleIsAsHighAsQuinckeSays) {
    const double angle = 2 * pi / 3;
    EXPECT_NEAR(sessile_drop(2, angle, 1, 400).height, 2 * std::sin(angle / 2), 1e-4);
}

TEST(CapillaryShapes, AMeniscusInAWideTankIsThatOfOneWall) {
    const double angle = pi / 3;
    const double height = std::sqrt(2 * (1 - std::sin(angle)));
    EXPECT_NEAR(plate_meniscus(angle, 1, 30, 0).rise, height, 1e-4);
    EXPECT_NEAR(plate_meniscus(pi - angle, 1, 30, 0).rise, -height, 1e-4);
    EXPECT_NEAR(plate_meniscus(angle, 1, 30, 0).middle, 0, 1e-4);
}

TEST(CapillaryShapes, BetweenNearPlatesItRisesAsJurinSays) {
    const double angle = pi / 3, gap = 0.01;
    EXPECT_NEAR(plate_meniscus(angle, 1, gap, 0).middle, 2 * std::cos(angle) / gap, 0.01);
    EXPECT_EQ(plate_meniscus(pi / 2, 1, gap, 0).middle, 0);
}

TEST(CapillaryShapes, RefuseWhatIsNoShape) {
    EXPECT_THROW(sessile_drop(2, pi, 1, 1), std::invalid_argument);
    EXPECT_THROW(sessile_drop(3, 1, 1, 0), std::invalid_argument);
    EXPECT_THROW(plate_meniscus(1, 1, 1, 0.5), std::invalid_argument);
}

} // namespace
} // namespace meniscus
