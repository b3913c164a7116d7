// Labels where every particle has a support radius of its own.
#include "droplets.hpp"

#include "data/expected_errors.hpp"

#include <meniscus/data/formats/snapshot_files.hpp>
#include <meniscus/data/particles/particle_arrays.hpp>
#include <meniscus/data/particles/particle_volumes.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/labeler/labeler.hpp>

#include <cmath>
#include <gtest/gtest.h>

namespace meniscus {
namespace {

namespace fs = std::filesystem;

using test::Droplet;

/// How a droplet is made, and how large it is in two dimensions and in three.
struct Kind {
    const char* name;
    Droplet (*make)(int dimension, double radius, double spacings_per_radius);
};

const Kind kinds[] = {{"halves", test::halves},
                      {"refined_surface", test::refined_surface},
                      {"refined_core", test::refined_core},
                      {"graded", test::graded}};

class Droplets : public testing::TestWithParam<std::tuple<Kind, int, double>> {
protected:
    [[nodiscard]] static int dimension() { return std::get<1>(GetParam()); }

    static Droplet droplet() {
        return std::get<0>(GetParam())
            .make(dimension(), dimension() == 2 ? 40 : 14, std::get<2>(GetParam()));
    }
};

INSTANTIATE_TEST_SUITE_P(Kinds, Droplets,
                         testing::Combine(testing::ValuesIn(kinds), testing::Values(2, 3),
                                          testing::Values(2.0, 2.5)),
                         [](const auto& info) {
                             return std::string(std::get<0>(info.param).name) +
                                    std::to_string(std::get<1>(info.param)) + "d_" +
                                    std::to_string(std::lround(10 * std::get<2>(info.param)));
                         });

TEST_P(Droplets, AreSurfaceAtTheirSurfaceAlone) {
    const Droplet drop = droplet();
    const auto labels =
        label_particles(drop.snapshot, support_radii(drop.snapshot), LabelOptions{});
    std::size_t outermost = 0;
    for (std::size_t i = 0; i < drop.snapshot.size(); ++i) {
        if (drop.outermost[i]) {
            EXPECT_EQ(labels.surface[i], 1) << "particle " << i;
            ++outermost;
        }
        if (drop.depth[i] > 2) {
            EXPECT_EQ(labels.surface[i], 0) << "particle " << i << " at depth " << drop.depth[i];
        }
    }
    EXPECT_GT(outermost, 50U);
    EXPECT_LT(outermost, drop.snapshot.size() / 2);
}

TEST_P(Droplets, AreSurfaceAtTheirSurfaceAloneWhenShaken) {
    Droplet drop = droplet();
    shake(0.1, drop);
    const auto labels =
        label_particles(drop.snapshot, support_radii(drop.snapshot), LabelOptions{});
    for (std::size_t i = 0; i < drop.snapshot.size(); ++i) {
        if (drop.depth[i] < 0.3) {
            EXPECT_EQ(labels.surface[i], 1) << "particle " << i;
        }
        if (drop.depth[i] > 2) {
            EXPECT_EQ(labels.surface[i], 0) << "particle " << i << " at depth " << drop.depth[i];
        }
    }
}

TEST_P(Droplets, ExactAndMonteCarloAgree) {
    Droplet drop = droplet();
    shake(0.1, drop);
    LabelOptions options;
    const auto exact = label_particles(drop.snapshot, SupportRadii(drop.radii), options);
    options.method = LabelMethod::monte_carlo;
    options.samples = 2000;
    const auto sampled = label_particles(drop.snapshot, SupportRadii(drop.radii), options);
    EXPECT_EQ(exact.neighbor_count, sampled.neighbor_count);
    EXPECT_EQ(exact.mass_offset, sampled.mass_offset);
    for (std::size_t i = 0; i < drop.snapshot.size(); ++i) {
        const double lambda = exact.uncovered_fraction[i];
        const double error = std::sqrt(std::max(lambda * (1 - lambda), 1e-3) / 2000);
        EXPECT_LT(std::fabs(sampled.uncovered_fraction[i] - lambda), 6 * error) << i;
    }
}

TEST(SupportRadii, JumpsByAFactorOfFourLeaveOpenings) {
    // Not what one would wish for, but what docs/labels.md says.
    const Droplet drop = test::two_resolutions(
        3, 20, 2, [](const test::Place& position) { return position[0] < 0; }, 4);
    const auto labels =
        label_particles(drop.snapshot, support_radii(drop.snapshot), LabelOptions{});
    std::size_t deep = 0;
    for (std::size_t i = 0; i < drop.snapshot.size(); ++i)
        if (drop.depth[i] > 2 && labels.surface[i] != 0) {
            EXPECT_LT(std::fabs(drop.snapshot.positions[i][0]), 8) << i; // at the jump alone
            EXPECT_LT(labels.uncovered_fraction[i], 0.05) << i;
            ++deep;
        }
    EXPECT_GT(deep, 0U);
}

/// The labels that one radius for all gives, and those of the same particles with the same radius
/// each beside a lonely one of another, which keeps it from being one for all.
void expect_same_labels(const Snapshot& snapshot, double radius, const LabelOptions& options) {
    const auto one = label_particles(snapshot, radius, options);
    std::vector<double> radii(snapshot.size(), radius);
    const auto same = label_particles(snapshot, SupportRadii(radii), options);
    EXPECT_EQ(same.uncovered_fraction, one.uncovered_fraction);
    EXPECT_EQ(same.mass_offset, one.mass_offset);
    EXPECT_EQ(same.neighbor_count, one.neighbor_count);

    Snapshot beside;
    beside.dimension = snapshot.dimension;
    beside.positions = snapshot.positions;
    beside.boundary = snapshot.boundary;
    beside.positions.push_back({1e3, 1e3, snapshot.positions[0][2]});
    radii.push_back(3 * radius);
    auto each = label_particles(beside, SupportRadii(radii), options);
    EXPECT_EQ(each.surface.back(), 1);
    each.uncovered_fraction.pop_back();
    each.neighbor_count.pop_back();
    EXPECT_EQ(each.uncovered_fraction, one.uncovered_fraction); // to the bit
    for (std::size_t i = 0; i < snapshot.size(); ++i)
        EXPECT_NEAR(each.neighbor_count[i], one.neighbor_count[i], 1e-12) << i;
    for (std::size_t i = 0; i < snapshot.size(); ++i)
        EXPECT_NEAR(each.mass_offset[i], one.mass_offset[i], 1e-14) << i;
}

TEST(SupportRadii, EqualOnesGiveTheLabelsOfOneForAll) {
    for (const int dimension : {2, 3}) {
        Droplet drop;
        drop.snapshot.dimension = dimension;
        test::for_lattice_in_ball(dimension, 1, 8, [&](const test::Place& position, bool) {
            drop.add(position, 1, false, 0);
        });
        for (const bool shaken : {false, true}) {
            if (shaken)
                shake(0.3, drop);
            LabelOptions options;
            expect_same_labels(drop.snapshot, 2.1, options);
            options.method = LabelMethod::monte_carlo;
            options.samples = 1000;
            expect_same_labels(drop.snapshot, 2.1, options);
        }
        // At exactly two spacings the band decides, by the same rule.
        drop.snapshot.positions.clear();
        test::for_lattice_in_ball(dimension, 0.07, 0.4, [&](const test::Place& position, bool) {
            drop.snapshot.positions.push_back(position);
        });
        expect_same_labels(drop.snapshot, 0.14, LabelOptions{});
        // Below a wall that counts.
        for (int x = -6; x <= 6; ++x)
            drop.snapshot.boundary.push_back({0.07 * x, -0.42, drop.snapshot.positions[0][2]});
        LabelOptions options;
        expect_same_labels(drop.snapshot, 0.14, options);
    }
}

TEST(SupportRadii, FeaturesByHand) {
    Snapshot snapshot;
    snapshot.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1.2, 0}, {-1.6, 0, 0}};
    set_array(snapshot, {"mass", 1, std::vector<double>{1, 3, 8, 2}});
    // Mean radii with particle 0 are 2, 3 and 1.5: the last stands beyond.
    const SupportRadii radii({2, 2, 4, 1});
    const auto labels = label_particles(snapshot, radii, LabelOptions{});
    EXPECT_NEAR(labels.neighbor_count[0], 1 + 64.0 / 27, 1e-14);
    const double of_first = 3.0 / 8;
    const double of_second = 8.0 / 27;
    EXPECT_NEAR(labels.mass_offset[0],
                std::hypot(of_first * 0.5, of_second * 0.4) / (of_first + of_second), 1e-14);
    snapshot.dimension = 2;
    EXPECT_NEAR(label_particles(snapshot, radii, LabelOptions{}).neighbor_count[0], 1 + 16.0 / 9,
                1e-14);
}

