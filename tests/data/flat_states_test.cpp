// States of two dimensions in any plane, told by what they are and not by their format.
#include <meniscus/data/particles/flat_states.hpp>

#include "expected_errors.hpp"
#include <meniscus/data/text/errors.hpp>

#include <gtest/gtest.h>

namespace meniscus {
namespace {

/// A square of particles in the plane of two axes, at 0.5 along the third.
Snapshot square(std::size_t first, std::size_t second) {
    Snapshot snapshot;
    std::vector<double> velocity;
    for (int i = 0; i < 9; ++i) {
        std::array<double, 3> position{0.5, 0.5, 0.5};
        position[first] = i % 3;
        position[second] = 10 + i / 3;
        snapshot.positions.push_back(position);
        std::array<double, 3> v{};
        v[first] = 1;
        v[second] = 2;
        velocity.insert(velocity.end(), v.begin(), v.end());
    }
    snapshot.point_data.push_back({"velocity", 3, velocity});
    return snapshot;
}

TEST(FlatStates, EveryPlaneOfTheAxesBecomesXy) {
    const std::pair<std::size_t, std::size_t> planes[] = {{0, 1}, {0, 2}, {1, 2}};
    for (const auto& [first, second] : planes) {
        Snapshot snapshot = square(first, second);
        snapshot.boundary = {snapshot.positions[8]};
        settle_plane(snapshot);
        EXPECT_EQ(snapshot.dimension, 2);
        EXPECT_EQ(snapshot.positions[5], (std::array<double, 3>{2, 11, 0.5}));
        EXPECT_EQ(snapshot.boundary[0], snapshot.positions[8]);
        const auto velocity = as_doubles(snapshot.point_data[0]);
        EXPECT_EQ(std::vector<double>(velocity.begin(), velocity.begin() + 3),
                  (std::vector<double>{1, 2, 0}));
        EXPECT_EQ(snapshot.notes.empty(), second == 1);
        EXPECT_EQ(snapshot.provenance.count("plane"), second == 1 ? 0U : 1U);
    }
}

TEST(FlatStates, RoundingIsNoThickness) {
    Snapshot snapshot = square(0, 1);
    snapshot.positions[4][2] += 1e-16;
    snapshot.positions[7][2] -= 1e-9;
    settle_plane(snapshot);
    EXPECT_EQ(snapshot.dimension, 2);
    for (const auto& position : snapshot.positions)
        EXPECT_EQ(position[2], 0.5);
    ASSERT_EQ(snapshot.notes.size(), 1U);

    Snapshot thick = square(0, 1);
    thick.positions[4][2] += 1e-4;
    settle_plane(thick);
    EXPECT_EQ(thick.dimension, 3);
}

TEST(FlatStates, LinesAndSingleParticlesHaveNoOtherPlane) {
    for (const Positions& positions :
         {Positions{{1, 2, 3}}, Positions{{0, 0, 0}, {0, 0, 1}, {0, 0, 2}},
          Positions{{0, 7, 0}, {1, 7, 1}, {2, 7, 2}}, Positions{}}) {
        Snapshot snapshot;
        snapshot.positions = positions;
        settle_plane(snapshot);
        EXPECT_EQ(snapshot.dimension, 3);
        EXPECT_EQ(snapshot.positions, positions);
    }
}

TEST(FlatStates, WhatIsSaidToBeFlatMustBe) {
    Snapshot snapshot = square(0, 2);
    demand_plane(snapshot);
    EXPECT_EQ(snapshot.dimension, 2);
    EXPECT_EQ(snapshot.provenance.at("plane"), "xz");
    Snapshot thick = square(0, 1);
    thick.positions[4][2] = 1;
    expect_mentions(error_of<InputError>([&] { demand_plane(thick); }),
                    {"particle 4", "z = 1", "--dimension 2"});
}

TEST(FlatStates, ABoundaryOfItsOwnFileIsTurnedAlike) {
    Snapshot snapshot = square(0, 2);
    settle_plane(snapshot);
    Positions boundary = {{0, 0.5, 9}, {1, 0.5, 9}}; // a line, which has no plane of its own
    turn_into_plane(snapshot, boundary);
    EXPECT_EQ(boundary, (Positions{{0, 9, 0.5}, {1, 9, 0.5}}));
}

} // namespace
} // namespace meniscus
