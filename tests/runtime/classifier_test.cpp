#include <meniscus/runtime/features/classifier.hpp>

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace meniscus {
namespace {

/// A line as an exported header has it.
struct TestCoefficients {
    static constexpr double k = 100;
    static constexpr double d = 20;
    static constexpr int dimension = 3;
    static constexpr double radius_ratio = 0.8;
};

/// The same line where h is two spacings, at others following it.
struct FollowingCoefficients : TestCoefficients {
    static constexpr double reference_spacing_ratio = 2;
};

FeatureSum<double, 3> sum_of(double offset, int count) {
    FeatureSum<double, 3> sum;
    sum.count = count;
    sum.mass = count;
    sum.moment[1] = -offset * count;
    return sum;
}

TEST(Classifier, SurfaceOnAndBelowTheLine) {
    constexpr auto line = surface_line<TestCoefficients, double>();
    EXPECT_TRUE(is_surface(sum_of(0, 20), line, 1.0));
    EXPECT_FALSE(is_surface(sum_of(0, 21), line, 1.0));
    EXPECT_TRUE(is_surface(sum_of(0.25, 45), line, 1.0));
    EXPECT_FALSE(is_surface(sum_of(0.25, 46), line, 1.0));
}

TEST(Classifier, LineFollowsTheSupportRadiusOverSpacing) {
    constexpr auto line = surface_line<FollowingCoefficients, double>(4);
    EXPECT_DOUBLE_EQ(line.k, 800);
    EXPECT_DOUBLE_EQ(line.d, 160);
    EXPECT_TRUE(is_surface(sum_of(0.25, 360), line, 1.0));
    EXPECT_FALSE(is_surface(sum_of(0.25, 361), line, 1.0));
    constexpr auto fixed = surface_line<TestCoefficients, double>(4);
    EXPECT_DOUBLE_EQ(fixed.k, 100);
}

TEST(Classifier, MedianNeighborCount) {
    const std::vector<std::uint32_t> counts{7, 1, 40, 40, 2000};
    EXPECT_EQ(median_neighbor_count(counts.data(), 5), 40);
    EXPECT_EQ(median_neighbor_count(counts.data(), 2), 1);
    EXPECT_EQ(median_neighbor_count(counts.data() + 4, 1), 1023);
    EXPECT_EQ(median_neighbor_count(counts.data(), 0), 0);
}

TEST(Classifier, FallingLine) {
    const SurfaceLine<double> line{-10, 20}; // y <= 20 - 10 x
    EXPECT_TRUE(is_surface(sum_of(0.5, 15), line, 1.0));
    EXPECT_FALSE(is_surface(sum_of(0.5, 16), line, 1.0));
    EXPECT_FALSE(is_surface(sum_of(0.5, 30), line, 1.0));
}

TEST(Classifier, ParticleWithoutNeighborsIsSurface) {
    EXPECT_TRUE(is_surface(FeatureSum<double, 3>{}, {0.0, -5.0}, 1.0));
}

TEST(Classifier, FeaturesThatAreNotFiniteMeanSurface) {
    FeatureSum<float, 3> sum;
    sum.count = 1000;
    for (const float moment :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        sum.moment[0] = moment;
        sum.mass = 1;
        EXPECT_TRUE(is_surface(sum, {1.0F, 1.0F}, 1.0F));
    }
}

/// h times the mass of the neighbors overflows, and the offset with it.
TEST(Classifier, MassesThatOverflowMeanSurface) {
    FeatureSum<float, 3> sum;
    sum.count = 10;
    sum.mass = 1e30F;
    sum.moment[0] = 3e38F;
    EXPECT_TRUE(is_surface(sum, {20.0F, 8.0F}, 1e9F)); // 10 neighbors, below 20 * 0.3 + 8
}

TEST(Classifier, TellsFiniteByBitsUnderFastMathToo) {
    EXPECT_TRUE(is_finite(0.0F));
    EXPECT_TRUE(is_finite(std::numeric_limits<float>::denorm_min()));
    EXPECT_TRUE(is_finite(std::numeric_limits<double>::max()));
    EXPECT_FALSE(is_finite(std::numeric_limits<float>::infinity()));
    EXPECT_FALSE(is_finite(-std::numeric_limits<double>::infinity()));
    EXPECT_FALSE(is_finite(std::numeric_limits<float>::quiet_NaN()));
    EXPECT_FALSE(is_finite(std::numeric_limits<double>::quiet_NaN()));
}

/// A view written as a lambda: a periodic line of particles, whose displacements only it knows.
TEST(Classifier, PassOverAViewOfTheHostsOwn) {
    const auto view = [](std::size_t, auto&& visit) {
        for (int n = 0; n < 30; ++n) // 30 neighbors on a ring around the particle
            visit(static_cast<std::size_t>(n),
                  std::array<double, 3>{0.5 * std::cos(n * 0.2094395),
                                        0.5 * std::sin(n * 0.2094395), 0},
                  1.0);
    };
    std::vector<std::uint8_t> surface(4, 7);
    const auto found = classify<TestCoefficients, double, 3>(view, 1, 3, 1.0, surface.data());
    EXPECT_EQ(found, 0U);
    EXPECT_EQ(surface, (std::vector<std::uint8_t>{7, 0, 0, 7}));
}

} // namespace
} // namespace meniscus
