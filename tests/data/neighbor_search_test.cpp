#include <meniscus/data/neighbor_search.hpp>

#include "expected_errors.hpp"

#include <meniscus/data/errors.hpp>
#include <meniscus/data/text.hpp>

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
std::vector<std::vector<std::uint32_t>> all_pairs(const Positions& positions, double radius,
                                                  const NeighborFilter& filter) {
    std::vector<std::vector<std::uint32_t>> lists(positions.size());
    const auto valid = [&](std::size_t i) { return !filter.valid || (*filter.valid)[i] != 0; };
    for (std::uint32_t i = 0; i < positions.size(); ++i)
        for (std::uint32_t j = 0; j < positions.size(); ++j) {
            double square = 0;
            for (int axis = 0; axis < 3; ++axis)
                square += std::pow(positions[j][axis] - positions[i][axis], 2);
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

void expect_same_as_all_pairs(const Positions& positions, double radius,
                              const NeighborFilter& filter = {}) {
    EXPECT_EQ(sorted_lists(find_neighbors(positions, radius, filter)),
              all_pairs(positions, radius, filter));
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

} // namespace
} // namespace meniscus
