// Bodies of a fluid with known answers.
#include <meniscus/sph/run/bodies.hpp>

#include <array>
#include <cmath>
#include <gtest/gtest.h>

namespace meniscus {
namespace {

/// Particles at first + (i, j, k).
Positions lattice(const Place& first, const std::array<int, 3>& count) {
    Positions places;
    for (int i = 0; i < count[0]; ++i)
        for (int j = 0; j < count[1]; ++j)
            for (int k = 0; k < count[2]; ++k)
                places.push_back({first[0] + i, first[1] + j, first[2] + k});
    return places;
}

Positions joined(Positions one, const Positions& other) {
    one.insert(one.end(), other.begin(), other.end());
    return one;
}

TEST(Bodies, NoneWithoutParticles) {
    const Bodies bodies = find_bodies({}, 2, 3);
    EXPECT_EQ(bodies.count, 0U);
    EXPECT_EQ(bodies.largest, 0U);
}

TEST(Bodies, AreApartFromTheSupportRadiusOn) {
    const Positions pair = {{0, 0, 0}, {1.9, 0, 0}};
    EXPECT_EQ(find_bodies(pair, 2, 3).count, 1U);
    EXPECT_EQ(find_bodies(pair, 1.8, 3).count, 2U);
}

TEST(Bodies, DropletsThatCameLooseAreCounted) {
    const Positions drop = lattice({0, 0, 0}, {4, 3, 5});
    const Positions all = joined(joined(lattice({20, 0, 0}, {2, 2, 2}), drop),
                                 joined({{-30, 7, 0}}, lattice({0, 40, 0}, {1, 1, 3})));
    const Bodies bodies = find_bodies(all, 1.5, 3);
    EXPECT_EQ(bodies.count, 4U);
    EXPECT_EQ(bodies.largest, drop.size());
    EXPECT_EQ(bodies.top, 2); // not that of the others
}

TEST(Bodies, AChainIsOne) {
    EXPECT_EQ(find_bodies(lattice({0, 0, 0}, {1000, 1, 1}), 1.5, 3).count, 1U);
}

TEST(Bodies, TheAspectIsThatOfTheMoments) {
    // n particles in a row have the moment n (n^2 - 1) / 12.
    const Bodies box = find_bodies(lattice({5, -2, 1}, {8, 4, 2}), 1.5, 3);
    EXPECT_NEAR(box.aspect, std::sqrt(63.0 / 3), 1e-12);
    EXPECT_NEAR(box.radius, std::hypot(3.5, 1.5, 0.5), 1e-12);
    EXPECT_NEAR(find_bodies(lattice({0, 0, 0}, {5, 5, 5}), 1.5, 3).aspect, 1, 1e-12);
    EXPECT_NEAR(find_bodies(lattice({0, 0, 0}, {6, 3, 1}), 1.5, 2).aspect, std::sqrt(35.0 / 8),
                1e-12);
    EXPECT_EQ(find_bodies(lattice({0, 0, 0}, {9, 1, 1}), 1.5, 3).aspect, 0);
}

} // namespace
} // namespace meniscus
