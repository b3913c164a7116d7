// Components against a plain breadth-first search.
#include <meniscus/runtime/surface/connected_components.hpp>

#include "threaded_loop.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace meniscus {
namespace {

using Labels = std::vector<std::uint32_t>;

/// Particles whose lists hold all particles of the same phase, near or not, and themselves.
template <class Real, int Dimension>
struct Particles {
    std::vector<std::array<Real, Dimension>> positions;
    std::vector<int> phases; ///< empty: one phase
    std::vector<Real> radii; ///< empty: 1 m

    [[nodiscard]] std::size_t size() const { return positions.size(); }

    template <class Visit>
    void operator()(std::size_t i, Visit&& visit) const {
        for (std::size_t j = 0; j < size(); ++j)
            if (phases.empty() || phases[i] == phases[j])
                visit(j, displacement(i, j), Real(1));
    }

    [[nodiscard]] std::array<Real, Dimension> displacement(std::size_t i, std::size_t j) const {
        std::array<Real, Dimension> result;
        for (int axis = 0; axis < Dimension; ++axis)
            result[axis] = positions[j][axis] - positions[i][axis];
        return result;
    }

    [[nodiscard]] bool are_neighbors(std::size_t i, std::size_t j) const {
        const double radius = radii.empty() ? 1 : (double{radii[i]} + double{radii[j]}) / 2;
        double squared = 0;
        for (const Real component : displacement(i, j))
            squared += double{component} * double{component};
        return (phases.empty() || phases[i] == phases[j]) && squared < radius * radius;
    }

    template <class Loop>
    Labels components(const Loop& loop) const {
        Labels labels(size(), 12345);
        ComponentFinder finder;
        if (radii.empty())
            finder.find<Real, Dimension>(*this, size(), UniformRadius<Real>{1}, loop,
                                         labels.data());
        else
            finder.find<Real, Dimension>(*this, size(), VaryingRadii<Real>{radii.data()}, loop,
                                         labels.data());
        return labels;
    }

    [[nodiscard]] Labels breadth_first() const {
        constexpr std::uint32_t unseen = std::numeric_limits<std::uint32_t>::max();
        Labels labels(size(), unseen);
        for (std::uint32_t start = 0; start < size(); ++start) {
            if (labels[start] != unseen)
                continue;
            Labels queue{start};
            labels[start] = start;
            for (std::size_t next = 0; next < queue.size(); ++next)
                for (std::uint32_t j = 0; j < size(); ++j)
                    if (labels[j] == unseen && are_neighbors(queue[next], j)) {
                        labels[j] = start;
                        queue.push_back(j);
                    }
        }
        return labels;
    }
};

/// Checks the components of one state over every kind of loop.
template <class State>
void expect_components(const State& state, const Labels& expected) {
    EXPECT_EQ(state.components(SerialLoop{}), expected);
    for (const int threads : {1, 2, 3, 8})
        EXPECT_EQ(state.components(ThreadedLoop{threads}), expected) << threads;
#if defined(_OPENMP)
    for (const int threads : {1, 2, 7})
        EXPECT_EQ(state.components(OpenMpLoop{threads}), expected) << threads;
#endif
}

/// `count` particles, of which `crowding` have their center within one radius of a place.
template <class Real, int Dimension>
Particles<Real, Dimension> random_particles(std::size_t count, double crowding, unsigned seed) {
    std::mt19937 random(seed);
    const double ball = Dimension == 2 ? 3.14 : 4.19;
    const double side = std::pow(static_cast<double>(count) * ball / crowding, 1.0 / Dimension);
    std::uniform_real_distribution<Real> coordinate(0, static_cast<Real>(side));
    Particles<Real, Dimension> state;
    state.positions.resize(count);
    for (auto& position : state.positions)
        for (Real& value : position)
            value = coordinate(random);
    return state;
}

template <class Real, int Dimension>
void compare_random_states() {
    unsigned seed = 0;
    for (const std::size_t count : {2, 7, 8, 9, 40, 400})
        for (const double crowding : {0.5, 1.5, 3.0, 5.0, 30.0}) {
            auto state = random_particles<Real, Dimension>(count, crowding, ++seed);
            expect_components(state, state.breadth_first());
            for (std::size_t i = 0; i < count; ++i) {
                state.phases.push_back(static_cast<int>(i % 2));
                state.radii.push_back(i % 3 == 0 ? Real(1.2) : Real(0.8));
            }
            expect_components(state, state.breadth_first());
        }
}

TEST(ConnectedComponents, RandomStatesDouble3D) {
    compare_random_states<double, 3>();
}
TEST(ConnectedComponents, RandomStatesFloat3D) {
    compare_random_states<float, 3>();
}
TEST(ConnectedComponents, RandomStatesDouble2D) {
    compare_random_states<double, 2>();
}
TEST(ConnectedComponents, RandomStatesFloat2D) {
    compare_random_states<float, 2>();
}

/// A chain of particles that each hang on the one before and after, listed in the order `indices`.
struct Chain {
    Labels indices; ///< the particle at each place of the chain
    Labels places;  ///< and back

