#include <meniscus/classifier/audit/confidence.hpp>

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace meniscus {
namespace {

TEST(Confidence, WithoutMissesBothBoundsAreTheRuleOfThree) {
    for (const std::size_t n : {1U, 3U, 14U, 100U}) {
        const double exact = 1 - std::pow(0.05, 1.0 / static_cast<double>(n));
        EXPECT_NEAR(upper_bound_of_probability(0, n, 0.95), exact, 1e-12);
        EXPECT_NEAR(upper_bound_of_mean_rate(std::vector<double>(n, 0.0), 0.95), exact, 1e-12);
    }
    EXPECT_NEAR(upper_bound_of_probability(0, 100, 0.95), 0.03, 0.001);
}

TEST(Confidence, ProbabilityBoundsMatchTables) {
    // One-sided Clopper-Pearson limits, quantiles of the beta distribution.
    EXPECT_NEAR(upper_bound_of_probability(1, 10, 0.95), 0.394163, 1e-6);
    EXPECT_NEAR(upper_bound_of_probability(3, 20, 0.95), 0.343664, 1e-4);
    EXPECT_EQ(upper_bound_of_probability(4, 4, 0.95), 1);
    EXPECT_EQ(upper_bound_of_probability(0, 0, 0.95), 1);
}

TEST(Confidence, MeanRateBoundIsWorkedOutByHand) {
    EXPECT_NEAR(upper_bound_of_mean_rate({0.5, 0.0}, 0.95), 1 - std::sqrt(0.05 * 0.5), 1e-12);
    EXPECT_EQ(upper_bound_of_mean_rate({1.0, 0.0}, 0.95), 1);
    EXPECT_EQ(upper_bound_of_mean_rate({}, 0.95), 1);
}

TEST(Confidence, MeanRateBoundCoversAtLeastAsOftenAsItSays) {
    // Rates that are zero mostly and now and then large, the hardest case for a bound.
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform;
    for (const double often : {0.02, 0.1, 0.3, 0.9}) {
        int covered = 0;
        for (int trial = 0; trial < 4000; ++trial) {
            std::vector<double> rates(20);
            for (double& rate : rates)
                rate = uniform(random) < often ? uniform(random) : 0;
            covered += static_cast<int>(upper_bound_of_mean_rate(rates, 0.95) >= often / 2);
        }
        EXPECT_GE(covered, 0.945 * 4000) << often;
    }
}

} // namespace
} // namespace meniscus
