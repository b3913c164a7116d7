// Exact labels against Monte Carlo ones, which share nothing with them but the neighbors.
#include "reference/exact_reference.hpp"
#include <meniscus/data/formats/snapshot_files.hpp>
#include <meniscus/data/particles/particle_volumes.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/labeler/exact/exact_labels.hpp>
#include <meniscus/labeler/labeler.hpp>
#include <meniscus/labeler/monte_carlo/coverage.hpp>
#include <runtime/random_caps.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <map>

namespace meniscus {
namespace {

namespace fs = std::filesystem;

/// Standard error of lambda by that many independent directions.
double standard_error(double lambda, double samples) {
    return std::sqrt(std::max(lambda * (1 - lambda), 1 / samples) / samples);
}

void expect_agreement(const Snapshot& snapshot, double support_radius) {
    LabelOptions options;
    options.skip_invalid = true;
    const Labels exact = label_particles(snapshot, support_radius, options);
    options.method = LabelMethod::monte_carlo;
    const Labels sampled = label_particles(snapshot, support_radius, options);
    const auto samples = static_cast<double>(options.samples);
    std::size_t surface = 0;
    for (std::size_t i = 0; i < snapshot.size(); ++i) {
        const double lambda = exact.uncovered_fraction[i];
        surface += exact.surface[i];
        ASSERT_LT(std::abs(sampled.uncovered_fraction[i] - lambda),
                  6 * standard_error(lambda, samples))
            << "particle " << i << ", lambda " << lambda;
        if (std::max(lambda, sampled.uncovered_fraction[i]) > 20 / samples) {
            ASSERT_EQ(exact.surface[i], sampled.surface[i]) << "particle " << i;
        }
    }
    EXPECT_GT(surface, 0U);
    EXPECT_EQ(exact.neighbor_count, sampled.neighbor_count);
    EXPECT_EQ(exact.mass_offset, sampled.mass_offset);
}

class ExactLabels : public testing::TestWithParam<fs::path> {};

TEST_P(ExactLabels, AgreeWithMonteCarloOnSamples) {
    const Snapshot snapshot = read_snapshot(GetParam());
    expect_agreement(snapshot, *snapshot.support_radius);
}

std::vector<fs::path> files_in(const fs::path& folder, const std::string& extension) {
    std::vector<fs::path> files;
    if (fs::exists(folder))
        for (const auto& entry : fs::directory_iterator(folder))
            if (entry.path().extension() == extension)
                files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

std::string stem_of(const testing::TestParamInfo<fs::path>& info) {
    return info.param.stem().string();
}

INSTANTIATE_TEST_SUITE_P(Samples, ExactLabels,
                         testing::ValuesIn(files_in(MENISCUS_SAMPLES, ".vtkhdf")), stem_of);

/// Shared states that are not among the samples, with their support radii.
class ExactLabelsOfShared : public testing::TestWithParam<std::pair<const char*, double>> {};

TEST_P(ExactLabelsOfShared, AgreeWithMonteCarlo) {
    const auto [name, support_radius] = GetParam();
    const fs::path file = fs::path(MENISCUS_SHARED_SNAPSHOTS) / name;
    if (!fs::exists(file))
        GTEST_SKIP() << "no shared snapshots here";
    Snapshot snapshot = read_snapshot(file);
    expect_agreement(snapshot, support_radius);
    if (!snapshot.boundary.empty()) {
        snapshot.boundary.clear();
        expect_agreement(snapshot, support_radius);
    }
}

INSTANTIATE_TEST_SUITE_P(States, ExactLabelsOfShared,
                         testing::Values(std::pair{"splishsplash/cube_iisph_partio.bgeo", 0.08},
                                         std::pair{"splishsplash/dam_wcsph_04_with_nan.vtk", 0.08},
                                         std::pair{"splishsplash/dam_boundary.vtk", 0.08},
                                         std::pair{"splishsplash/boxhole_boundary.vtk", 0.08},
                                         std::pair{"pysph/dam_break_2d_04000.hdf5", 0.078},
                                         std::pair{"pysph/dam_break_2d_08000.hdf5", 0.078},
                                         std::pair{"pysph/elliptical_drop_00100.hdf5", 0.065}));

TEST(ExactCoverageOfTheLabeler, EqualsDenseMonteCarlo) {
    constexpr std::size_t samples = 20000;
    std::mt19937_64 generator(7);
    const auto exact = exact_labels();
    for (const int dimension : {2, 3}) {
        std::vector<Direction> directions(samples);
        sampling_scheme("halton").fill(dimension, 0, 0, directions);
        const DirectionBlocks blocks = compact_blocks(std::move(directions));
        Caps caps;
        std::uniform_real_distribution<double> any_ratio(0.01, 0.99);
        for (int trial = 0; trial < 20000; ++trial) {
            caps.radius_ratio = trial % 2 == 0 ? test_radius_ratio : any_ratio(generator);
            caps.displacements = random_neighborhood(generator, dimension, caps.radius_ratio);
            const double sampled =
                static_cast<double>(count_uncovered(blocks, caps)) / static_cast<double>(samples);
            const double lambda =
                exact->uncovered_fraction(dimension, caps.displacements, caps.radius_ratio);
            ASSERT_LT(std::abs(sampled - lambda), 6 * standard_error(lambda, samples))
                << dimension << "D, trial " << trial;
        }
    }
}

TEST(ExactCoverageOfTheLabeler, EqualsTheReference) {
    std::mt19937_64 generator(9);
    const auto exact = exact_labels();
    for (int trial = 0; trial < 20000; ++trial) {
        const auto neighbors = random_neighborhood(generator, 3);
        ASSERT_NEAR(exact->uncovered_fraction(3, neighbors, test_radius_ratio),
                    uncovered_fraction_reference(neighbors, test_radius_ratio), 1e-9)
            << trial;
    }
}

TEST(ExactCoverageOfTheLabeler, HasTheSameBitsWithEveryInstructionSet) {
    std::mt19937_64 generator(8);
    const auto baseline = exact_labels(InstructionSet::baseline);
    for (const InstructionSet set : instruction_sets) {
        if (set == InstructionSet::baseline || !is_supported(set))
            continue;
        SCOPED_TRACE(name_of(set));
        const auto other = exact_labels(set);
        for (int trial = 0; trial < 4000; ++trial) {
            const int dimension = trial % 2 == 0 ? 3 : 2;
            const auto neighbors = random_neighborhood(generator, dimension);
            const double lambda =
                baseline->uncovered_fraction(dimension, neighbors, test_radius_ratio);
            ASSERT_EQ(other->uncovered_fraction(dimension, neighbors, test_radius_ratio), lambda)
                << trial;
            ASSERT_EQ(other->is_uncovered(dimension, neighbors, test_radius_ratio),
                      lambda > zero_uncovered_fraction);
        }
    }
}

/// A cube of particles on a floor and between walls of boundary particles.
Snapshot basin(int side) {
    Snapshot snapshot;
    for (int x = -1; x <= side; ++x)
        for (int y = -1; y <= side; ++y)
            for (int z = -1; z < side; ++z) {
                const bool inside = x >= 0 && x < side && y >= 0 && y < side && z >= 0;
                (inside ? snapshot.positions : snapshot.boundary)
                    .push_back({1.0 * x, 1.0 * y, 1.0 * z});
            }
    return snapshot;
}

/// The first frame of many scenes: h is exactly two (or two and a half) spacings, and wherever the
/// lattice stands, in float or in double, the same neighbors count and the same particles are
/// surface.
TEST(Lattices, LabelsDoNotDependOnWhereTheyStand) {
    std::mt19937_64 generator(12);
    std::uniform_real_distribution<double> offset(-5, 5);
    constexpr int side = 7;
    for (const double spacings : {2.0, 2.5}) {
        constexpr double h = 0.08;
        Snapshot lattice;
        for (int x = 0; x < side; ++x)
            for (int y = 0; y < side; ++y)
                for (int z = 0; z < side; ++z)
                    lattice.positions.push_back(
                        {x * h / spacings, y * h / spacings, z * h / spacings});
        const Labels still = label_particles(lattice, h, LabelOptions{});
        const std::size_t inside = side * side * side / 2;
        EXPECT_EQ(still.neighbor_count[inside], spacings == 2 ? 26 : 80);
        EXPECT_EQ(still.uncovered_fraction[inside], 0);
        for (int trial = 0; trial < 40; ++trial) {
            Snapshot moved = lattice;
            const Direction by{offset(generator), offset(generator), offset(generator)};
            for (auto& position : moved.positions)
                for (int axis = 0; axis < 3; ++axis) {
                    position[axis] += by[axis];
                    if (trial % 2 == 0)
                        position[axis] = static_cast<float>(position[axis]);
                }
            const Labels labels = label_particles(moved, h, LabelOptions{});
            ASSERT_EQ(labels.neighbor_count, still.neighbor_count) << trial;
            ASSERT_EQ(labels.surface, still.surface) << trial;
            for (std::size_t i = 0; i < moved.size(); ++i)
                ASSERT_NEAR(labels.uncovered_fraction[i], still.uncovered_fraction[i],
                            trial % 2 == 0 ? 1e-4 : 1e-9)
                    << trial;
        }
    }
}

TEST(Boundary, ParticlesAtAWallAreNotAtTheSurface) {
    for (const LabelMethod method : {LabelMethod::exact, LabelMethod::monte_carlo}) {
        Snapshot snapshot = basin(6);
        LabelOptions options;
        options.method = method;
        options.samples = 2000;
        const Labels labels = label_particles(snapshot, 2.0, options);
        for (std::size_t i = 0; i < snapshot.size(); ++i)
            EXPECT_EQ(labels.surface[i] != 0, snapshot.positions[i][2] == 5) << "particle " << i;
        // Where they only cover, the features are those of the fluid alone.
        options.boundary_weight = 0;
        const Labels with = label_particles(snapshot, 2.0, options);
        snapshot.boundary.clear();
        const Labels without = label_particles(snapshot, 2.0, options);
        EXPECT_EQ(with.neighbor_count, without.neighbor_count);
        EXPECT_EQ(with.mass_offset, without.mass_offset);
        EXPECT_GT(std::count(without.surface.begin(), without.surface.end(), 1),
                  std::count(with.surface.begin(), with.surface.end(), 1));
    }
}

/// The volume that makes boundary particles weigh one each which are farther than h from all
/// others.
double volume_of_lone_boundary(int dimension, double h) {
    return std::pow(h, dimension) / (dimension == 2 ? 40 / (7 * pi) : 8 / pi);
}

TEST(Boundary, CountsInTheFeaturesByOption) {
    Snapshot snapshot;
    // A particle between a fluid neighbor and a wall; one of another phase and one that is not
    // finite.
    snapshot.positions = {{0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}, {std::nan(""), 0, 0}};
    set_array(snapshot, {"mass", 1, std::vector<double>{1, 3, 5, 100}});
    set_array(snapshot, {"phase", 1, std::vector<std::int32_t>{0, 0, 1, 0}});
    // One within range of all, one beyond h; each stands for two particles.
    snapshot.boundary = {{0, -0.4, 0}, {0, 0, 5}};
    snapshot.particle_volume = volume_of_lone_boundary(3, 1) / 2;
    LabelOptions options;
    options.skip_invalid = true;
    options.boundary_weight = 0;
    const Labels without = label_particles(snapshot, 1, options);
    EXPECT_EQ(without.neighbor_count, (std::vector<double>{1, 1, 0, 0}));
    options.boundary_weight = 1;
    const Labels with = label_particles(snapshot, 1, options);
    for (std::size_t i = 0; i < snapshot.size(); ++i)
        EXPECT_NEAR(with.neighbor_count[i], (std::array{3, 3, 2, 0}[i]), 1e-14);
    // A boundary particle has the mean mass of the fluid neighbors, twice:
    // (3 (0.5, 0) + 6 (0, -0.4)) / (3 + 6)
    EXPECT_NEAR(with.mass_offset[0], std::hypot(0.5 / 3, 0.8 / 3), 1e-14);
    // (1 (-0.5, 0) + 2 (-0.5, -0.4)) / 3
    EXPECT_NEAR(with.mass_offset[1], std::hypot(0.5, 0.8 / 3), 1e-14);
    EXPECT_NEAR(with.mass_offset[2], 0.9, 1e-14); // beside nothing but the wall
    EXPECT_EQ(with.uncovered_fraction, without.uncovered_fraction);
    snapshot.boundary.clear();
    EXPECT_EQ(label_particles(snapshot, 1, options).neighbor_count, without.neighbor_count);
}

/// One layer stands for the half-space behind it, by its own volumes: beside it a particle has
/// about as many neighbors as inside, and its offset all but vanishes.
TEST(Boundary, ThatCountsMakesAWallLookLikeFluid) {
    Snapshot snapshot = basin(9);
    LabelOptions options;
    for (const bool counts : {false, true}) {
        options.boundary_weight = counts ? 1 : 0;
        const Labels labels = label_particles(snapshot, 2.1, options);
        for (std::size_t i = 0; i < snapshot.size(); ++i) {
            const auto& at = snapshot.positions[i];
            const bool at_floor = at[2] == 0 && at[0] > 2 && at[0] < 6 && at[1] > 2 && at[1] < 6;
            if (at_floor && counts) {
                EXPECT_NEAR(labels.neighbor_count[i], 32, 4) << "particle " << i;
                EXPECT_LT(labels.mass_offset[i], 0.08) << "particle " << i;
            } else if (at_floor) {
                EXPECT_LT(labels.neighbor_count[i], 24) << "particle " << i;
                EXPECT_GT(labels.mass_offset[i], 0.15) << "particle " << i;
            }
        }
    }
}

/// Volumes by hand: a row of boundary particles half of h apart, and a fluid of known volume.
TEST(Boundary, WeighsByItsVolume) {
    Snapshot snapshot;
    snapshot.dimension = 2;
    snapshot.positions = {{0, 0, 0}, {10, 0, 0}};
    for (int x = -6; x <= 6; ++x)
        snapshot.boundary.push_back({0.5 * x, 1, 0});
    snapshot.particle_volume = 0.2;
    const std::vector<std::uint8_t> valid(2, 1);
    const auto weights =
        boundary_weights(snapshot, 1.0, valid, measured_spacing_ratio(snapshot, 1.0, valid, 1), 1);
    const double scale = 40 / (7 * pi);
    EXPECT_NEAR(weights.of(6, 1, 2), 1 / (scale * (1 + 2 * 0.25)) / 0.2, 1e-14);
    EXPECT_NEAR(weights.of(0, 1, 2), 1 / (scale * (1 + 0.25)) / 0.2, 1e-14); // at the end
    EXPECT_NEAR(weights.of(6, 2, 2), weights.of(6, 1, 2) / 4, 1e-14);
    // Without one, that of a fluid of the same spacing is measured.
    snapshot.particle_volume.reset();
    snapshot.positions.clear();
    for (int x = 0; x < 40; ++x)
        for (int y = 0; y < 40; ++y)
            snapshot.positions.push_back({0.5 * x, 0.5 * y, 0});
    const std::vector<std::uint8_t> all(1600, 1);
    const double ratio = measured_spacing_ratio(snapshot, 1.0, all, 1);
    const auto measured = boundary_weights(snapshot, 1.0, all, ratio, 1);
    const double inside = 1 + 4 * 0.25 + 4 * 2 * std::pow(1 - std::sqrt(0.5), 3);
    EXPECT_NEAR(measured.of(6, 1, 2), inside / 1.5, 1e-12);
    EXPECT_NEAR(ratio, std::sqrt(scale * inside), 1e-12);
    snapshot.particle_spacing = 0.25; // which says that the fluid is spread thin
    EXPECT_EQ(measured_spacing_ratio(snapshot, 1.0, all, 1), 4);
}

TEST(Boundary, MustBeFiniteAndInTheFluidsPlane) {
    Snapshot snapshot = basin(2);
    snapshot.boundary[3][1] = std::nan("");
    EXPECT_THROW(label_particles(snapshot, 2.0, LabelOptions{}), InputError);
    snapshot.boundary = {{-1, 0, 0.5}};
    snapshot.positions = {{0, 0, 0}, {1, 0, 0}};
    snapshot.dimension = 2;
    EXPECT_THROW(label_particles(snapshot, 2.0, LabelOptions{}), InputError);
    snapshot.boundary = {{-1, 0, 0}};
    EXPECT_NO_THROW(label_particles(snapshot, 2.0, LabelOptions{}));
    snapshot.positions.clear();
    EXPECT_NO_THROW(label_particles(snapshot, 2.0, LabelOptions{}));
}

} // namespace
} // namespace meniscus
