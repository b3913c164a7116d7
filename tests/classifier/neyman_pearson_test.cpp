#include "synthetic_states.hpp"

#include <meniscus/classifier/objectives/neyman_pearson.hpp>
#include <meniscus/classifier/objectives/scene_errors.hpp>
#include <meniscus/classifier/objectives/shift.hpp>
#include <meniscus/data/text/errors.hpp>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace meniscus {
namespace {

using test::LabelledParticle;
using test::state_of;

/// Bounds of what float adds to the features.
const double x_margin = feature_list[FeaturePair{}.first].float_error;
const double y_margin = feature_list[FeaturePair{}.second].float_error;

struct Outcome {
    std::size_t false_negatives = 0;
    double rate = 0; ///< mean over scenes of false positives / particles
};

Outcome outcome(const std::vector<LabelledState>& states, const Line& line, double threshold) {
    const auto scenes = count_errors(states, line, threshold);
    Outcome result;
    for (const SceneErrors& scene : scenes)
        result.false_negatives += scene.false_negatives;
    result.rate = mean_false_positive_rate(scenes);
    return result;
}

/// All slopes at which a particle changes sides or the line turns: those of the lines through two
/// particles, the first of them moved by the margin or not.
std::vector<double> candidate_slopes(const std::vector<LabelledState>& states) {
    std::vector<LabelledParticle> all;
    for (const LabelledState& state : states)
        for (std::size_t i = 0; i < state.size(); ++i)
            all.push_back({state.first[i], static_cast<std::uint32_t>(state.neighbor_count[i]), 0});
    std::vector<double> slopes = {0, max_slope()};
    for (const auto& a : all)
        for (const auto& b : all)
            for (const double margin : {0.0, 1.0}) {
                const double k =
                    (a.neighbor_count - margin * y_margin - static_cast<double>(b.neighbor_count)) /
                    (a.mass_offset + margin * x_margin - b.mass_offset);
                if (k > 0 && k < max_slope())
                    slopes.push_back(k);
            }
    std::sort(slopes.begin(), slopes.end());
    return slopes;
}

/// The least mean false-positive rate over every slope that could make a difference.
double min_rate(const std::vector<LabelledState>& states, double threshold) {
    const auto slopes = candidate_slopes(states);
    double min = 1;
    for (std::size_t s = 0; s + 1 < slopes.size(); ++s) {
        // Where slopes are this close, rounding decides.
        if (slopes[s + 1] - slopes[s] < 1e-8 * (1 + slopes[s]))
            continue;
        const double k = (slopes[s] + slopes[s + 1]) / 2;
        min = std::min(min, outcome(states, shift_line(states, threshold, k), threshold).rate);
    }
    return min;
}

/// Random particles of several scenes, on a coarse grid (ties, stacks, coincident points of both
/// classes) or anywhere.
std::vector<LabelledState> random_states(std::mt19937& random, bool on_grid) {
    const auto below = [&](unsigned bound) { return static_cast<unsigned>(random() % bound); };
    std::vector<LabelledState> states;
    const unsigned count = 1 + below(3);
    for (unsigned s = 0; s < count; ++s) {
        std::vector<LabelledParticle> particles;
        const unsigned size = 2 + below(8);
        for (unsigned i = 0; i < size; ++i)
            particles.push_back({on_grid ? 0.1 * below(5) : 0.001 * below(1000),
                                 on_grid ? below(6) : below(40), below(3) == 0 ? 0.5 : 0.0});
        states.push_back(state_of(below(2) == 0 ? "first" : "second", particles));
    }
    states[0].uncovered_fraction[0] = 0.5;
    states[0].neighbor_count[0] = 1 + below(5);
    states[0].uncovered_fraction[1] = 0;
    return states;
}

TEST(NeymanPearson, MatchesExhaustiveSearch) {
    std::mt19937 random(1);
    for (int trial = 0; trial < 4000; ++trial) {
        const auto states = random_states(random, trial % 2 == 0);
        const Line line = min_false_positives(states, 0);
        const Outcome found = outcome(states, line, 0);
        EXPECT_EQ(found.false_negatives, 0U) << "trial " << trial;
        EXPECT_NEAR(found.rate, min_rate(states, 0), 1e-12) << "trial " << trial;
        EXPECT_GE(line.k, 0);
        EXPECT_LE(line.k, max_slope());
    }
}

TEST(NeymanPearson, ScenesWeighTheSameWhateverTheirSize) {
    // The line rests on (0.2, 20) or (0.1, 10). The interior particle of `small` needs k < 20, the
    // two of `large` need k > 53.
    const auto small = state_of("small", {{0.2, 20, 1}, {0.1, 10, 1}, {0.25, 21, 0}});
    std::vector<LabelledParticle> many(100, {0.3, 5, 1});
    many.push_back({0.05, 12, 0});
    many.push_back({0.05, 12, 0});
    const std::vector<LabelledState> states = {small, state_of("large", many)};
    // One in three of `small` outweighs two in 102 of `large`, though it is fewer particles.
    const auto scenes = count_errors(states, min_false_positives(states, 0), 0);
    EXPECT_EQ(scenes[0].false_positives, 0U);
    EXPECT_EQ(scenes[1].false_positives, 2U);
    // In one scene the particles count alike.
    auto merged = states;
    merged[1].scene = "small";
    const auto together = count_errors(merged, min_false_positives(merged, 0), 0);
    EXPECT_EQ(together[0].false_positives, 1U);
}

TEST(NeymanPearson, TakesTheMiddleOfTheBestSlopes) {
    // One surface particle at (0.5, 10), one interior one at (0.1, 10): any positive slope that is
    // well above the margin tells them apart.
    const std::vector<LabelledState> states = {state_of("scene", {{0.5, 10, 1}, {0.1, 10, 0}})};
    const Line line = min_false_positives(states, 0);
    EXPECT_NEAR(line.k, 10, 0.01); // 45 degrees where both features span about one
    EXPECT_NEAR(line.d, 5, 0.01);
}

TEST(NeymanPearson, SeparatesVerticalStacks) {
    const std::vector<LabelledState> states = {state_of(
        "scene",
        {{0.5, 10, 1}, {0.5, 30, 1}, {0.5, 1, 1}, {0.1, 10, 0}, {0.1, 1, 0}, {0.1, 30, 0}})};
    EXPECT_EQ(outcome(states, min_false_positives(states, 0), 0).rate, 0);
}

TEST(NeymanPearson, ParticlesWithoutNeighborsDoNotConstrainTheLine) {
    const std::vector<LabelledState> states = {
        state_of("scene", {{0.3, 10, 1}, {0, 0, 1}, {0.1, 12, 0}})};
    const auto scenes = count_errors(states, min_false_positives(states, 0), 0);
    EXPECT_EQ(scenes[0].false_negatives, 0U);
    EXPECT_EQ(scenes[0].false_positives, 0U);
}

TEST(NeymanPearson, NeedsBothClasses) {
    EXPECT_THROW(min_false_positives({state_of("scene", {{0, 0, 1}, {0.1, 12, 0}})}, 0),
                 InputError);
    EXPECT_THROW(min_false_positives({state_of("scene", {{0.1, 12, 1}})}, 0), InputError);
    EXPECT_THROW(min_false_positives({state_of("scene", {{0.1, 12, 0}})}, 0), InputError);
}

} // namespace
} // namespace meniscus
