// Lines in the plane of any two features, on three samples of three scenes.
#include "detectors/detector.hpp"
#include "features/feature_pairs.hpp"
#include "table_rows.hpp"

#include <meniscus/classifier/objectives/neyman_pearson.hpp>
#include <meniscus/classifier/objectives/scene_errors.hpp>

#include <algorithm>

namespace meniscus {
namespace {

const std::vector<FluidState<float>>& states() {
    static const std::vector<FluidState<float>> all = [] {
        std::vector<FluidState<float>> read;
        for (const char* name : {"snake_dfsph_05", "droplet_iisph_06", "boxhole_dfsph_04"})
            read.push_back(
                read_fluid_state<float>(std::string(MENISCUS_SAMPLES "/") + name + ".vtkhdf"));
        return read;
    }();
    return all;
}

constexpr double label_threshold = 0.02;

const Table& table() {
    static const Table made = feature_pairs(states(), {label_threshold, 2, {1, no_time}});
    return made;
}

double figure_of(const std::string& features, const std::string& kind, const std::string& key) {
    const auto rows = rows_with(table(), {{"features", features}, {"kind", kind}});
    EXPECT_EQ(rows.size(), 1U) << features;
    return figure_in(table(), rows.at(0), key);
}

/// The states as the trainer has them, with the features of the runtime.
std::vector<LabelledState> labelled_states() {
    std::vector<LabelledState> labelled;
    for (const auto& state : states()) {
        LabelledState one;
        one.scene = state.scene;
        const auto range = neighbor_range<float>(static_cast<double>(state.support_radius), 0.8);
        for (std::size_t i = 0; i < state.size(); ++i) {
            const auto sum = sum_features<float, 3>(state.view<3>(), i, range);
            one.first.push_back(static_cast<double>(mass_offset(sum, state.support_radius)));
            one.neighbor_count.push_back(sum.count);
        }
        one.uncovered_fraction = state.uncovered_fraction;
        labelled.push_back(one);
    }
    return labelled;
}

TEST(FeaturePairs, PapersPairAsTheTrainerHasIt) {
    const auto labelled = labelled_states();
    const Line line = min_false_positives(labelled, label_threshold);
    const double rate =
        100 * mean_false_positive_rate(count_errors(labelled, line, label_threshold));
    EXPECT_GT(rate, 0);
    // In a free plane lines may fall, too, and rounding may tip a particle.
    EXPECT_NEAR(figure_of("mass_offset, neighbor_count", "line", "false_positive_rate"), rate,
                0.02);
}

TEST(FeaturePairs, PapersPairOnScenesLeftOutAsTheTrainerHasIt) {
    const auto labelled = labelled_states();
    double rate = 0;
    std::size_t missed = 0;
    for (std::size_t s = 0; s < labelled.size(); ++s) {
        auto others = labelled;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(s));
        const Line line = min_false_positives(others, label_threshold);
        const auto errors = count_errors({labelled[s]}, line, label_threshold);
        rate += 100 * mean_false_positive_rate(errors) / static_cast<double>(labelled.size());
        missed += errors[0].false_negatives;
    }
    const auto figure = [](const char* key) {
        return figure_of("mass_offset, neighbor_count", "line", key);
    };
    EXPECT_NEAR(figure("left_out_false_positive_rate"), rate, 0.05);
    EXPECT_NEAR(figure("left_out_false_negatives"), static_cast<double>(missed), 3);
}

TEST(FeaturePairs, EachPairEachFeatureAndTheTables) {
    EXPECT_EQ(rows_with(table(), {{"kind", "line"}}).size(), 36U);
    EXPECT_EQ(rows_with(table(), {{"kind", "threshold"}}).size(), 9U);
    EXPECT_EQ(rows_with(table(), {{"kind", "table"}}).size(), 2U);
    for (const auto& row : table().rows) {
        ASSERT_EQ(row.size(), table().columns.size());
        EXPECT_EQ(is_empty_in(table(), row, "time"), text_in(table(), row, "kind") == "table");
    }
}

// A line can do what a threshold of one of its features does, and a table of counts what any line
// of rising offset does.
TEST(FeaturePairs, MoreFreedomLetsLessThrough) {
    const auto rate = [](const std::string& features, const std::string& kind) {
        return figure_of(features, kind, "false_positive_rate");
    };
    for (std::size_t a = 0; a < feature_count; ++a)
        for (std::size_t b = a + 1; b < feature_count; ++b) {
            const std::string first = feature_list[a].name;
            const std::string second = feature_list[b].name;
            EXPECT_LE(rate(first + ", " + second, "line"),
                      std::min(rate(first, "threshold"), rate(second, "threshold")));
        }
    EXPECT_LE(rate("offset for each count, falling", "table"),
              rate("mass_offset, neighbor_count", "line"));
    EXPECT_LE(rate("offset for each count", "table"),
              rate("offset for each count, falling", "table"));
}

TEST(FeaturePairs, OneSceneLeavesNothingOut) {
    const Table one = feature_pairs({states()[0]}, {label_threshold, 1, {1, no_time}});
    for (const auto& row : one.rows) {
        EXPECT_TRUE(is_empty_in(one, row, "left_out_false_negatives"));
        EXPECT_TRUE(is_empty_in(one, row, "left_out_miss_rate"));
        EXPECT_TRUE(is_empty_in(one, row, "left_out_false_positive_rate"));
    }
}

struct Wrong {
    double missed = 0;
    double false_positives = 0;
};

/// Of a detector of the list, in parts of the surface and of all particles.
Wrong wrong_by(const std::vector<Detector<float>>& all, std::size_t detector) {
    Wrong wrong;
    double surface_particles = 0;
    double particles = 0;
    for (const auto& state : states()) {
        std::vector<std::uint8_t> surface;
        all.at(detector).prepare(state, 2)(surface);
        particles += static_cast<double>(state.size());
        for (std::size_t i = 0; i < state.size(); ++i) {
            surface_particles += state.surface[i];
            wrong.missed += state.surface[i] != 0 && surface[i] == 0 ? 1 : 0;
            wrong.false_positives += state.surface[i] == 0 && surface[i] != 0 ? 1 : 0;
        }
    }
    return {wrong.missed / surface_particles, wrong.false_positives / particles};
}

// Rivals are written well enough to come near the exact labels on real states.
TEST(Rivals, ComeNearTheExactLabels) {
    std::vector<Detector<float>> all;
    add_eigenvalue_detectors(3, all);
    const Wrong alone = wrong_by(all, 0);
    EXPECT_LT(alone.missed, 0.02);
    EXPECT_LT(alone.false_positives, 0.02);
    for (const std::size_t with_cone : {1U, 2U}) {
        const Wrong cone = wrong_by(all, with_cone);
        EXPECT_LT(cone.false_positives, alone.false_positives); // the second step only takes away
        EXPECT_GT(cone.missed, alone.missed);
        EXPECT_LT(cone.missed, 0.06);
    }
    all.clear();
    add_divergence_detectors(3, all);
    EXPECT_GT(wrong_by(all, 0).missed, wrong_by(all, 1).missed); // a layer more
    EXPECT_LT(wrong_by(all, 2).missed, 0.02);
    all.clear();
    add_visibility_detectors(3, all);
    for (std::size_t d = 0; d < all.size(); ++d) {
        EXPECT_LT(wrong_by(all, d).missed, 0.15) << all[d].name;
        EXPECT_LT(wrong_by(all, d).false_positives, 0.02) << all[d].name;
    }
}

} // namespace
} // namespace meniscus
