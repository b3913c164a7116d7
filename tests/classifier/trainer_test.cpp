#include "data/expected_errors.hpp"
#include "synthetic_states.hpp"

#include <meniscus/classifier/objectives/scene_errors.hpp>
#include <meniscus/classifier/objectives/shift.hpp>
#include <meniscus/classifier/objectives/trainer.hpp>
#include <meniscus/data/particles/particle_volumes.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/runtime/features/classifier.hpp>

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace meniscus {
namespace {

using test::state_of;
using test::two_clouds;

std::string training_error(const std::vector<LabelledState>& states,
                           const TrainingOptions& options) {
    return error_of<InputError>([&] { train(states, options); });
}

std::vector<LabelledState> good_states() {
    return {two_clouds("droplet", 3000, 1, 1), two_clouds("dam", 2000, 1, 2)};
}

TEST(Shift, IsTheSmallestThatMissesNoSurfaceParticle) {
    const std::vector<LabelledState> states = {
        state_of("scene", {{0.2, 30, 0.5}, {0.4, 35, 0.5}, {0.0, 40, 0}, {0.9, 0, 1}})};
    EXPECT_DOUBLE_EQ(min_d(states, 0, 100), 10 + d_margin(100));
    EXPECT_DOUBLE_EQ(min_d(states, 0, 10), 31 + d_margin(10));
    EXPECT_DOUBLE_EQ(min_d(states, 0, -10), 39 + d_margin(10));
    Line line = shift_line(states, 0, 100);
    EXPECT_EQ(count_errors(states, line, 0)[0].false_negatives, 0U);
    line.d -= 1.01 * d_margin(100);
    EXPECT_EQ(count_errors(states, line, 0)[0].false_negatives, 1U);
}

TEST(Shift, LeavesNoFalseNegativeInFloat) {
    // Features worked out in float are off by what the margin is derived from.
    std::mt19937 random(3);
    for (const double k : {0.0, 12.5, 74.6888, 117.0, 400.0, 1e5}) {
        const auto states = good_states();
        const Line line = shift_line(states, 0, k);
        const SurfaceLine<float> in_float{static_cast<float>(line.k), static_cast<float>(line.d)};
        for (const LabelledState& state : states)
            for (std::size_t i = 0; i < state.size(); ++i) {
                const auto x =
                    static_cast<float>(state.first[i] - 4.2e-6 * static_cast<double>(random() % 2));
                const auto y = static_cast<float>(state.neighbor_count[i]);
                EXPECT_TRUE(state.uncovered_fraction[i] == 0 || y <= in_float.k * x + in_float.d);
            }
    }
}

TEST(Errors, AreCountedByScene) {
    const std::vector<LabelledState> states = {
        state_of("a", {{0, 5, 0.5}, {0, 7, 0.5}, {0, 5, 0}, {0, 7, 0}, {0, 0, 0}}),
        state_of("b", {{0, 5, 0}}), state_of("a", {{0, 6, 0.02}})};
    const auto scenes = count_errors(states, {0, 5}, 0.02);
    ASSERT_EQ(scenes.size(), 2U);
    EXPECT_EQ(scenes[0].scene, "a");
    EXPECT_EQ(scenes[0].particles, 6U);
    EXPECT_EQ(scenes[0].surface_particles, 2U);
    EXPECT_EQ(scenes[0].false_negatives, 1U);
    EXPECT_EQ(scenes[0].false_positives, 2U);
    EXPECT_DOUBLE_EQ(mean_false_positive_rate(scenes), (2.0 / 6 + 1) / 2);
}

TEST(Train, DescribesItsTrainingSet) {
    auto states = good_states();
    states[0].hash = "abc";
    states[1].spacing_ratio = 2.5;
    const Model model = train(states, {});
    EXPECT_EQ(model.objective, "neyman-pearson");
    EXPECT_EQ(model.false_negatives, 0U);
    EXPECT_EQ(model.d_margin, d_margin(model.line.k));
    EXPECT_DOUBLE_EQ(model.spacing_ratio->min, 2);
    EXPECT_DOUBLE_EQ(model.spacing_ratio->max, 2.5);
    EXPECT_EQ(model.bulk_neighbor_count->max, 38);
    ASSERT_EQ(model.training_files.size(), 2U);
    EXPECT_EQ(model.training_files[0].hash, "abc");
    EXPECT_EQ(model.training_files[0].particles, 3000U);
    EXPECT_EQ(model.training_files[0].surface_particles, 1000U);
    EXPECT_EQ(model.boundary_weight, default_boundary_weight); // there is no boundary
    for (LabelledState& state : states)
        state.boundary_weight = 0.5;
    EXPECT_EQ(train(states, {}).boundary_weight, 0.5);
}

TEST(Train, KeepsTheSlopeOfAnotherModel) {
    TrainingOptions options;
    options.keep_k = Model{};
    options.keep_k->line = {74.6888, 28};
    options.keep_k->reference_spacing_ratio = reference_spacing_ratio;
    const Model model = train(good_states(), options);
    EXPECT_EQ(model.line.k, 74.6888);
    EXPECT_EQ(model.line.d, min_d(good_states(), 0, 74.6888));
    EXPECT_EQ(model.objective, "keep-k");
    EXPECT_EQ(model.false_negatives, 0U);
    options.keep_k->dimension = 2;
    options.keep_k->file = "flat.json";
    const std::string error = training_error(good_states(), options);
    EXPECT_NE(error.find("flat.json"), std::string::npos) << error;
    EXPECT_NE(error.find("droplet.vtkhdf"), std::string::npos) << error;
}

TEST(Train, RefusesWhatItCannotTrainOn) {
    EXPECT_NE(training_error({}, {}), "");
    EXPECT_NE(training_error({state_of("a", {})}, {}).find("no surface particle"),
              std::string::npos);
    EXPECT_NE(training_error({state_of("a", {{0.1, 5, 0}})}, {}).find("no surface particle"),
              std::string::npos);
    EXPECT_NE(training_error({state_of("a", {{0.1, 5, 1}})}, {}).find("no interior particle"),
              std::string::npos);
    auto mixed = good_states();
    mixed[1].dimension = 2;
    EXPECT_EQ(training_error(mixed, {}),
              "droplet.vtkhdf is 3D and dam.vtkhdf is 2D; give files of one dimension");
    mixed = good_states();
    mixed[1].radius_ratio = 0.7;
    EXPECT_NE(training_error(mixed, {}).find("0.7"), std::string::npos);
    mixed = good_states();
    mixed[0].boundary_weight = 0;
    mixed[1].boundary_weight = 0.5;
    EXPECT_EQ(training_error(mixed, {}),
              "droplet.vtkhdf was labelled with boundary weight 0 and dam.vtkhdf with 0.5; label "
              "them with the same --boundary-weight");
    TrainingOptions options;
    options.keep_k = Model{};
    options.keep_k->reference_spacing_ratio = reference_spacing_ratio;
    options.keep_k->boundary_weight = 0.25;
    EXPECT_NE(training_error(mixed = {mixed[1]}, options).find("--boundary-weight"),
              std::string::npos);
    options = {};
    options.objective = "guess";
    EXPECT_NE(training_error(good_states(), options).find("guess"), std::string::npos);
    for (const double threshold : {-0.1, 1.0, std::nan("")}) {
        options = {};
        options.label_threshold = threshold;
        EXPECT_NE(training_error(good_states(), options).find("label threshold"),
                  std::string::npos);
    }
}

} // namespace
} // namespace meniscus