    explicit Chain(Labels order) : indices(std::move(order)), places(indices.size()) {
        for (std::uint32_t place = 0; place < indices.size(); ++place)
            places[indices[place]] = place;
    }

    template <class Visit>
    void operator()(std::size_t i, Visit&& visit) const {
        for (const int step : {-1, 1}) {
            const std::size_t place = places[i] + static_cast<std::size_t>(step);
            if (place < indices.size())
                visit(indices[place], std::array<double, 2>{0.9 * step, 0}, 1.0);
        }
    }

    template <class Loop>
    Labels components(const Loop& loop) const {
        Labels labels(indices.size(), 12345);
        ComponentFinder().find<double, 2>(*this, indices.size(), UniformRadius<double>{1}, loop,
                                          labels.data());
        return labels;
    }
};

TEST(ConnectedComponents, ChainsInAnyOrderAreOneBody) {
    constexpr std::uint32_t size = 1U << 13U;
    Labels order(size);
    std::iota(order.begin(), order.end(), 0U);
    expect_components(Chain(order), Labels(size, 0));
    expect_components(Chain({order.rbegin(), order.rend()}), Labels(size, 0));

    Labels from_both_ends(size); // 0, 8191, 1, 8190, ...
    for (std::uint32_t place = 0; place < size; ++place)
        from_both_ends[place] = place % 2 == 0 ? place / 2 : size - 1 - place / 2;
    expect_components(Chain(from_both_ends), Labels(size, 0));

    Labels halved{0}; // 0, 4096, 2048, 6144, ...: bits reversed
    for (std::uint32_t step = size / 2; step > 0; step /= 2)
        for (std::size_t place = 0, known = halved.size(); place < known; ++place)
            halved.push_back(halved[place] + step);
    ASSERT_EQ(halved.size(), size);
    expect_components(Chain(halved), Labels(size, 0));

    std::shuffle(order.begin(), order.end(), std::mt19937(1));
    expect_components(Chain(order), Labels(size, 0));
}

/// A cube of 5 x 5 x 5 particles half a radius apart, its lowest corner at x.
void add_droplet(Particles<double, 3>& state, double x) {
    for (int a = 0; a < 5; ++a)
        for (int b = 0; b < 5; ++b)
            for (int c = 0; c < 5; ++c)
                state.positions.push_back({x + 0.5 * a, 0.5 * b, 0.5 * c});
}

TEST(ConnectedComponents, DropletsUntilOneParticleBridgesThem) {
    Particles<double, 3> state;
    add_droplet(state, 0);
    add_droplet(state, 3.5); // 1.5 radii beyond the first
    Labels expected(125, 0);
    expected.resize(250, 125);
    expect_components(state, expected);

    state.positions.push_back({2.75, 1, 1});
    expect_components(state, Labels(251, 0));

    state.phases.assign(251, 1);
    state.phases.back() = 2;
    expected.push_back(250);
    expect_components(state, expected);
}

TEST(ConnectedComponents, NoneAndOne) {
    expect_components(Particles<float, 3>{}, {});
    expect_components(Particles<float, 3>{{{1, 2, 3}}, {}, {}}, {0});
}

TEST(ConnectedComponents, ParticlesInOnePlaceAreConnected) {
    Particles<float, 2> state;
    state.positions.assign(100, {0.3F, 0.7F});
    state.positions.push_back({5, 5});
    state.positions.push_back({5, 5});
    Labels expected(100, 0);
    expected.resize(102, 100);
    expect_components(state, expected);
}

TEST(ConnectedComponents, AtTheSupportRadiusIsApart) {
    for (const double distance : {1.0, 1 - 0.5 * neighbor_band})
        expect_components(Particles<double, 2>{{{0, 0}, {distance, 0}}, {}, {}}, {0, 1});
    expect_components(Particles<double, 2>{{{0, 0}, {1 - 2 * neighbor_band, 0}}, {}, {}}, {0, 0});
}

TEST(ConnectedComponents, PairsAreMeasuredInTheirMeanRadius) {
    expect_components(Particles<double, 2>{{{0, 0}, {1.9, 0}}, {}, {1, 3}}, {0, 0});
    expect_components(Particles<double, 2>{{{0, 0}, {2.1, 0}}, {}, {1, 3}}, {0, 1});
}

TEST(ConnectedComponents, PositionsThatAreNotFiniteConnectNothing) {
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::quiet_NaN(),
          std::numeric_limits<float>::infinity()})
        expect_components(Particles<float, 2>{{{0, 0}, {bad, 0}, {bad, 0}, {0.5F, 0}}, {}, {}},
                          {0, 1, 2, 0});
}

