// Lines follow the support radius over the spacing of particles at rest, and second lines their
// first ones.
#include "labelled_snapshots.hpp"
#include "synthetic_states.hpp"

#include <meniscus/classifier/model/classify_snapshot.hpp>
#include <meniscus/classifier/objectives/trainer.hpp>
#include <meniscus/data/particles/feature_names.hpp>
#include <meniscus/data/text/errors.hpp>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace meniscus {
namespace {

using test::state_of;
using test::two_clouds;

/// The same fluid with half as many neighbors everywhere: with particles of twice the volume.
LabelledState thinned(LabelledState state) {
    state.scene += " thin";
    for (auto& count : state.neighbor_count)
        count = std::floor((count + 1) / 2);
    state.spacing_ratio = *state.spacing_ratio / std::cbrt(2);
    state.count_scale = 2;
    return state;
}

TEST(SpacingRatio, OneLineServesHeavyAndLightParticles) {
    const auto dense = two_clouds("dense", 3000, 1.8, 3);
    std::vector<LabelledState> states = {dense, thinned(dense)};
    const Model followed = train(states, {});
    EXPECT_EQ(followed.false_negatives, 0U);
    EXPECT_EQ(followed.reference_spacing_ratio, reference_spacing_ratio);
    EXPECT_NEAR(followed.spacing_ratio->min, 2 / std::cbrt(2), 1e-12);
    states[1].count_scale = 1;
    EXPECT_LT(followed.false_positives, train(states, {}).false_positives / 2);
}

TEST(SpacingRatio, ScalesWhatGrowsWithCounts) {
    LabelledState state = state_of("a", {{0.1, 10, 0}, {0.2, 20, 0}});
    state.count_scale = 0.5;
    EXPECT_EQ(state.x(1), 0.2);
    EXPECT_EQ(state.y(1), 10);
    state.features = feature_pair({"direction_eigenvalue", "direction_offset"});
    state.second = {0.3, 0.4};
    EXPECT_EQ(state.x(1), 0.1);
    EXPECT_EQ(state.y(1), 0.4);
}

TEST(SpacingRatio, KeepsTheSlopeOfLinesThatFollowItOnly) {
    const std::vector<LabelledState> states = {two_clouds("a", 300, 1, 1)};
    TrainingOptions options;
    options.keep_k = train(states, {});
    EXPECT_EQ(train(states, options).line.k, options.keep_k->line.k);
    options.keep_k->reference_spacing_ratio = 0;
    EXPECT_THROW(train(states, options), InputError);
}

TEST(SpacingRatio, ModelReadsBack) {
    Model model = test::chain_model();
    model.reference_spacing_ratio = 2;
    model.second = SecondModelLine{{3, 4, true}, feature_pair({"kernel_sum", "mass_offset"}), 0.5};
    const Model read = model_from_json(model_to_json(model), "model.json");
    EXPECT_EQ(read.reference_spacing_ratio, 2);
    EXPECT_TRUE(read.second->line.above);
    EXPECT_EQ(read.second->line.k, 3);
    EXPECT_EQ(names_of(read.second->features), "kernel_sum,mass_offset");
    EXPECT_EQ(model_to_json(read), model_to_json(model));
}

TEST(SpacingRatio, ClassificationScalesTheLineToTheState) {
    // The chain's h is two spacings: a line for three is the plain one at 27/8 of k and d.
    const Model plain = test::chain_model();
    Model other = plain;
    other.reference_spacing_ratio = 3;
    other.line = {27.0 / 8 * plain.line.k, 27.0 / 8 * plain.line.d};
    EXPECT_EQ(classify_snapshot(test::chain(), other, {true, 1}).surface,
              classify_snapshot(test::chain(), plain, {true, 1}).surface);
}

/// What set_classifier makes of a model is what the features of its lines call for.
TEST(SpacingRatio, FractionsDoNotFollow) {
    Model model;
    model.line = {60, 20};
    model.reference_spacing_ratio = 2;
    model.boundary_weight = 0.5;
    model.second =
        SecondModelLine{{24, 5}, feature_pair({"mass_offset", "direction_eigenvalue"}), 0};
    SurfaceTensionOptions options;
    options.spacing_ratio = 4;
    set_classifier(options, model);
    EXPECT_EQ(options.k, 8 * 60);
    EXPECT_EQ(options.d, 8 * 20);
    EXPECT_EQ(options.second_line.k, 8 * 24);
    EXPECT_EQ(options.second_line.d, 8 * 5);
    EXPECT_EQ(options.boundary_weight, 0.5);
    model.second->features = feature_pair({"direction_eigenvalue", "direction_offset"});
    set_classifier(options, model);
    EXPECT_EQ(options.second_line.k, 24.0 / 8);
    EXPECT_EQ(options.second_line.d, 5);
    model = Model{};
    model.features = feature_pair({"direction_offset", "kernel_sum"});
    model.line = {1, 2, true};
    set_classifier(options, model); // one line of other features: all are left to it
    EXPECT_EQ(options.d, 1e6);
    EXPECT_TRUE(options.second_line.is_there);
    EXPECT_TRUE(options.second_line.above);
}

/// A second line judges the candidates of the first alone, and the errors are those of both.
TEST(SecondLine, KeepsFewerCandidatesAndNoneMissed) {
    const std::vector<LabelledState> first = {two_clouds("a", 2000, 1.5, 1),
                                              two_clouds("b", 1500, 1.5, 2)};
    std::vector<LabelledState> second = first;
    for (LabelledState& state : second) { // a feature that tells more of them apart
        state.features = feature_pair({"mass_offset", "kernel_sum"});
        for (std::size_t i = 0; i < state.size(); ++i)
            state.second.push_back(state.uncovered_fraction[i] > 0 ? 0.5 : i % 3 == 0 ? 0.4 : 0.9);
    }
    Model model = train(first, {});
    const std::size_t by_first = model.false_positives;
    const auto errors = add_second_line(model, first, second);
    EXPECT_EQ(model.false_negatives, 0U);
    EXPECT_LT(model.false_positives, by_first);
    std::size_t counted = 0;
    for (const SceneErrors& scene : errors)
        counted += scene.false_positives;
    EXPECT_EQ(counted, model.false_positives);
    EXPECT_EQ(count_errors_of_both(model, first, second)[1].false_positives,
              errors[1].false_positives);
    std::swap(second[0], second[1]);
    EXPECT_THROW(add_second_line(model, first, second), InputError);
    second.pop_back();
    EXPECT_THROW(add_second_line(model, first, second), InputError);
}

} // namespace
} // namespace meniscus
