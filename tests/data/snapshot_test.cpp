#include "expected_errors.hpp"

#include <meniscus/data/particles/snapshot.hpp>
#include <meniscus/data/text/errors.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace meniscus {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Snapshot two_particles() {
    Snapshot snapshot;
    snapshot.positions = {{0, 0, 0}, {1, 2, 3}};
    set_array(snapshot, {"density", 1, std::vector<float>{1000, 998.5F}});
    set_array(snapshot, {"velocity", 3, std::vector<double>{1, 2, 3, 4, 5, 6}});
    return snapshot;
}

TEST(Snapshot, FindsArraysByName) {
    const Snapshot snapshot = two_particles();
    ASSERT_NE(find_array(snapshot, "velocity"), nullptr);
    EXPECT_EQ(find_array(snapshot, "velocity")->components, 3);
    EXPECT_EQ(find_array(snapshot, "mass"), nullptr);
}

TEST(Snapshot, ReplacesAnArrayOfTheSameName) {
    Snapshot snapshot = two_particles();
    set_array(snapshot, {"density", 1, std::vector<std::int32_t>{1, 2}});
    EXPECT_EQ(snapshot.point_data.size(), 2U);
    EXPECT_EQ(scalar_values(snapshot, "density"), (std::vector<double>{1, 2}));
}

TEST(Snapshot, RefusesAnArrayOfAnotherLength) {
    Snapshot snapshot = two_particles();
    EXPECT_THROW(set_array(snapshot, {"mass", 1, std::vector<double>{1}}), std::invalid_argument);
    EXPECT_THROW(set_array(snapshot, {"mass", 0, std::vector<double>{}}), std::invalid_argument);
    EXPECT_EQ(find_array(snapshot, "mass"), nullptr);
}

TEST(Snapshot, GivesValuesAsDoubles) {
    const Snapshot snapshot = two_particles();
    EXPECT_EQ(scalar_values(snapshot, "density"), (std::vector<double>{1000, 998.5}));
    EXPECT_EQ(as_doubles(*find_array(snapshot, "velocity")),
              (std::vector<double>{1, 2, 3, 4, 5, 6}));
}

TEST(Snapshot, NamesTheArrayThatIsNoScalar) {
    const Snapshot snapshot = two_particles();
    for (const char* name : {"mass", "velocity"})
        expect_mentions(error_of<InputError>([&] { scalar_values(snapshot, name); }), {name});
}

TEST(Snapshot, FindsNonFinitePositions) {
    Snapshot snapshot;
    snapshot.positions = {{0, 0, 0}, {0, nan, 0}, {0, 0, std::numeric_limits<double>::infinity()}};
    EXPECT_EQ(finite_positions(snapshot), (std::vector<std::uint8_t>{1, 0, 0}));
}

TEST(Snapshot, DimensionComesFromThePositions) {
    EXPECT_EQ(dimension_of({{0, 0, 0}, {1, 0, 0}}), 2);
    EXPECT_EQ(dimension_of({{0, 0, 0.5}, {1, 2, 0.5}}), 2);
    EXPECT_EQ(dimension_of({{0, 0, 0}, {1, 0, 1e-9}}), 3);
}

TEST(Snapshot, DimensionIgnoresNonFinitePositions) {
    EXPECT_EQ(dimension_of({{nan, 0, 7}, {0, 0, 0}, {1, 0, 0}, {0, 0, nan}}), 2);
}

TEST(Snapshot, OneParticleSuggestsNoPlane) {
    EXPECT_EQ(dimension_of({}), 3);
    EXPECT_EQ(dimension_of({{0, 0, 0}}), 3);
    EXPECT_EQ(dimension_of({{0, 0, 0}, {nan, 0, 0}}), 3);
}

TEST(Snapshot, SceneIsTheStoredOneElseTheStem) {
    Snapshot snapshot;
    EXPECT_EQ(scene_of(snapshot, "frames/dam_0014.vtk"), "dam");
    EXPECT_EQ(scene_of(snapshot, "dam_dfsph_04.vtk"), "dam_dfsph");
    EXPECT_EQ(scene_of(snapshot, "dam.0014.vtk"), "dam");
    EXPECT_EQ(scene_of(snapshot, "dam-7.vtkhdf"), "dam");
    EXPECT_EQ(scene_of(snapshot, "dam.vtk"), "dam");
    EXPECT_EQ(scene_of(snapshot, "DoubleDroplet_ZR2020.vtk"), "DoubleDroplet_ZR2020");
    EXPECT_EQ(scene_of(snapshot, "0014.vtk"), "0014");
    EXPECT_EQ(scene_of(snapshot, "_0014.vtk"), "_0014");
    snapshot.scene = "crown";
    EXPECT_EQ(scene_of(snapshot, "dam_0014.vtk"), "crown");
}

} // namespace
} // namespace meniscus