TEST(ConnectedComponents, GhostsBeyondTheCountAreIgnored) {
    const Particles<double, 2> with_ghost{{{0, 0}, {1.8, 0}, {0.9, 0}}, {}, {}};
    Labels labels(3, 7);
    ComponentFinder().find<double, 2>(with_ghost, 2, UniformRadius<double>{1}, SerialLoop{},
                                      labels.data());
    EXPECT_EQ(labels, (Labels{0, 1, 7}));
}

TEST(ConnectedComponents, OneFinderServesStatesOfAnySize) {
    ComponentFinder finder;
    finder.reserve(10);
    for (const std::size_t count : {40, 400, 3}) {
        const auto state = random_particles<double, 3>(count, 3, 5);
        Labels labels(count);
        finder.find<double, 3>(state, count, UniformRadius<double>{1}, SerialLoop{}, labels.data());
        EXPECT_EQ(labels, state.breadth_first());
    }
}

TEST(ConnectedComponents, WallContactSpreadsOverTheBody) {
    const Labels components{0, 1, 0, 3, 1, 0};
    const std::vector<std::uint8_t> touches_wall{0, 0, 9, 0, 0, 0};
    const std::vector<std::uint8_t> expected{1, 0, 1, 0, 0, 1};
    ComponentFinder finder;
    for (const int threads : {1, 4}) {
        auto at_wall = touches_wall;
        finder.spread_wall_contact(components.data(), at_wall.data(), 6, ThreadedLoop{threads, 1},
                                   at_wall.data());
        EXPECT_EQ(at_wall, expected);
    }
    std::vector<std::uint8_t> at_wall(6, 5);
    finder.spread_wall_contact(components.data(), touches_wall.data(), 6, SerialLoop{},
                               at_wall.data());
    EXPECT_EQ(at_wall, expected);
}

} // namespace
} // namespace meniscus
