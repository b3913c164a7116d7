// Lines in the plane of any two features, from labels to the exported header.
#include "data/test_folder.hpp"
#include "synthetic_states.hpp"

#include <meniscus/classifier/audit/audit.hpp>
#include <meniscus/classifier/export/header_export.hpp>
#include <meniscus/classifier/model/classify_snapshot.hpp>
#include <meniscus/classifier/objectives/neyman_pearson.hpp>
#include <meniscus/classifier/objectives/scene_errors.hpp>
#include <meniscus/classifier/objectives/shift.hpp>
#include <meniscus/classifier/objectives/trainer.hpp>
#include <meniscus/data/particles/feature_names.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>
#include <meniscus/labeler/labeler.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <random>
#include <sstream>

namespace meniscus {
namespace {

/// A shaken lattice of edge^dimension particles of different masses, labelled, with all features.
Snapshot labelled_block(int dimension, int edge, bool radii_vary) {
    std::mt19937 random(dimension);
    std::uniform_real_distribution<double> shift(-0.25, 0.25);
    Snapshot snapshot;
    snapshot.dimension = dimension;
    snapshot.particle_spacing = 1;
    for (int x = 0; x < edge; ++x)
        for (int y = 0; y < edge; ++y)
            for (int z = 0; z < (dimension == 3 ? edge : 1); ++z)
                snapshot.positions.push_back({x + shift(random), y + shift(random),
                                              dimension == 3 ? z + shift(random) : 0.0});
    snapshot.positions.push_back({100, 0, 0}); // alone
    std::vector<double> masses;
    std::vector<double> radii;
    for (std::size_t i = 0; i < snapshot.size(); ++i) {
        masses.push_back(1 + shift(random));
        radii.push_back(radii_vary ? 2 + shift(random) : 2.0);
    }
    set_array(snapshot, {"mass", 1, masses});
    LabelOptions options;
    for (std::size_t f = 0; f < feature_count; ++f)
        options.features.push_back(f);
    const SupportRadii support = radii_vary ? SupportRadii(radii) : SupportRadii(2.0);
    add_labels(snapshot, label_particles(snapshot, support, options), support, options);
    return snapshot;
}

std::vector<FeaturePair> all_pairs() {
    std::vector<FeaturePair> pairs;
    for (std::size_t a = 0; a < feature_count; ++a)
        for (std::size_t b = 0; b < feature_count; ++b)
            if (a != b)
                pairs.push_back({a, b});
    return pairs;
}

TEST(FeatureLines, EveryPairTrainsAndPassesItsOwnAudit) {
    for (const int dimension : {2, 3}) {
        const Snapshot snapshot = labelled_block(dimension, dimension == 2 ? 16 : 7, false);
        for (const FeaturePair& pair : all_pairs()) {
            const LabelledState state = labelled_state(snapshot, "block.vtkhdf", pair);
            const Model model = train({state}, {});
            EXPECT_EQ(model.false_negatives, 0U) << names_of(pair);
            const Model read = model_from_json(model_to_json(model), "line.json");
            EXPECT_EQ(names_of(read.features), names_of(pair));
            EXPECT_EQ(read.line.above, model.line.above);
            const AuditRow row = audit_state(read, snapshot, state, 0);
            EXPECT_EQ(row.false_negatives, 0U) << names_of(pair);
            EXPECT_EQ(row.false_negatives_float, 0U) << names_of(pair);
            EXPECT_EQ(row.false_positives, model.false_positives) << names_of(pair);
            EXPECT_LT(row.false_positives, row.particles - row.surface_particles) << names_of(pair);
        }
    }
}

// Features of varying radii are those of the labels: lines that were trained on one radius hold.
TEST(FeatureLines, ClassifyParticlesOfDifferentRadii) {
    const Snapshot snapshot = labelled_block(3, 7, true);
    for (const FeaturePair& pair : all_pairs()) {
        const LabelledState state = labelled_state(snapshot, "block.vtkhdf", pair);
        Model model;
        model.features = pair;
        model.line = shift_line({state}, 0, -0.1);
        const AuditRow row = audit_state(model, snapshot, state, 0);
        const auto counts = count_errors({state}, model.line, 0);
        EXPECT_EQ(row.false_negatives + row.false_negatives_float, 0U) << names_of(pair);
        EXPECT_EQ(row.false_positives, counts[0].false_positives) << names_of(pair);
    }
}

/// The least rate over lines of every slope that could make a difference, on both sides.
double min_rate(const std::vector<LabelledState>& states) {
    const FeaturePair& pair = states.front().features;
    std::vector<std::array<double, 2>> points;
    for (const LabelledState& state : states)
        for (std::size_t i = 0; i < state.size(); ++i)
            points.push_back({state.x(i), state.y(i)});
    std::vector<double> slopes = {-max_slope(pair), max_slope(pair)};
    for (const auto& a : points)
        for (const auto& b : points)
            for (const double x_margin : {-1.0, 0.0, 1.0})
                for (const double y_margin : {-1.0, 0.0, 1.0}) {
                    const double k =
                        (a[1] + y_margin * feature_list[pair.second].float_error - b[1]) /
                        (a[0] + x_margin * feature_list[pair.first].float_error - b[0]);
                    if (std::abs(k) < max_slope(pair))
                        slopes.push_back(k);
                }
    std::sort(slopes.begin(), slopes.end());
    double min = 1;
    for (std::size_t s = 0; s + 1 < slopes.size(); ++s)
        for (const bool above : {false, true}) {
            // Where slopes are this close, rounding decides.
            if (slopes[s + 1] - slopes[s] < 1e-8 * (1 + std::abs(slopes[s])))
                continue;
            const double k = (slopes[s] + slopes[s + 1]) / 2;
            const auto errors = count_errors(states, shift_line(states, 0, k, above), 0);
            min = std::min(min, mean_false_positive_rate(errors));
        }
    return min;
}

TEST(FeatureLines, TrainerMatchesExhaustiveSearchInAnyPlane) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    const FeaturePair pair = feature_pair({"direction_offset", "gradient_eigenvalue"});
    std::size_t above = 0;
    for (int trial = 0; trial < 300; ++trial) {
        std::vector<LabelledState> states;
        for (const char* scene : {"first", "second"}) {
            LabelledState state = test::state_of(scene, {});
            state.features = pair;
            for (int i = 0; i < 6; ++i) {
                state.first.push_back(normal(random));
                state.second.push_back(normal(random));
                state.neighbor_count.push_back(1);
                state.uncovered_fraction.push_back(i % 3 == 0 ? 0.5 : 0.0);
            }
            states.push_back(state);
        }
        const Line line = min_false_positives(states, 0);
        const auto errors = count_errors(states, line, 0);
        EXPECT_EQ(errors[0].false_negatives + errors[1].false_negatives, 0U) << trial;
        EXPECT_NEAR(mean_false_positive_rate(errors), min_rate(states), 1e-12) << trial;
        above += line.above ? 1 : 0;
    }
    EXPECT_GT(above, 50U);
    EXPECT_LT(above, 250U);
}

TEST(FeatureLines, SayWhatCannotBe) {
    const Snapshot snapshot = labelled_block(2, 12, false);
    const auto error_of = [](const auto& work) {
        try {
            work();
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    const auto has = [](const std::string& text, const char* part) {
        EXPECT_NE(text.find(part), std::string::npos) << text;
    };
    has(error_of([] { feature_pair({"mass_offset", "density"}); }), "kernel_sum");
    has(error_of([] { feature_pair({"kernel_sum"}); }), "two different features");
    has(error_of([] { feature_pair({"kernel_sum", "kernel_sum"}); }), "two different features");
    const FeaturePair other = feature_pair({"mass_offset", "kernel_sum"});
    const LabelledState state = labelled_state(snapshot, "block.vtkhdf", other);
    TrainingOptions options;
    options.objective = "logistic";
    has(error_of([&] { train({state}, options); }), "--objective neyman-pearson");
    has(error_of([&] {
            train({state, labelled_state(snapshot, "b.vtkhdf")}, {});
        }),
        "mass_offset,kernel_sum");
    options = {};
    options.keep_k = train({labelled_state(snapshot, "block.vtkhdf")}, {});
    has(error_of([&] { train({state}, options); }), "--features mass_offset,neighbor_count");
    Snapshot plain = snapshot;
    const SupportRadii radii = 2.0;
    add_labels(plain, label_particles(plain, radii, {}), radii, {});
    EXPECT_EQ(find_array(plain, "kernel_sum"), nullptr); // of the earlier labelling
    has(error_of([&] { labelled_state(plain, "block.vtkhdf", other); }), "--features kernel_sum");
    const Model model = train({state}, {});
    has(error_of([&] { check_features_of_paper(model, "a scene"); }), "mass_offset,neighbor_count");
}

class ExportedFeatures : public TestFolder {
protected:
    /// What a host says that takes the header as its coefficients.
    std::string classes_of_host(const Model& model, const Snapshot& snapshot) {
        write("line.hpp", coefficient_header(model, "Line"));
        std::ostringstream source;
        source.precision(17);
        source << "#include \"line.hpp\"\n#include <meniscus/runtime/features/classifier.hpp>\n"
                  "#include <cstdio>\nconst double positions[][3] = {";
        for (const auto& position : snapshot.positions)
            source << "{" << position[0] << "," << position[1] << "," << position[2] << "},";
        source << "};\nconst double masses[] = {";
        for (const double mass : scalar_values(snapshot, "mass"))
            source << mass << ",";
        source << "};\nconstexpr double spacing_ratio = "
               << number_text(*labelled_state(snapshot, "block.vtkhdf").spacing_ratio) << R"(;
int main() {
    constexpr int dimension = meniscus::Line::dimension;
    const std::size_t count = sizeof masses / sizeof *masses;
    const auto view = [&](std::size_t i, auto&& visit) {
        for (std::size_t j = 0; j < count; ++j) {
            std::array<double, dimension> step;
            for (int axis = 0; axis < dimension; ++axis)
                step[axis] = positions[j][axis] - positions[i][axis];
            visit(j, step, masses[j]);
        }
    };
    static std::uint8_t surface[count];
    meniscus::classify<meniscus::Line, double, dimension>(
        view, meniscus::NoBoundary{}, 0, count, meniscus::UniformRadius<double>{2.0}, spacing_ratio,
        surface);
    for (const auto one : surface)
        std::putchar('0' + one);
}
)";
        const auto file = write("host.cpp", source.str());
        const auto program = (folder / "host").string();
        const std::string include = std::string(MENISCUS_RUNTIME) + "/../include";
        EXPECT_EQ(std::system((std::string(MENISCUS_CXX_COMPILER) +
                               " -std=c++17 -Wall -Wextra -Werror -O1 -I'" + include + "' '" +
                               file.string() + "' -o '" + program + "'")
                                  .c_str()),
                  0);
        EXPECT_EQ(std::system(("'" + program + "' > '" + program + ".out'").c_str()), 0);
        std::ifstream out(program + ".out");
        return {std::istreambuf_iterator<char>(out), {}};
    }
};

TEST_F(ExportedFeatures, HostClassifiesAsTheModelDoes) {
    const Snapshot snapshot = labelled_block(3, 7, false);
    for (const auto& names : {std::vector<std::string>{"neighbor_count", "direction_eigenvalue"},
                              {"kernel_sum", "squared_offset"}}) {
        const Model model =
            train({labelled_state(snapshot, "block.vtkhdf", feature_pair(names))}, {});
        std::string expected;
        for (const std::uint8_t one : classify_snapshot(snapshot, model, {}).surface)
            expected += static_cast<char>('0' + one);
        EXPECT_EQ(classes_of_host(model, snapshot), expected) << names[0];
        EXPECT_NE(expected.find('0'), std::string::npos);
    }
}

} // namespace
} // namespace meniscus
