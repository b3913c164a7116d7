#include "data/expected_errors.hpp"

#include <meniscus/labeler/sampling/directions.hpp>

#include <meniscus/data/text/errors.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <map>

namespace meniscus {
namespace {

std::vector<Direction> filled(std::string_view scheme, int dimension, std::size_t count,
                              std::uint64_t seed = 0, std::uint64_t particle = 0) {
    std::vector<Direction> directions(count);
    sampling_scheme(scheme).fill(dimension, seed, particle, directions);
    return directions;
}

double distance(const Direction& a, const Direction& b) {
    double square = 0;
    for (int axis = 0; axis < 3; ++axis)
        square += (a[axis] - b[axis]) * (a[axis] - b[axis]);
    return std::sqrt(square);
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

TEST(Directions, HaltonInOtherBases) {
    EXPECT_EQ(filled("halton-2-3", 3, 1000, 4), filled("halton", 3, 1000, 4));
    EXPECT_EQ(filled("halton-2-3", 2, 1000, 4), filled("halton", 2, 1000, 4));
    // Bases 5 and 7: (1/5, 1/7), ..., (1/25, 5/7).
    EXPECT_EQ(filled("halton-5-7", 3, 5)[0], direction_from_square(3, 1 / 5.0, 1 / 7.0));
    EXPECT_EQ(filled("halton-5-7", 3, 5)[4], direction_from_square(3, 1 / 25.0, 5 / 7.0));
    EXPECT_EQ(filled("halton-5-7", 2, 5)[4], direction_from_square(2, 0, 1 / 25.0));
    EXPECT_EQ(filled("halton-31-29", 3, 1)[0], direction_from_square(3, 1 / 31.0, 1 / 29.0));
    for (const char* name : {"halton-2-2", "halton-2-4", "halton-1-2", "halton-2-37", "halton-02-3",
                             "halton-2", "halton-2-3-5", "halton--2-3"})
        EXPECT_THROW(sampling_scheme(name), InputError) << name;
}

class EveryScheme : public testing::TestWithParam<const char*> {};

TEST_P(EveryScheme, GivesUnitVectors) {
    for (const int dimension : {2, 3})
        for (const std::size_t count : {1, 2, 10, 16384, 20000})
            for (const std::uint64_t seed : {0, 5}) {
                for (const auto& direction : filled(GetParam(), dimension, count, seed, 3)) {
                    ASSERT_NEAR(distance(direction, {0, 0, 0}), 1, 1e-15);
                    if (dimension == 2) {
                        ASSERT_EQ(direction[2], 0);
                    }
                }
            }
}

TEST_P(EveryScheme, SpreadsEvenly) {
    for (const int dimension : {2, 3})
        for (const std::size_t count : {16384, 20000})
            for (const std::uint64_t seed : {0, 5}) {
                Direction mean{};
                Direction square{};
                Direction mixed{}; // x y, y z, z x
                for (const auto& direction : filled(GetParam(), dimension, count, seed, 3))
                    for (int axis = 0; axis < 3; ++axis) {
                        const double share = direction[axis] / static_cast<double>(count);
                        mean[axis] += share;
                        square[axis] += share * direction[axis];
                        mixed[axis] += share * direction[(axis + 1) % 3];
                    }
                // Four standard errors of random directions.
                const double bound = 4 / std::sqrt(dimension * 16384.0);
                for (int axis = 0; axis < dimension; ++axis) {
                    EXPECT_NEAR(mean[axis], 0, bound);
                    EXPECT_NEAR(square[axis], 1.0 / dimension, bound);
                    EXPECT_NEAR(mixed[axis], 0, bound);
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

/// Writes the name of a scheme as the name of a test.
std::string test_name(const testing::TestParamInfo<const char*>& tested) {
    std::string name = tested.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Schemes, EveryScheme,
                         testing::Values("halton", "halton-5-7", "random", "table", "blue-noise"),
                         test_name);

/// Largest difference between the share of directions in a cap and the cap's share of the sphere,
/// over 200 centers and 200 heights.
double cap_discrepancy(const std::vector<Direction>& directions) {
    constexpr int heights = 200;
    double max = 0;
    for (const auto& center : filled("random", 3, 200, 12345)) {
        std::vector<std::size_t> slices(heights);
        for (const auto& p : directions) {
            const double along = p[0] * center[0] + p[1] * center[1] + p[2] * center[2];
            ++slices[std::min(heights - 1, static_cast<int>((along + 1) / 2 * heights))];
        }
        double below = 0;
        for (int height = 0; height < heights; ++height) {
            below += static_cast<double>(slices[height]) / static_cast<double>(directions.size());
            max = std::max(max, std::abs(below - (height + 1.0) / heights));
        }
    }
    return max;
}

TEST(Directions, EvenSchemesAreMoreEvenThanRandomOnes) {
    for (const std::uint64_t seed : {0, 1, 2})
        for (const std::size_t count : {300, 3000, 20000}) {
            const double random = cap_discrepancy(filled("random", 3, count, seed));
            EXPECT_LT(cap_discrepancy(filled("halton", 3, count, seed)), random * 0.7);
            EXPECT_LT(cap_discrepancy(filled("blue-noise", 3, count, seed)), random * 0.7);
        }
}

/// Smallest distance between two directions, in distances that all could keep.
double min_spacing(const std::vector<Direction>& directions, int dimension) {
    const double pi = 3.14159265358979323846;
    const auto count = static_cast<double>(directions.size());
    const double full =
        dimension == 2 ? 2 * pi / count : std::sqrt(8 * pi / (std::sqrt(3.0) * count));
    double min = 4;
    for (std::size_t i = 0; i < directions.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            min = std::min(min, distance(directions[i], directions[j]));
    return min / full;
}

TEST(Directions, BlueNoiseKeepsItsDistance) {
    for (const int dimension : {2, 3})
        for (const std::uint64_t seed : {0, 1, 2})
            for (const std::size_t count : {2, 10, 100, 3000}) {
                const double spacing =
                    min_spacing(filled("blue-noise", dimension, count, seed), dimension);
                EXPECT_GT(spacing, 0.6) << dimension << "D, " << count;
                if (count >= 100) {
                    EXPECT_LT(min_spacing(filled("random", dimension, count, seed), dimension),
                              0.3);
                    EXPECT_LT(spacing, 0.95); // no lattice either
                }
            }
}

TEST(Directions, TableIsReadInSlicesAndRepeats) {
    for (const int dimension : {2, 3}) {
        const auto one = filled("table", dimension, 20000, 6, 1);
        const auto other = filled("table", dimension, 16384, 6, 2);
        for (std::size_t k = 16384; k < one.size(); ++k)
            ASSERT_EQ(one[k], one[k - 16384]);
        const auto start = std::find(one.begin(), one.end(), other[0]);
        ASSERT_NE(start, one.end());
        for (std::size_t k = 0; k < other.size(); ++k)
            ASSERT_EQ(other[k], one[(start - one.begin() + k) % 16384]);
    }
}

/// FNV-1a over the bits of all coordinates.
std::uint64_t hash_of(const std::vector<Direction>& directions) {
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    for (const Direction& direction : directions)
        for (const double coordinate : direction) {
            std::uint64_t bits = 0;
            std::memcpy(&bits, &coordinate, sizeof bits);
            for (int byte = 0; byte < 8; ++byte)
                hash = (hash ^ (bits >> (8 * byte) & 0xff)) * 0x100000001b3ULL;
        }
    return hash;
}

TEST(Directions, AreTheSameBitsOnEveryMachine) {
    const std::map<std::string, std::array<std::uint64_t, 2>> hashes = {
        {"halton", {0x7d648e18b93e8b21ULL, 0x51824c365dc4720fULL}},
        {"halton-5-7", {0xd4c719624ad94512ULL, 0x2f0e2f86a20562adULL}},
        {"random", {0x9df0c504a45e35cbULL, 0x7860201db4f49296ULL}},
        {"table", {0xaefa214b882d419bULL, 0x5d20de698fc70278ULL}},
        {"blue-noise", {0xd5d09961d5b688d2ULL, 0xdb3a46f1223c6902ULL}},
    };
    for (const auto& [scheme, expected] : hashes)
        for (const int dimension : {2, 3})
            EXPECT_EQ(hash_of(filled(scheme, dimension, 1000, 7, 3)), expected[dimension - 2])
                << scheme << ", " << dimension << "D: " << std::hex
                << hash_of(filled(scheme, dimension, 1000, 7, 3));
}

TEST(Directions, UnknownSchemeIsRefusedWithTheKnownOnes) {
    EXPECT_EQ(error_of<InputError>([] { sampling_scheme("sobol"); }),
              "unknown sampling scheme 'sobol'; known are halton, random, table, blue-noise, "
              "halton-P-Q (two different primes up to 31)");
}

} // namespace
} // namespace meniscus
