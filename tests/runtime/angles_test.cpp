#include <meniscus/runtime/math/angles.hpp>

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace meniscus {
namespace {

TEST(Angles, ArctangentIsThatOfTheLibrary) {
    for (int k = -100000; k <= 100000; ++k) {
        const double angle = k * (pi / 100000);
        const double x = 3 * std::cos(angle);
        const double y = 3 * std::sin(angle);
        ASSERT_NEAR(arctangent(y, x), std::atan2(y, x), 5e-16) << "at " << angle;
    }
}

TEST(Angles, ArctangentOfAxesAndTinyNumbers) {
    EXPECT_EQ(arctangent(0, 0), 0);
    EXPECT_EQ(arctangent(0, 2), 0);
    EXPECT_EQ(arctangent(2, 0), pi / 2);
    EXPECT_EQ(arctangent(-2, 0), -pi / 2);
    EXPECT_EQ(arctangent(0, -1), pi);
    EXPECT_DOUBLE_EQ(arctangent(1e-300, 1), 1e-300);
    EXPECT_DOUBLE_EQ(arctangent(1e-200, -1), pi);
}

TEST(Angles, CosineAndSineAreThoseOfTheLibrary) {
    for (int k = 0; k < 100000; ++k) {
        const double turn = k / 100000.0;
        const auto [cosine, sine] = cosine_and_sine_of_turn(turn);
        ASSERT_NEAR(cosine, std::cos(2 * pi * turn), 1e-15) << "at " << turn;
        ASSERT_NEAR(sine, std::sin(2 * pi * turn), 1e-15) << "at " << turn;
    }
}

TEST(Angles, TurnOrderGrowsWithTheAngle) {
    double before = -std::numeric_limits<double>::infinity();
    for (int k = -5000; k <= 4999; ++k) {
        const double angle = (k + 0.5) * (pi / 5000);
        const double turn = turn_order(0.1 * std::cos(angle), 0.1 * std::sin(angle));
        ASSERT_GT(turn, before);
        ASSERT_GE(turn, -2);
        ASSERT_LE(turn, 2);
        before = turn;
    }
}

TEST(Angles, UnitVectorIsAtItsTurnOrder) {
    for (int k = -199; k < 200; ++k) {
        const double turn = k * 0.01;
        const auto vector = unit_vector(turn);
        EXPECT_NEAR(turn_order(vector[0], vector[1]), turn, 1e-15);
        EXPECT_NEAR(vector[0] * vector[0] + vector[1] * vector[1], 1, 1e-15);
        const auto a_turn_later = unit_vector(turn + 4);
        EXPECT_NEAR(a_turn_later[0], vector[0], 1e-14);
        EXPECT_NEAR(a_turn_later[1], vector[1], 1e-14);
    }
}

} // namespace
} // namespace meniscus
