#include "comparison/half_plane.hpp"

#include <meniscus/classifier/neyman_pearson.hpp>
#include <meniscus/data/errors.hpp>
#include <meniscus/runtime/angles.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace meniscus {
namespace {

/// Two overlapping clouds, of which the surface one lies the other way along `direction`.
LabelledPoints clouds(double direction, unsigned seed) {
    std::mt19937_64 generator(seed);
    std::normal_distribution<double> spread;
    LabelledPoints particles;
    for (int n = 0; n < 600; ++n) {
        const bool is_surface = n % 4 == 0;
        const double shift = is_surface ? -1.5 : 1.5;
        particles.add({spread(generator) + shift * std::cos(direction),
                       1000 * (spread(generator) + shift * std::sin(direction))},
                      is_surface, 1 + n % 3);
    }
    return particles;
}

std::int64_t weight_within(const LabelledPoints& particles, const HalfPlane& half) {
    std::int64_t weight = 0;
    for (std::size_t i = 0; i < particles.points.size(); ++i)
        if (particles.surface[i] == 0 && half.contains(particles.points[i]))
            weight += particles.weight[i];
    return weight;
}

void expect_all_surface_within(const LabelledPoints& particles, const HalfPlane& half) {
    for (std::size_t i = 0; i < particles.points.size(); ++i)
        if (particles.surface[i] != 0) {
            EXPECT_TRUE(half.contains(particles.points[i]));
        }
}

/// The least weight over many directions.
std::int64_t least_by_trial(const LabelledPoints& particles) {
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    for (int step = 0; step < 5000; ++step) {
        const double angle = 2 * pi * step / 5000;
        HalfPlane half = {std::cos(angle), std::sin(angle) / 1000, -1e300};
        for (std::size_t i = 0; i < particles.points.size(); ++i)
            if (particles.surface[i] != 0)
                half.limit = std::max(half.limit, half.x * particles.points[i].x +
                                                      half.y * particles.points[i].y);
        least = std::min(least, weight_within(particles, half));
    }
    return least;
}

TEST(HalfPlaneTest, NoDirectionIsBetter) {
    for (int n = 0; n < 16; ++n) {
        const LabelledPoints particles = clouds(n * pi / 8 + 0.1, static_cast<unsigned>(n));
        const HalfPlane half = tightest_half_plane(particles);
        expect_all_surface_within(particles, half);
        const std::int64_t found = weight_within(particles, half);
        const std::int64_t tried = least_by_trial(particles);
        EXPECT_LE(found, tried) << n;
        EXPECT_GT(found, tried * 9 / 10) << n; // trials are fine enough to come near
    }
}

// Surface on the unit square's corners; interior points beyond one edge each, which a line along
// that edge tells apart.
TEST(HalfPlaneTest, HeaviestSideOfASquareByHand) {
    LabelledPoints particles;
    for (const PlanePoint corner : {PlanePoint{0, 0}, {1, 0}, {0, 1}, {1, 1}})
        particles.add(corner, true, 1);
    particles.add({0.5, 1.1}, false, 3);
    particles.add({0.5, -0.1}, false, 1);
    particles.add({1.1, 0.5}, false, 2);
    particles.add({-0.1, 0.5}, false, 1);
    particles.add({0.5, 0.5}, false, 100); // no line tells it apart
    // All others are too close to their edge for a line to tell two of them apart.
    const HalfPlane half = tightest_half_plane(particles);
    expect_all_surface_within(particles, half);
    EXPECT_EQ(weight_within(particles, half), 104);
    EXPECT_FALSE(half.contains({0.5, 1.1}));
    const HalfPlane threshold = tightest_threshold(particles);
    EXPECT_EQ(weight_within(particles, threshold), 105);
    EXPECT_EQ(threshold.x, 1);
    EXPECT_EQ(threshold.limit, 1);
}

TEST(HalfPlaneTest, SurfaceThatSpansNoPlaneIsRefused) {
    LabelledPoints particles;
    EXPECT_THROW(tightest_half_plane(particles), InputError);
    for (int n = 0; n < 3; ++n)
        particles.add({double(n), 2.0 * n}, true, 1);
    particles.add({5, 5}, false, 1);
    EXPECT_THROW(tightest_half_plane(particles), InputError);
    particles.add({1, 7}, true, 1);
    EXPECT_NO_THROW(tightest_half_plane(particles));
}

// In the paper's plane the trainer of this project finds the same line, but for its margin.
TEST(HalfPlaneTest, AgreesWithTheTrainer) {
    std::mt19937_64 generator(5);
    std::uniform_real_distribution<double> offset(0, 0.5);
    std::normal_distribution<double> noise(0, 4);
    LabelledState state;
    state.scene = "made";
    LabelledPoints particles;
    for (int n = 0; n < 4000; ++n) {
        const double x = offset(generator);
        const double y = std::round(20 + 60 * x + noise(generator));
        const bool is_surface = y < 10 + 50 * x + noise(generator);
        state.mass_offset.push_back(x);
        state.neighbor_count.push_back(y);
        state.uncovered_fraction.push_back(is_surface ? 0.3 : 0);
        particles.add({x, y}, is_surface, 1);
    }
    const Line line = fewest_false_positives({state}, 0);
    const double rate = mean_false_positive_rate(count_errors({state}, line, 0));
    const HalfPlane half = tightest_half_plane(particles);
    const double own = static_cast<double>(weight_within(particles, half)) / 4000;
    EXPECT_GT(own, 0);
    EXPECT_LE(own, rate);
    EXPECT_NEAR(own, rate, 1.0 / 4000);
    EXPECT_NEAR(-half.x / half.y, line.k, 1e-2 * line.k);
}

} // namespace
} // namespace meniscus
