#include "data/expected_errors.hpp"

#include <meniscus/labeler/labeler.hpp>

#include <meniscus/data/text/errors.hpp>
#include <meniscus/labeler/monte_carlo/coverage.hpp>

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace meniscus {
namespace {

/// A cube of side `count` particles, spacing 1; in two dimensions a square.
Snapshot lattice(int count, int dimension) {
    Snapshot snapshot;
    snapshot.dimension = dimension;
    for (int x = 0; x < count; ++x)
        for (int y = 0; y < count; ++y)
            for (int z = 0; z < (dimension == 2 ? 1 : count); ++z)
                snapshot.positions.push_back({0.3 + x, 0.7 + y, static_cast<double>(z)});
    return snapshot;
}

bool on_the_hull(const std::array<double, 3>& position, int count, int dimension) {
    for (int axis = 0; axis < dimension; ++axis) {
        const double place = std::floor(position[axis]);
        if (place == 0 || place == count - 1)
            return true;
    }
    return false;
}

TEST(Labeler, SurfaceOfALatticeIsItsOuterLayer) {
    for (const int dimension : {2, 3})
        for (const char* scheme : {"halton", "random", "table", "blue-noise", "halton-3-5"}) {
            const auto snapshot = lattice(7, dimension);
            LabelOptions options;
            options.method = LabelMethod::monte_carlo;
            options.samples = 2000;
            options.scheme = scheme;
            const auto labels = label_particles(snapshot, 2.0, options);
            for (std::size_t i = 0; i < snapshot.size(); ++i)
                EXPECT_EQ(labels.surface[i] != 0, on_the_hull(snapshot.positions[i], 7, dimension))
                    << scheme << " particle " << i;
        }
}

TEST(Labeler, CountsOfALatticeDoNotDependOnRounding) {
    // With h at exactly two spacings the six neighbors at h stay out: 6 + 12 + 8 count.
    auto snapshot = lattice(7, 3);
    for (auto& position : snapshot.positions)
        for (double& coordinate : position)
            coordinate = static_cast<float>(coordinate * 0.04);
    const auto labels = label_particles(snapshot, 0.08, LabelOptions{});
    EXPECT_EQ(labels.neighbor_count[3 * 49 + 3 * 7 + 3], 26);
    EXPECT_NEAR(labels.mass_offset[3 * 49 + 3 * 7 + 3], 0, 1e-6);
}

TEST(Labeler, LambdaIsThatOfTheReference) {
    const auto snapshot = lattice(5, 3);
    LabelOptions options;
    options.method = LabelMethod::monte_carlo;
    options.samples = 5000;
    const auto labels = label_particles(snapshot, 2.3, options);
    std::vector<Direction> directions(options.samples);
    sampling_scheme("halton").fill(3, 0, 0, directions);
    for (std::size_t i = 0; i < snapshot.size(); ++i) {
        std::vector<Direction> neighbors;
        for (const auto& other : snapshot.positions) {
            const Direction x{(other[0] - snapshot.positions[i][0]) / 2.3,
                              (other[1] - snapshot.positions[i][1]) / 2.3,
                              (other[2] - snapshot.positions[i][2]) / 2.3};
            const double length = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
            if (length > 0.2 && length < 1)
                neighbors.push_back(x);
        }
        EXPECT_DOUBLE_EQ(
            labels.uncovered_fraction[i] * 5000,
            static_cast<double>(count_uncovered_reference(directions, neighbors, 0.8)));
        EXPECT_EQ(labels.neighbor_count[i], neighbors.size());
    }
}

TEST(Labeler, ParticlesInOnePlaceAreAllSurface) {
    Snapshot snapshot;
    snapshot.positions.assign(300, {1, 1, 1});
    LabelOptions options;
    options.method = LabelMethod::monte_carlo;
    options.samples = 100;
    const auto labels = label_particles(snapshot, 0.5, options);
    for (std::size_t i = 0; i < snapshot.size(); ++i) {
        EXPECT_EQ(labels.uncovered_fraction[i], 1);
        EXPECT_EQ(labels.neighbor_count[i], 0);
    }
}

TEST(Labeler, SameLabelsOnAnyNumberOfThreads) {
    const auto snapshot = lattice(9, 3);
    LabelOptions options;
    options.method = LabelMethod::monte_carlo;
    options.samples = 500;
    options.scheme = "random";
    options.threads = 1;
    const auto one = label_particles(snapshot, 2.5, options);
    for (const int threads : {2, 8}) {
        options.threads = threads;
        EXPECT_EQ(label_particles(snapshot, 2.5, options).uncovered_fraction,
                  one.uncovered_fraction);
    }
}

TEST(Labeler, RandomDirectionsFollowTheParticlesId) {
    auto snapshot = lattice(4, 3);
    std::vector<std::int32_t> ids(snapshot.size());
    for (std::size_t i = 0; i < ids.size(); ++i)
        ids[i] = static_cast<std::int32_t>(1000 + i);
    set_array(snapshot, {"id", 1, ids});
    LabelOptions options;
    options.method = LabelMethod::monte_carlo;
    options.samples = 300;
    options.scheme = "random";
    const auto labels = label_particles(snapshot, 2.5, options);
    std::reverse(snapshot.positions.begin(), snapshot.positions.end());
    std::reverse(ids.begin(), ids.end());
    set_array(snapshot, {"id", 1, ids});
    auto reversed = label_particles(snapshot, 2.5, options).uncovered_fraction;
    std::reverse(reversed.begin(), reversed.end());
    EXPECT_EQ(reversed, labels.uncovered_fraction);
}

TEST(Labeler, PhasesDoNotCoverEachOther) {
    auto snapshot = lattice(6, 3);
    std::vector<std::uint8_t> phase(snapshot.size());
    for (std::size_t i = 0; i < phase.size(); ++i)
        phase[i] = snapshot.positions[i][0] < 3 ? 0 : 1;
    set_array(snapshot, {"phase", 1, phase});
    LabelOptions options;
    options.method = LabelMethod::monte_carlo;
    options.samples = 500;
    const auto labels = label_particles(snapshot, 2.0, options);
    for (std::size_t i = 0; i < snapshot.size(); ++i) {
        const double x = std::floor(snapshot.positions[i][0]);
        if (x == 2 || x == 3) {
            EXPECT_EQ(labels.surface[i], 1);
        }
    }
}

TEST(Labeler, MassesWeightTheOffset) {
    Snapshot snapshot;
    snapshot.positions = {{0, 0, 0}, {0.5, 0, 0}, {-0.5, 0, 0}};
    set_array(snapshot, {"mass", 1, std::vector<float>{1, 3, 1}});
    const auto labels = label_particles(snapshot, 1.0, LabelOptions{});
    EXPECT_DOUBLE_EQ(labels.mass_offset[0], 0.25);
    set_array(snapshot, {"mass", 1, std::vector<float>{1, 0, 1}});
    EXPECT_THROW(label_particles(snapshot, 1.0, LabelOptions{}), InputError);
}

TEST(Labeler, SameLabelsInAnyUnitOfLength) {
    LabelOptions options;
    options.method = LabelMethod::monte_carlo;
    options.samples = 1000;
    const Labels labels = label_particles(lattice(5, 3), 2.0, options);
    for (const double unit : {0x1p-30, 0x1p30}) { // about 1e-9 and 1e9, exact
        auto snapshot = lattice(5, 3);
        for (auto& position : snapshot.positions)
            for (double& coordinate : position)
                coordinate *= unit;
        const Labels scaled = label_particles(snapshot, 2.0 * unit, options);
        EXPECT_EQ(scaled.uncovered_fraction, labels.uncovered_fraction);
        EXPECT_EQ(scaled.mass_offset, labels.mass_offset);
        EXPECT_EQ(scaled.neighbor_count, labels.neighbor_count);
    }
}

TEST(Labeler, SaysHowManyPositionsAreNotFiniteAndWhichFirst) {
    auto snapshot = lattice(4, 3);
    snapshot.positions[7][1] = std::nan("");
    snapshot.positions[12][0] = std::numeric_limits<double>::infinity();
    LabelOptions options;
    options.method = LabelMethod::monte_carlo;
    options.samples = 100;
    EXPECT_EQ(error_of<InputError>([&] { label_particles(snapshot, 2.0, options); }),
              "2 of 64 particles have positions that are not finite, the first is particle 7; "
              "--skip-invalid leaves them out");
    options.skip_invalid = true;
    const auto labels = label_particles(snapshot, 2.0, options);
    EXPECT_EQ(labels.valid[7], 0);
    EXPECT_EQ(labels.surface[7], 0);
    EXPECT_EQ(labels.valid[8], 1);
}

TEST(Labeler, RefusesOptionsOutOfRange) {
    const auto snapshot = lattice(3, 3);
    LabelOptions options;
    options.method = LabelMethod::monte_carlo;
    options.samples = 0;
    EXPECT_THROW(label_particles(snapshot, 2.0, options), InputError);
    for (const double ratio : {0.0, 1.0, -0.5, std::nan("")}) {
        options = {};
        options.radius_ratio = ratio;
        EXPECT_THROW(label_particles(snapshot, 2.0, options), InputError) << ratio;
    }
    EXPECT_THROW(label_particles(snapshot, -1.0, LabelOptions{}), InputError);
}

TEST(Labeler, ReportsProgressUpToTheEnd) {
    const auto snapshot = lattice(12, 3);
    LabelOptions options;
    options.method = LabelMethod::monte_carlo;
    options.samples = 100;
    options.threads = 1;
    std::size_t last = 0;
    options.progress = [&](std::size_t done) {
        EXPECT_GT(done, last);
        last = done;
    };
    label_particles(snapshot, 2.0, options);
    EXPECT_EQ(last, snapshot.size());
}

TEST(Labeler, AddsArraysAndProvenance) {
    auto snapshot = lattice(4, 3);
    LabelOptions options;
    options.method = LabelMethod::monte_carlo;
    const auto labels = label_particles(snapshot, 2.0, options);
    add_labels(snapshot, labels, 2.0, options);
    for (const char* name :
         {"uncovered_fraction", "surface", "valid", "mass_offset", "neighbor_count"})
        EXPECT_NE(find_array(snapshot, name), nullptr) << name;
    EXPECT_EQ(snapshot.provenance.at("method"), "monte-carlo");
    EXPECT_EQ(snapshot.provenance.at("samples"), "100000");
    EXPECT_EQ(snapshot.provenance.at("boundary_weight"), "0.85"); // though there is none
    EXPECT_NEAR(*snapshot.particle_volume, 1.18, 0.01);           // of so few, by what is inside
    EXPECT_EQ(snapshot.provenance.at("particle_volume"), "measured");
    options.boundary_weight = 0;
    set_label_provenance(snapshot, 2.0, options);
    EXPECT_EQ(snapshot.provenance.at("boundary_weight"), "0.0");
    options.boundary_weight = -1;
    EXPECT_THROW(label_particles(snapshot, 2.0, options), InputError);
    // Labelled again, it says nothing of what is no longer so.
    set_label_provenance(snapshot, 2.0, LabelOptions{});
    EXPECT_EQ(snapshot.provenance.at("method"), "exact");
    EXPECT_EQ(snapshot.provenance.count("samples"), 0U);
    EXPECT_EQ(snapshot.provenance.count("scheme"), 0U);
    EXPECT_EQ(*snapshot.support_radius, 2.0);
}

} // namespace
} // namespace meniscus
