#include "data/expected_errors.hpp"

#include <meniscus/labeler/directions.hpp>

#include <meniscus/data/errors.hpp>

#include <cmath>
#include <gtest/gtest.h>
#include <set>

namespace meniscus {
namespace {

std::vector<Direction> filled(std::string_view scheme, int dimension, std::size_t count,
                              std::uint64_t seed = 0, std::uint64_t particle = 0) {
    std::vector<Direction> directions(count);
    sampling_scheme(scheme).fill(dimension, seed, particle, directions);
    return directions;
}

TEST(Directions, SquareMapsToTheSphere) {
    constexpr double pi = 3.14159265358979323846;
    for (int a = 0; a < 50; ++a)
        for (int b = 0; b < 97; ++b) {
            const double u = a / 50.0;
            const double v = b / 97.0;
            const auto direction = direction_from_square(3, u, v);
            const double z = 1 - 2 * u;
            EXPECT_NEAR(direction[0], std::sqrt(1 - z * z) * std::cos(2 * pi * v), 1e-15);
            EXPECT_NEAR(direction[1], std::sqrt(1 - z * z) * std::sin(2 * pi * v), 1e-15);
            EXPECT_EQ(direction[2], z);
        }
}

TEST(Directions, HaltonStartsAsPublished) {
    // Bases 2 and 3: (1/2, 1/3), (1/4, 2/3), (3/4, 1/9), ...
    const auto directions = filled("halton", 3, 3);
    EXPECT_EQ(directions[0], direction_from_square(3, 1 / 2.0, 1 / 3.0));
    EXPECT_EQ(directions[1], direction_from_square(3, 1 / 4.0, 2 / 3.0));
    EXPECT_EQ(directions[2], direction_from_square(3, 3 / 4.0, 1 / 9.0));
    EXPECT_EQ(filled("halton", 2, 3)[2], direction_from_square(2, 0, 3 / 4.0));
}

class EveryScheme : public testing::TestWithParam<std::string_view> {};

TEST_P(EveryScheme, GivesEvenlySpreadUnitVectors) {
    for (const int dimension : {2, 3})
        for (const std::uint64_t seed : {0U, 5U}) {
            constexpr std::size_t count = 20000;
            Direction mean{};
            Direction square{};
            for (const auto& direction : filled(GetParam(), dimension, count, seed, 3)) {
                double length = 0;
                for (int axis = 0; axis < 3; ++axis) {
                    mean[axis] += direction[axis] / count;
                    square[axis] += direction[axis] * direction[axis] / count;
                    length += direction[axis] * direction[axis];
                }
                EXPECT_NEAR(length, 1, 1e-14);
            }
            for (int axis = 0; axis < dimension; ++axis) {
                EXPECT_NEAR(mean[axis], 0, 0.02); // five standard errors of random directions
                EXPECT_NEAR(square[axis], 1.0 / dimension, 0.02);
            }
            if (dimension == 2) {
                EXPECT_EQ(square[2], 0);
            }
        }
}

TEST_P(EveryScheme, RepeatsWithTheSeedAndDiffersWithAnother) {
    for (const int dimension : {2, 3}) {
        EXPECT_EQ(filled(GetParam(), dimension, 100, 9, 4),
                  filled(GetParam(), dimension, 100, 9, 4));
        EXPECT_NE(filled(GetParam(), dimension, 100, 9, 4),
                  filled(GetParam(), dimension, 100, 8, 4));
    }
}

TEST_P(EveryScheme, IsKeyedByParticleWhereItSaysSo) {
    const bool differs = filled(GetParam(), 3, 10, 0, 1) != filled(GetParam(), 3, 10, 0, 2);
    EXPECT_EQ(differs, sampling_scheme(GetParam()).per_particle);
}

INSTANTIATE_TEST_SUITE_P(Schemes, EveryScheme, testing::Values("halton", "random"),
                         [](const auto& tested) { return std::string(tested.param); });

TEST(Directions, UnknownSchemeIsRefusedWithTheKnownOnes) {
    EXPECT_EQ(error_of<InputError>([] { sampling_scheme("sobol"); }),
              "unknown sampling scheme 'sobol'; known are halton, random");
}

} // namespace
} // namespace meniscus