TEST(SupportRadii, WallsAreMeasuredInTheParticlesOwn) {
    Snapshot snapshot;
    snapshot.positions = {{0, 0, 0}, {100, 0, 0}};
    set_array(snapshot, {"mass", 1, std::vector<double>{1, 8}});
    snapshot.boundary = {{0, -0.9, 0}, {0, 1.1, 0}, {100, -1.9, 0}, {100, 0.5, 0}, {100, 2.1, 0}};
    const SupportRadii radii({1, 2});
    LabelOptions options;
    options.boundary_weight = 1;
    const auto labels = label_particles(snapshot, radii, options);
    // Fluid particles are alone, so their volume is measured as that of their own kernel; a wall
    // particle weighs eight times as much for half the radius.
    const auto weights = boundary_weights(snapshot, radii, {1, 1}, labels.spacing_ratio, 1);
    EXPECT_NEAR(labels.neighbor_count[0], weights.of(0, 1, 3), 1e-14);
    EXPECT_NEAR(labels.neighbor_count[1], weights.of(2, 2, 3) + weights.of(3, 2, 3), 1e-14);
    EXPECT_NEAR(weights.of(0, 1, 3), 8 * weights.of(0, 2, 3), 1e-14);
    EXPECT_NEAR(labels.mass_offset[0], 0.9, 1e-14);
    EXPECT_NEAR(labels.mass_offset[1],
                (1.9 * weights.of(2, 2, 3) - 0.5 * weights.of(3, 2, 3)) /
                    (2 * labels.neighbor_count[1]),
                1e-14);
    // The cap of a sphere of radius 0.8 at distance 0.9 from one of radius 1.
    EXPECT_NEAR(labels.uncovered_fraction[0], 1 - (1 - (0.81 + 1 - 0.64) / 1.8) / 2, 1e-12);
}

