#include <meniscus/data/particles/neighbor_search.hpp>

#include "expected_errors.hpp"

#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace meniscus {
namespace {

Positions random_positions(std::size_t count, double extent, int dimension, unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> coordinate(0, extent);
    Positions positions(count);
    for (auto& position : positions)
        for (int axis = 0; axis < dimension; ++axis)
            position[axis] = coordinate(generator);
    return positions;
}

/// The lists by comparing all pairs.
std::vector<std::vector<std::uint32_t>>
all_pairs(const Positions& positions, const SupportRadii& radii, const NeighborFilter& filter) {
    std::vector<std::vector<std::uint32_t>> lists(positions.size());
    const auto valid = [&](std::size_t i) { return !filter.valid || (*filter.valid)[i] != 0; };
    for (std::uint32_t i = 0; i < positions.size(); ++i)
        for (std::uint32_t j = 0; j < positions.size(); ++j) {
            double square = 0;
            for (int axis = 0; axis < 3; ++axis)
                square += std::pow(positions[j][axis] - positions[i][axis], 2);
            const double radius = (radii.of(i) + radii.of(j)) / 2;
            if (i != j && valid(i) && valid(j) && square < radius * radius &&
                (!filter.phase || (*filter.phase)[i] == (*filter.phase)[j]))
                lists[i].push_back(j);
        }
    return lists;
}

std::vector<std::vector<std::uint32_t>> sorted_lists(const NeighborLists& lists) {
    std::vector<std::vector<std::uint32_t>> sorted;
    for (std::size_t i = 0; i + 1 < lists.offsets.size(); ++i) {
        sorted.emplace_back(lists.neighbors.begin() + static_cast<long>(lists.offsets[i]),
                            lists.neighbors.begin() + static_cast<long>(lists.offsets[i + 1]));
        std::sort(sorted.back().begin(), sorted.back().end());
    }
    return sorted;
}

void expect_same_as_all_pairs(const Positions& positions, const SupportRadii& radii,
                              const NeighborFilter& filter = {}) {
    EXPECT_EQ(sorted_lists(find_neighbors(positions, radii, filter, 1)),
              all_pairs(positions, radii, filter));
}

/// From `smallest` to `range` times that, as many in each factor of two.
std::vector<double> random_radii(std::size_t count, double min, double range, unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> power(0, std::log(range));
    std::vector<double> radii(count);
    for (double& radius : radii)
        radius = min * std::exp(power(generator));
    return radii;
}

TEST(NeighborSearch, FindsThePairsThatComparingAllFinds) {
    for (unsigned seed = 0; seed < 20; ++seed)
        for (const int dimension : {2, 3})
            for (const double radius : {0.05, 0.3, 2.0})
                expect_same_as_all_pairs(random_positions(300, 1, dimension, seed), radius);
}

TEST(NeighborSearch, FindsThemWhereCellsShareBuckets) {
    // Scattered so thinly that the direct table would be far too large.
    auto positions = random_positions(300, 1e5, 3, 1);
    for (std::size_t i = 0; i < 150; ++i) {
        positions[i + 150] = positions[i];
        positions[i + 150][0] += 0.5;
    }
    expect_same_as_all_pairs(positions, 1.0);
}

TEST(NeighborSearch, TwoDropletsAMillionRadiiApart) {
    auto positions = random_positions(400, 3, 3, 7);
    for (std::size_t i = 200; i < 400; ++i)
        for (double& coordinate : positions[i])
            coordinate += 1e6;
    expect_same_as_all_pairs(positions, 1.0);
}

TEST(NeighborSearch, LatticeAtExactlyTheRadius) {
    Positions positions;
    for (int x = 0; x < 6; ++x)
        for (int y = 0; y < 6; ++y)
            for (int z = 0; z < 6; ++z)
                positions.push_back({0.25 * x - 3, 0.25 * y + 8, 0.25 * z});
    expect_same_as_all_pairs(positions, 0.5); // strictly below: exact in binary
    expect_same_as_all_pairs(positions, std::nextafter(0.5, 1.0));
}

TEST(NeighborSearch, CoincidentParticlesAreNeighbors) {
    const Positions positions(50, {1, 2, 3});
    const auto lists = find_neighbors(positions, 0.1);
    EXPECT_EQ(lists.neighbors.size(), 50U * 49U);
}

TEST(NeighborSearch, KeepsPhasesAndInvalidParticlesApart) {
    auto positions = random_positions(200, 1, 3, 3);
    std::vector<std::uint8_t> valid(200, 1);
    std::vector<std::int64_t> phase(200);
    for (std::size_t i = 0; i < 200; ++i)
        phase[i] = static_cast<std::int64_t>(i % 3);
    valid[17] = 0;
    positions[17][1] = std::numeric_limits<double>::quiet_NaN();
    expect_same_as_all_pairs(positions, 0.4, {&valid, &phase});
}

TEST(NeighborSearch, SameListsOnAnyNumberOfThreads) {
    const auto positions = random_positions(5000, 1, 3, 5);
    const auto one = find_neighbors(positions, 0.1, {}, 1);
    for (const int threads : {2, 8}) {
        const auto many = find_neighbors(positions, 0.1, {}, threads);
        EXPECT_EQ(one.offsets, many.offsets);
        EXPECT_EQ(one.neighbors, many.neighbors);
    }
}

TEST(NeighborSearch, NoneAndOneParticle) {
    EXPECT_EQ(find_neighbors({}, 1).offsets, std::vector<std::size_t>{0});
    EXPECT_TRUE(find_neighbors({{0, 0, 0}}, 1).neighbors.empty());
}

TEST(NeighborSearch, AnyUnitOfLength) {
    const auto lists = find_neighbors(random_positions(300, 1, 3, 11), 0.3);
    for (const double unit : {0x1p-495, 0x1p-30, 0x1p30, 0x1p495}) { // about 1e-149, 1e-9, ...
        auto positions = random_positions(300, 1, 3, 11);
        for (auto& position : positions)
            for (double& coordinate : position)
                coordinate *= unit; // exact, as a power of two
        const auto scaled = find_neighbors(positions, 0.3 * unit);
        EXPECT_EQ(sorted_lists(scaled), sorted_lists(lists)) << unit;
    }
    for (const double radius : {1e-9, 1e9})
        expect_same_as_all_pairs(random_positions(300, 3 * radius, 3, 11), radius);
}

TEST(NeighborSearch, RefusesRadiiWithoutASquare) {
    for (const double radius : {1e-300, 1e-151, 1e151, 1e300})
        expect_mentions(error_of<InputError>([&] {
                            find_neighbors({{0, 0, 0}}, radius);
                        }),
                        {number_text(radius).c_str(), "1e-150", "1e+150"});
}

TEST(NeighborSearch, RefusesWhatCannotBeSearched) {
    const Positions positions{{0, 0, 0}, {1, 0, 0}};
    for (const double radius : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
        EXPECT_THROW(find_neighbors(positions, radius), InputError) << radius;
    EXPECT_THROW(find_neighbors({{0, 0, 0}, {std::nan(""), 0, 0}}, 1), InputError);
    EXPECT_THROW(find_neighbors({{0, 0, 0}, {1e300, 0, 0}}, 1), InputError);
}

TEST(NeighborSearch, VaryingRadiiFindThePairsThatComparingAllFinds) {
    for (unsigned seed = 0; seed < 10; ++seed)
        for (const int dimension : {2, 3})
            for (const double range : {1.5, 4.0, 100.0, 999.0})
                expect_same_as_all_pairs(
                    random_positions(300, 1, dimension, seed),
                    SupportRadii(random_radii(300, 0.5 / range, range, seed + 1)));
}

TEST(NeighborSearch, VaryingRadiiWhereCellsShareBuckets) {
    // Pairs of every kind, at a distance about the mean of their radii, scattered thinly.
    for (unsigned seed = 0; seed < 20; ++seed) {
        auto positions = random_positions(400, 1e4, 3, seed);
        const auto radii = random_radii(400, 1, 200, seed);
        for (std::size_t i = 0; i < 200; ++i) {
            positions[i + 200] = positions[i];
            positions[i + 200][i % 3] +=
                (radii[i] + radii[i + 200]) / 2 * (i % 2 == 0 ? 0.99 : 1.01);
        }
        expect_same_as_all_pairs(positions, SupportRadii(radii));
    }
}

TEST(NeighborSearch, VaryingRadiiKeepPhasesAndInvalidParticlesApart) {
    auto positions = random_positions(200, 1, 3, 3);
    auto radii = random_radii(200, 0.1, 20, 3);
    std::vector<std::uint8_t> valid(200, 1);
    std::vector<std::int64_t> phase(200);
    for (std::size_t i = 0; i < 200; ++i)
        phase[i] = static_cast<std::int64_t>(i % 3);
    valid[17] = 0; // so that its radius does not matter
    radii[17] = std::nan("");
    expect_same_as_all_pairs(positions, SupportRadii(radii, valid), {&valid, &phase});
    valid.assign(200, 0);
    EXPECT_TRUE(find_neighbors(positions, SupportRadii(radii), {&valid}).neighbors.empty());
}

TEST(NeighborSearch, VaryingRadiiGiveTheSameListsOnAnyNumberOfThreads) {
    const auto positions = random_positions(5000, 1, 3, 5);
    const SupportRadii radii(random_radii(5000, 0.02, 10, 5));
    const auto one = find_neighbors(positions, radii, {}, 1);
    const auto many = find_neighbors(positions, radii, {}, 8);
    EXPECT_EQ(one.offsets, many.offsets);
    EXPECT_EQ(one.neighbors, many.neighbors);
}

TEST(NeighborSearch, EqualRadiiAreOneForAll) {
    const SupportRadii radii(std::vector<double>(400, 0.1));
    EXPECT_FALSE(radii.vary());
    EXPECT_EQ(radii.of(7), 0.1);
    // In lists of varying radii, particles of equal radius find each other in the same order.
    auto positions = random_positions(400, 1, 3, 2);
    const auto lists = find_neighbors(positions, radii);
    std::vector<double> each(400, 0.1);
    positions.push_back({100, 100, 100});
    each.push_back(1);
    const auto varying = find_neighbors(positions, SupportRadii(each));
    EXPECT_EQ(varying.neighbors, lists.neighbors);
}

TEST(NeighborSearch, FindsAroundAPlaceAtAnyDistance) {
    const auto positions = random_positions(500, 1, 3, 4);
    const NeighborGrid grid(positions, 0.1);
    FoundNeighbors found;
    for (const double radius : {0.03, 0.1, 0.25, 0.9, 100.0})
        for (const std::array<double, 3>& center : random_positions(20, 1.2, 3, 5)) {
            grid.find_around(center, radius, found);
            std::vector<std::uint32_t> expected;
            for (std::uint32_t i = 0; i < positions.size(); ++i)
                if (std::hypot(positions[i][0] - center[0], positions[i][1] - center[1],
                               positions[i][2] - center[2]) < radius)
                    expected.push_back(i);
            std::sort(found.particles.begin(), found.particles.end());
            ASSERT_EQ(found.particles, expected) << radius;
        }
}

TEST(NeighborSearch, RefusesRadiiThatCannotBeUsedAndNamesTheParticle) {
    const Positions positions{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    const auto refusal = [&](std::vector<double> radii) {
        return error_of<InputError>([&] { find_neighbors(positions, SupportRadii(radii)); });
    };
    for (const double radius : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
        expect_mentions(refusal({1, radius, 2}),
                        {"support radius of particle 1", "positive", number_text(radius).c_str()});
    expect_mentions(refusal({1, 2, 1e-151}), {"support radius of particle 2", "1e-150"});
    expect_mentions(refusal({1, 2}), {"each of 3 particles", "found 2"});
    expect_mentions(refusal({0.5, 1, 501}),
                    {"0.5 m (particle 0)", "501 m (particle 2)", "factor of 1000"});
    EXPECT_EQ(find_neighbors(positions, SupportRadii({0.5, 1, 500})).neighbors.size(), 4U);
}

TEST(NeighborSearch, RefusesRadiiThatReachOverEverything) {
    const std::size_t count = 200000;
    const auto positions = random_positions(count, 1, 3, 6);
    auto radii = random_radii(count, 0.01, 2, 6);
    EXPECT_NO_THROW(NeighborGrid(positions, SupportRadii(radii)));
    for (double& radius : radii)
        radius *= 300;
    expect_mentions(error_of<InputError>([&] { NeighborGrid(positions, SupportRadii(radii)); }),
                    {"reach over 200000 particles", "--support-radius"});
    radii = random_radii(count, 0.01, 2, 6);
    radii[5] = 5; // one alone does no harm
    EXPECT_NO_THROW(NeighborGrid(positions, SupportRadii(radii)));
}

TEST(NeighborSearch, RefusesListsOfNearlyAllPairs) {
    const Positions some = random_positions(2 * max_listed_neighbors, 1, 3, 5);
    expect_mentions(error_of<InputError>([&] { find_neighbors(some, 10); }),
                    {"support radius of 10 m", "3999 neighbors a particle", "at most 2000"});
    const Positions many = random_positions(40000, 1, 3, 6); // told by a sample
    expect_mentions(error_of<InputError>([&] { find_neighbors(many, 10); }),
                    {"39999 neighbors a particle"});
    // A crowd in one place has few in its lists, and few particles have few neighbors.
    EXPECT_EQ(find_neighbors(some, 10, {nullptr, nullptr, 7}).neighbors.size(), 7 * some.size());
    EXPECT_EQ(find_neighbors(random_positions(1000, 1, 3, 7), 10).neighbors.size(), 999000U);
}

} // namespace
} // namespace meniscus
