#include "labelled_snapshots.hpp"
#include "synthetic_states.hpp"

#include <meniscus/classifier/model/classify_snapshot.hpp>
#include <meniscus/classifier/objectives/trainer.hpp>
#include <meniscus/data/text/errors.hpp>

#include <cmath>
#include <gtest/gtest.h>

namespace meniscus {
namespace {

using test::state_of;
using test::two_clouds;

/// The same fluid with half as many neighbors everywhere.
LabelledState thinned(LabelledState state) {
    state.scene += " thin";
    for (auto& count : state.neighbor_count)
        count = std::floor((count + 1) / 2);
    return state;
}

TEST(RelativeCount, ScalesTheMedianToTheReference) {
    auto state = state_of("a", {{0, 10, 0}, {0, 20, 0}, {0.3, 5, 1}});
    EXPECT_EQ(state.y(1), 20);
    make_relative(state);
    EXPECT_EQ(state.y(0), reference_neighbor_count);
    EXPECT_EQ(state.y(1), 2 * reference_neighbor_count);
}

TEST(RelativeCount, OneLineServesACompressedAndAThinFluid) {
    const auto dense = two_clouds("dense", 3000, 1.8, 3);
    std::vector<LabelledState> states = {dense, thinned(dense)};
    TrainingOptions options;
    const Model plain = train(states, options);
    for (LabelledState& state : states)
        make_relative(state);
    const Model relative = train(states, options);
    EXPECT_EQ(relative.false_negatives, 0U);
    EXPECT_LT(relative.false_positives, plain.false_positives / 2);
    EXPECT_EQ(relative.reference_neighbor_count, reference_neighbor_count);
    EXPECT_EQ(plain.reference_neighbor_count, 0);
}

TEST(RelativeCount, IsNotMixedWithCountsAsTheyAre) {
    std::vector<LabelledState> states = {two_clouds("a", 300, 1, 1), two_clouds("b", 300, 1, 2)};
    const Model plain = train(states, {});
    make_relative(states[0]);
    EXPECT_THROW(train(states, {}), InputError);
    make_relative(states[1]);
    TrainingOptions options;
    options.keep_k = plain;
    EXPECT_THROW(train(states, options), InputError);
}

TEST(RelativeCount, NeedsNeighbors) {
    auto state = state_of("a", {{0, 0, 1}, {0, 0, 1}, {0.3, 5, 1}});
    EXPECT_THROW(make_relative(state), InputError);
}

TEST(RelativeCount, ModelReadsBack) {
    Model model = test::chain_model();
    model.reference_neighbor_count = 40;
    const Model read = model_from_json(model_to_json(model), "model.json");
    EXPECT_EQ(read.reference_neighbor_count, 40);
    EXPECT_EQ(model_to_json(read), model_to_json(model));
}

TEST(RelativeCount, ClassificationScalesTheLineToTheState) {
    // In the chain the median count is 1: a relative line for 2 is the plain one with half k and d.
    Model plain = test::chain_model();
    Model relative = plain;
    relative.reference_neighbor_count = 2;
    relative.line = {2 * plain.line.k, 2 * plain.line.d};
    EXPECT_EQ(classify_snapshot(test::chain(), relative, {true, 1}).surface,
              classify_snapshot(test::chain(), plain, {true, 1}).surface);
}

} // namespace
} // namespace meniscus