TEST(SupportRadii, AreStoredWithTheLabels) {
    Droplet drop = test::halves(2, 12, 2);
    std::vector<float> radii(drop.radii.begin(), drop.radii.end());
    set_array(drop.snapshot, {"support_radius", 1, radii});
    const SupportRadii each = support_radii(drop.snapshot);
    const auto labels = label_particles(drop.snapshot, each, LabelOptions{});
    add_labels(drop.snapshot, labels, each, LabelOptions{});
    EXPECT_FALSE(drop.snapshot.support_radius);
    EXPECT_EQ(drop.snapshot.provenance.at("support_radius"), "2 to 4");
    // As it was stored.
    EXPECT_EQ(std::get<std::vector<float>>(scalar_array(drop.snapshot, "support_radius").values),
              radii);
    EXPECT_EQ(std::get<std::vector<double>>(scalar_array(drop.snapshot, "neighbor_count").values),
              labels.neighbor_count);
    // Radii that are not the snapshot's own become so.
    add_labels(drop.snapshot, labels, SupportRadii(std::vector<double>(drop.radii.size(), 3)),
               LabelOptions{});
    EXPECT_EQ(drop.snapshot.support_radius, 3.0);
    std::transform(drop.radii.begin(), drop.radii.end(), drop.radii.begin(),
                   [](double radius) { return 2 * radius; });
    add_labels(drop.snapshot, labels, SupportRadii(drop.radii), LabelOptions{});
    EXPECT_FALSE(drop.snapshot.support_radius);
    EXPECT_EQ(scalar_values(drop.snapshot, "support_radius"), drop.radii);
}

TEST(SupportRadii, ThatCannotBeUsedAreRefused) {
    Droplet drop = test::halves(3, 5, 2);
    for (const double bad : {0.0, -1.0, std::nan("")}) {
        drop.radii[11] = bad;
        expect_mentions(error_of<InputError>(
                            [&] { label_particles(drop.snapshot, SupportRadii(drop.radii), {}); }),
                        {"particle 11", "positive"});
    }
    drop.snapshot.positions[11][0] = std::nan(""); // which takes part in nothing
    LabelOptions options;
    options.skip_invalid = true;
    EXPECT_EQ(label_particles(drop.snapshot, SupportRadii(drop.radii), options).valid[11], 0);
    drop.radii[12] = 1e4;
    expect_mentions(error_of<InputError>(
                        [&] { label_particles(drop.snapshot, SupportRadii(drop.radii), options); }),
                    {"particle 12", "factor of 1000"});
}

/// PySPH's dam breaks, whose smoothing lengths follow the density.
class DamBreaks : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(States, DamBreaks,
                         testing::Values("dam_break_2d_04000.hdf5", "dam_break_2d_08000.hdf5"),
                         [](const auto& info) { return std::string(info.param).substr(0, 18); });

TEST_P(DamBreaks, HaveNearlyTheLabelsOfOneRadius) {
    const fs::path file = fs::path(MENISCUS_SHARED_SNAPSHOTS) / "pysph" / GetParam();
    if (!fs::exists(file))
        GTEST_SKIP() << "no shared snapshots here";
    const Snapshot snapshot = read_snapshot(file);
    const SupportRadii radii = support_radii(snapshot);
    ASSERT_TRUE(radii.vary());
    const auto each = label_particles(snapshot, radii, LabelOptions{});
    const auto one = label_particles(snapshot, 0.078, LabelOptions{});
    std::size_t differ = 0;
    std::size_t surface = 0;
    for (std::size_t i = 0; i < snapshot.size(); ++i) {
        surface += one.surface[i];
        differ += static_cast<std::size_t>(each.surface[i] != one.surface[i]);
    }
    EXPECT_GT(surface, 100U);
    EXPECT_LE(100 * differ, surface);
    // They are not the same all the same.
    EXPECT_NE(each.uncovered_fraction, one.uncovered_fraction);
}

} // namespace
} // namespace meniscus
