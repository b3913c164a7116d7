#include "expected_errors.hpp"

#include <meniscus/data/particles/particle_arrays.hpp>
#include <meniscus/data/text/errors.hpp>

#include <gtest/gtest.h>

#include <limits>

namespace meniscus {
namespace {

using Flags = std::vector<std::uint8_t>;
using Integers = std::vector<std::int64_t>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

const Flags all_valid{1, 1, 1};

/// Three particles, with values as the array of that name.
Snapshot three_particles(const std::string& name, ArrayValues values) {
    Snapshot snapshot;
    snapshot.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    set_array(snapshot, {name, 1, std::move(values)});
    return snapshot;
}

TEST(ParticleArrays, PositionsThatAreNotFiniteAreCountedOrLeftOut) {
    Snapshot snapshot;
    snapshot.positions = {{0, 0, 0}, {nan, 0, 0}, {0, infinity, 0}};
    EXPECT_EQ(checked_positions(snapshot, 1, true), (Flags{1, 0, 0}));
    expect_mentions(error_of<InputError>([&] { checked_positions(snapshot, 1, false); }),
                    {"2 of 3 particles", "the first is particle 1", "--skip-invalid"});
    snapshot.positions = {{0, 0, 0}};
    EXPECT_EQ(checked_positions(snapshot, 1, false), Flags{1});
}

/// At 2^18 radii a float coordinate moves in steps of 1/32 of a radius.
TEST(ParticleArrays, PositionsTooFarOutForTheirTypeAreRefused) {
    Snapshot snapshot;
    snapshot.positions = {{0, 0, 0}, {0, -0x1.1p18, 0}, {0, 0x1.ffp17, 0}};
    EXPECT_EQ(checked_positions(snapshot, 1, false), all_valid);
    EXPECT_EQ(doubtful_positions(snapshot, 1, all_valid), "");
    snapshot.position_precision = Precision::float32;
    EXPECT_EQ(checked_positions(snapshot, 1, true), (Flags{1, 0, 1}));
    EXPECT_EQ(checked_positions(snapshot, 2, false), all_valid);
    expect_mentions(
        error_of<InputError>([&] { checked_positions(snapshot, 1, false); }),
        {"1 of 3 particles", "single precision", "the first is particle 1", "--skip-invalid"});
    expect_mentions(doubtful_positions(snapshot, 2, all_valid),
                    {"particle 1", "single precision", "doubtful"});
    EXPECT_EQ(doubtful_positions(snapshot, 1, {1, 0, 0}), "");
    // The smallest radius of all is no radius at all, which is for others to say.
    EXPECT_EQ(checked_positions(snapshot, 0, false), all_valid);
}

TEST(ParticleArrays, MassesArePositiveOrAbsent) {
    EXPECT_TRUE(checked_masses(three_particles("density", Integers{1, 2, 3}), all_valid).empty());
    EXPECT_EQ(checked_masses(three_particles("mass", std::vector<float>{0.5F, 2, 1}), all_valid),
              (std::vector<double>{0.5, 2, 1}));
    for (const double mass : {0.0, -1e-300, nan, infinity}) {
        const Snapshot snapshot = three_particles("mass", std::vector<double>{1, 1, mass});
        expect_mentions(error_of<InputError>([&] { checked_masses(snapshot, all_valid); }),
                        {"particle 2 has mass", "positive"});
        EXPECT_EQ(checked_masses(snapshot, {1, 1, 0}).size(), 3U);
    }
}

TEST(ParticleArrays, SupportRadiiAreOneForAllWhereTheyCanBe) {
    Snapshot snapshot = three_particles("support_radius", std::vector<float>{0.5F, 0.5F, 0.25F});
    const SupportRadii varying = support_radii(snapshot);
    EXPECT_TRUE(varying.vary());
    EXPECT_EQ(varying.each, (std::vector<double>{0.5, 0.5, 0.25}));
    EXPECT_EQ(varying.min, 0.25);
    EXPECT_EQ(varying.max, 0.5);
    snapshot.positions[2][1] = nan; // whose radius does not matter
    EXPECT_FALSE(support_radii(snapshot).vary());
    EXPECT_EQ(support_radii(snapshot).max, 0.5);
    snapshot.support_radius = 0.125; // stored for all
    EXPECT_EQ(support_radii(snapshot).max, 0.125);
    for (const double bad : {nan, -1.0}) // told apart from the others, for the search to refuse
        EXPECT_TRUE(
            support_radii(three_particles("support_radius", std::vector<double>{0.5, bad, 0.5}))
                .vary());
    expect_mentions(error_of<InputError>([] { support_radii(Snapshot{}); }),
                    {"no support radius", "--support-radius"});
}

TEST(ParticleArrays, IntegersKeepAllTheirDigits) {
    constexpr std::int64_t large = (std::int64_t{1} << 62) + 1; // double would round it
    EXPECT_EQ(integer_values(three_particles("id", Integers{large, -large, 0}), "id", all_valid),
              (Integers{large, -large, 0}));
    EXPECT_EQ(integer_values(three_particles("id", std::vector<std::uint8_t>{255, 1, 0}), "id",
                             all_valid),
              (Integers{255, 1, 0}));
    const std::vector<std::uint64_t> hashes{~std::uint64_t{0}, ~std::uint64_t{1}, 7};
    EXPECT_EQ(integer_values(three_particles("id", hashes), "id", all_valid),
              (Integers{-1, -2, 7}));
    EXPECT_TRUE(integer_values(three_particles("id", hashes), "phase", all_valid).empty());
}

TEST(ParticleArrays, FloatingPointIntegersMustBeWhole) {
    EXPECT_EQ(
        integer_values(three_particles("phase", std::vector<float>{-1, 0, 3}), "phase", all_valid),
        (Integers{-1, 0, 3}));
    for (const double value : {0.5, 0x1p63, nan, -infinity}) {
        const Snapshot snapshot = three_particles("phase", std::vector<double>{1, value, 2});
        expect_mentions(error_of<InputError>([&] { integer_values(snapshot, "phase", all_valid); }),
                        {"particle 1 has phase", "whole number"});
        EXPECT_EQ(integer_values(snapshot, "phase", {1, 0, 1}), (Integers{1, 0, 2}));
    }
}

TEST(ParticleArrays, NeedsOneValueAParticle) {
    Snapshot snapshot;
    snapshot.positions = {{0, 0, 0}};
    for (const char* name : {"mass", "id"})
        set_array(snapshot, {name, 2, Integers{1, 2}});
    EXPECT_THROW(checked_masses(snapshot, {1}), InputError);
    EXPECT_THROW(integer_values(snapshot, "id", {1}), InputError);
}

} // namespace
} // namespace meniscus
