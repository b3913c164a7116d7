// Models on states whose particles have support radii of their own.
#include "data/expected_errors.hpp"
#include "labeler/droplets.hpp"

#include <meniscus/classifier/audit/audit.hpp>
#include <meniscus/classifier/model/classify_snapshot.hpp>
#include <meniscus/classifier/objectives/trainer.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/labeler/labeler.hpp>

#include <gtest/gtest.h>
#include <string>

namespace meniscus {
namespace {

using test::Droplet;

/// The droplet with its labels.
Snapshot labelled(Droplet drop, const LabelOptions& options = {}) {
    const SupportRadii radii(drop.radii);
    add_labels(drop.snapshot, label_particles(drop.snapshot, radii, options), radii, options);
    return drop.snapshot;
}

AuditRow audit_of(const Model& model, const Snapshot& snapshot, double label_threshold) {
    return audit_state(model, snapshot, labelled_state(snapshot, "droplet.vtkhdf"),
                       label_threshold);
}

class ShippedModelsOnDroplets : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Models, ShippedModelsOnDroplets,
                         testing::Values("surface_3d", "surface_3d_wide"),
                         [](const auto& info) { return std::string(info.param); });

TEST_P(ShippedModelsOnDroplets, MissNoWideOpening) {
    const Model model = read_model(std::string(MENISCUS_MODELS) + "/" + GetParam() + ".json");
    for (const auto make : {test::halves, test::refined_surface, test::refined_core, test::graded})
        for (const double spacings_per_radius : {2.0, 2.1})
            for (const double shaken : {0.0, 0.1}) {
                Droplet drop = make(3, 14, spacings_per_radius);
                shake(shaken, drop);
                const AuditRow row = audit_of(model, labelled(drop), 0.02);
                EXPECT_GT(row.surface_particles, 400U);
                EXPECT_EQ(row.false_negatives, 0U);
                EXPECT_EQ(row.false_negatives_float, 0U);
                EXPECT_EQ(row.features_differ, 0U);
                // At 2 spacings a lattice has 26 neighbors, hardly more than the line asks for.
                if (spacings_per_radius > 2) {
                    EXPECT_LT(false_positive_rate(row), 0.6);
                }
            }
}

TEST(SupportRadiiOfClasses, FeaturesAreThoseOfTheLabels) {
    for (const int dimension : {2, 3})
        for (const double boundary_weight : {0.0, 0.85}) {
            Droplet drop = test::graded(dimension, dimension == 2 ? 30 : 10, 2.3);
            // A wall through the middle, of another spacing.
            const double far = drop.snapshot.positions.back()[0];
            for (double y = -30; y < 30; y += 0.7)
                drop.snapshot.boundary.push_back({far, y, 0});
            LabelOptions options;
            options.boundary_weight = boundary_weight;
            const Snapshot snapshot = labelled(drop, options);
            Model model;
            model.dimension = dimension;
            model.boundary_weight = boundary_weight;
            model.line = {40, 10};
            const AuditRow row = audit_of(model, snapshot, 0);
            EXPECT_EQ(row.features_differ, 0U);
            EXPECT_GT(row.surface_particles, 0U);
            // What the line says of the stored features.
            const auto x = scalar_values(snapshot, "mass_offset");
            const auto y = scalar_values(snapshot, "neighbor_count");
            const Classes classes = classify_snapshot(snapshot, model, {});
            for (std::size_t i = 0; i < snapshot.size(); ++i) {
                EXPECT_NEAR(classes.neighbor_count[i], y[i], 1e-9);
                EXPECT_EQ(classes.surface[i] != 0, predicts_surface(model.line, x[i], y[i])) << i;
            }
        }
}

TEST(SupportRadiiOfClasses, EqualOnesGiveTheClassesOfOneForAll) {
    Droplet drop;
    test::for_lattice_in_ball(
        3, 1, 8, [&](const test::Place& position, bool) { drop.add(position, 1, false, 0); });
    shake(0.3, drop);
    Snapshot one = drop.snapshot;
    one.support_radius = 2.0;
    drop.store_arrays();
    Snapshot varying = drop.snapshot;
    varying.positions.push_back({1e3, 0, 0});
    drop.radii.push_back(3);
    for (PointArray& array : varying.point_data) // masses as they were, one more
        std::get<std::vector<double>>(array.values).push_back(3);
    Model model;
    model.line = {20.3, 25.7};
    const Classes expected = classify_snapshot(one, model, {});
    const Classes same = classify_snapshot(drop.snapshot, model, {});
    EXPECT_EQ(same.surface, expected.surface);
    EXPECT_EQ(same.neighbor_count, expected.neighbor_count);
    Classes each = classify_snapshot(varying, model, {});
    each.surface.pop_back();
    each.neighbor_count.pop_back();
    EXPECT_EQ(each.surface, expected.surface);
    EXPECT_EQ(each.neighbor_count, expected.neighbor_count);
}

TEST(SupportRadiiOfClasses, AreReadWithTheLabels) {
    Snapshot snapshot = labelled(test::halves(3, 6, 2));
    snapshot.particle_spacing = 1;
    const LabelledState state = labelled_state(snapshot, "halves.vtkhdf");
    EXPECT_FALSE(state.support_radius);
    EXPECT_FALSE(state.spacing_ratio);
    EXPECT_EQ(state.neighbor_count, scalar_values(snapshot, "neighbor_count"));
    Model model;
    model.spacing_ratio = Range{1, 4};
    EXPECT_TRUE(classify_snapshot(snapshot, model, {}).warnings.empty());

    auto counts = state.neighbor_count;
    counts[4] = 8.0 * static_cast<double>(snapshot.size()) + 1;
    set_array(snapshot, {"neighbor_count", 1, counts});
    expect_mentions(error_of<InputError>([&] { labelled_state(snapshot, "halves.vtkhdf"); }),
                    {"halves.vtkhdf", "'neighbor_count' of particle 4"});
}

TEST(SupportRadiiOfClasses, TrainingRefusesThem) {
    const auto state = labelled_state(labelled(test::halves(3, 6, 2)), "halves.vtkhdf");
    expect_mentions(error_of<InputError>([&] { train({state}, {}); }),
                    {"halves.vtkhdf", "support radii of their own", "--support-radius"});
}

TEST(SupportRadiiOfClasses, ThatCannotBeUsedAreRefused) {
    Snapshot snapshot = labelled(test::halves(3, 6, 2));
    auto radii = scalar_values(snapshot, "support_radius");
    radii[9] = -1;
    set_array(snapshot, {"support_radius", 1, radii});
    const auto names_the_particle = [](const std::string& message) {
        expect_mentions(message, {"particle 9", "positive"});
    };
    names_the_particle(error_of<InputError>([&] { classify_snapshot(snapshot, Model{}, {}); }));
    names_the_particle(error_of<InputError>([&] { audit_of(Model{}, snapshot, 0); }));
}

} // namespace
} // namespace meniscus
