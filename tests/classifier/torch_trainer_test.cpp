#include "data/expected_errors.hpp"
#include "synthetic_states.hpp"

#include <meniscus/classifier/objectives/scene_errors.hpp>
#include <meniscus/classifier/objectives/trainer.hpp>
#include <meniscus/classifier/torch/torch_plugin.hpp>
#include <meniscus/data/text/errors.hpp>

#include <cmath>
#include <gtest/gtest.h>

namespace meniscus {
namespace {

using test::state_of;
using test::two_clouds;

/// The objectives that libtorch fits, each on all tests.
class TorchTrainer : public testing::TestWithParam<const char*> {
protected:
    void SetUp() override {
        if (!has_torch_trainer())
            GTEST_SKIP() << "built without the libtorch trainer";
    }
};

double misclassified(const std::vector<LabelledState>& states, const Line& line) {
    double wrong = 0;
    double particles = 0;
    for (const SceneErrors& scene : count_errors(states, line, 0)) {
        wrong += static_cast<double>(scene.false_negatives + scene.false_positives);
        particles += static_cast<double>(scene.particles);
    }
    return wrong / particles;
}

TEST_P(TorchTrainer, SeparatesSeparableClouds) {
    const std::vector<LabelledState> states = {two_clouds("a", 6000, 0.3, 1),
                                               two_clouds("b", 3000, 0.3, 2)};
    const Line line = fit_with_torch(GetParam(), states, 0, 1);
    EXPECT_EQ(misclassified(states, line), 0) << line.k << " " << line.d;
}

TEST_P(TorchTrainer, NearlySeparatesOverlappingClouds) {
    const std::vector<LabelledState> states = {two_clouds("a", 6000, 1, 1)};
    EXPECT_LT(misclassified(states, fit_with_torch(GetParam(), states, 0, 1)), 0.005);
    TrainingOptions options;
    options.objective = GetParam();
    const Model model = train(states, options);
    EXPECT_EQ(model.false_negatives, 0U);
    EXPECT_EQ(model.objective, GetParam());
    options.objective = "neyman-pearson";
    EXPECT_LE(train(states, options).false_positives, model.false_positives);
}

TEST_P(TorchTrainer, GivesTheSameBitsAgain) {
    const std::vector<LabelledState> states = {two_clouds("a", 2000, 1, 1)};
    const Line first = fit_with_torch(GetParam(), states, 0, 7);
    const Line second = fit_with_torch(GetParam(), states, 0, 7);
    EXPECT_EQ(first.k, second.k);
    EXPECT_EQ(first.d, second.d);
}

TEST_P(TorchTrainer, SaysWhyThereIsNoLine) {
    // Surface particles with the more neighbors, no line below which they lie.
    const std::vector<LabelledState> upside_down = {state_of(
        "a", {{0.1, 40, 1}, {0.2, 41, 1}, {0.1, 42, 1}, {0.1, 10, 0}, {0.2, 11, 0}, {0.1, 12, 0}})};
    expect_mentions(error_of<FailureError>([&] { fit_with_torch(GetParam(), upside_down, 0, 1); }),
                    {GetParam()});
}

INSTANTIATE_TEST_SUITE_P(Objectives, TorchTrainer, testing::Values("logistic", "network"),
                         [](const auto& info) { return std::string(info.param); });

TEST(TorchPlugin, ScenesWeighTheSame) {
    if (!has_torch_trainer())
        GTEST_SKIP() << "built without the libtorch trainer";
    // The same particles, ten times over in one of the scenes: another fit only if particles and
    // not scenes weighed the same.
    const auto cloud = two_clouds("a", 2000, 1, 1);
    const auto other = two_clouds("b", 2000, 1.3, 2);
    std::vector<LabelledState> repeated(10, cloud);
    repeated.push_back(other);
    const Line once = fit_with_torch("logistic", {cloud, other}, 0, 1);
    const Line again = fit_with_torch("logistic", repeated, 0, 1);
    EXPECT_NEAR(once.k, again.k, 1e-4 * std::abs(once.k));
    EXPECT_NEAR(once.d, again.d, 1e-4 * std::abs(once.d));
}

TEST(TorchPlugin, WithoutTheTrainerItSaysSo) {
    if (has_torch_trainer())
        GTEST_SKIP() << "built with the libtorch trainer";
    EXPECT_THROW(fit_with_torch("logistic", {two_clouds("a", 100, 1, 1)}, 0, 1), FailureError);
}

} // namespace
} // namespace meniscus
