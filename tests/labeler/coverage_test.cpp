#include <meniscus/labeler/monte_carlo/coverage.hpp>

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace meniscus {
namespace {

std::vector<Direction> halton(int dimension, std::size_t count) {
    std::vector<Direction> directions(count);
    sampling_scheme("halton").fill(dimension, 0, 0, directions);
    return directions;
}

/// The same by each instruction set, whatever the blocks.
std::size_t fast_count(const std::vector<Direction>& directions,
                       const std::vector<Direction>& displacements, double radius_ratio = 0.8) {
    Caps caps;
    caps.displacements = displacements;
    caps.radius_ratio = radius_ratio;
    const DirectionBlocks compact = compact_blocks(directions);
    DirectionBlocks plain;
    plain_blocks(directions, plain);
    const std::size_t count = count_uncovered(compact, caps);
    for (const InstructionSet set : instruction_sets)
        if (is_supported(set)) {
            EXPECT_EQ(count_uncovered(compact, caps, set), count) << name_of(set);
            EXPECT_EQ(count_uncovered(plain, caps, set), count) << name_of(set);
        }
    return count;
}

/// Neighbors between the two radii, in a ball cut off above a plane so that something stays open.
std::vector<Direction> random_neighbors(std::mt19937& generator, int dimension, double cut) {
    std::uniform_real_distribution<double> coordinate(-1, 1);
    std::uniform_int_distribution<int> count(0, 60);
    std::vector<Direction> displacements;
    for (int n = count(generator); n > 0;) {
        Direction x{coordinate(generator), coordinate(generator),
                    dimension == 2 ? 0 : coordinate(generator)};
        const double length = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
        if (length < 1 && length > 0.2 && x[0] < cut) {
            displacements.push_back(x);
            --n;
        }
    }
    return displacements;
}

TEST(Coverage, FastKernelCountsWhatTheReferenceCounts) {
    std::mt19937 generator(1);
    for (const int dimension : {2, 3})
        for (const std::size_t samples : {1, 10, 63, 64, 65, 1000, 20000}) {
            const auto directions = halton(dimension, samples);
            for (int trial = 0; trial < 60; ++trial) {
                const double cut = 0.1 * (trial % 11);
                const auto neighbors = random_neighbors(generator, dimension, cut);
                const double ratio = trial % 3 == 0 ? 0.5 : 0.8;
                ASSERT_EQ(fast_count(directions, neighbors, ratio),
                          count_uncovered_reference(directions, neighbors, ratio))
                    << dimension << "D, " << samples << " samples, trial " << trial;
            }
        }
}

TEST(Coverage, NoNeighborCoversNothing) {
    EXPECT_EQ(fast_count(halton(3, 1000), {}), 1000U);
}

TEST(Coverage, OneNeighborCoversItsCap) {
    // A cap of angle theta covers (1 - cos theta) / 2 of a sphere and theta / pi of a circle.
    const double distance = 0.7;
    const double cosine = (distance * distance + 1 - 0.64) / (2 * distance);
    constexpr std::size_t samples = 100000;
    EXPECT_NEAR(static_cast<double>(fast_count(halton(3, samples), {{0, distance, 0}})) / samples,
                1 - (1 - cosine) / 2, 1e-4);
    EXPECT_NEAR(static_cast<double>(fast_count(halton(2, samples), {{0, distance, 0}})) / samples,
                1 - std::acos(cosine) / 3.14159265358979, 1e-4);
}

TEST(Coverage, NeighborsTooCloseOrTooFarCoverNothing) {
    const auto directions = halton(3, 500);
    EXPECT_EQ(fast_count(directions, {{0, 0, 0}, {0.1, 0, 0}, {0, 0.19, 0}, {0, 0, 1.81}}), 500U);
}

TEST(Coverage, DirectionsOnTheEdgeOfACapAreDecidedInDouble) {
    // Caps whose edge passes within 1e-9 of a sample, inside and outside: float cannot tell.
    const std::vector<Direction> directions(20, Direction{0, 0.6, 0.8});
    for (const double shift : {1e-9, -1e-9}) {
        // Along the direction itself the cap's edge point is the direction where |x| = 0.2.
        const Direction x{0, 0.6 * (0.2 + shift), 0.8 * (0.2 + shift)};
        EXPECT_EQ(fast_count(directions, {x}), count_uncovered_reference(directions, {x}, 0.8));
        EXPECT_EQ(fast_count(directions, {x}), shift > 0 ? 0U : 20U);
    }
}

} // namespace
} // namespace meniscus
