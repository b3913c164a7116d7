// Forces of free components without net force and torque.
#include <meniscus/runtime/surface/momentum.hpp>

#include "threaded_loop.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <vector>

namespace meniscus {
namespace {

/// What the corrected forces of a component may add up to, relative to their sizes.
template <class Real>
constexpr double tolerance = sizeof(Real) == sizeof(double) ? 1e-12 : 1e-6;

/// Particles with forces, all listed, one component at first.
template <class Real, int Dimension, int Stride = Dimension>
struct Components {
    std::vector<Real> positions;
    std::vector<Real> forces;
    std::vector<Real> weights;
    std::vector<std::uint32_t> labels;
    std::vector<std::uint8_t> at_wall;
    std::vector<std::uint32_t> list;

    [[nodiscard]] std::size_t size() const { return labels.size(); }

    void add(const Vector3& position, const Vector3& force, double weight,
             std::uint32_t label = 0) {
        for (int axis = 0; axis < Stride; ++axis) // what is no coordinate must not matter
            positions.push_back(axis < Dimension ? static_cast<Real>(position[axis]) : Real(1e9));
        for (int axis = 0; axis < Dimension; ++axis)
            forces.push_back(static_cast<Real>(force[axis]));
        weights.push_back(static_cast<Real>(weight));
        list.push_back(static_cast<std::uint32_t>(labels.size()));
        labels.push_back(label);
    }

    /// Of those listed, whose forces and weights go in the order of the list.
    template <class Loop = SerialLoop>
    void remove_net_force(const Loop& loop = {}) {
        std::vector<Real> listed_forces;
        std::vector<Real> listed_weights;
        for (const std::uint32_t i : list) {
            listed_weights.push_back(weights[i]);
            for (int axis = 0; axis < Dimension; ++axis)
                listed_forces.push_back(forces[i * Dimension + axis]);
        }
        MomentumBalance balance;
        balance.remove_net_force(
            ComponentParticles<Real, Dimension, Stride>{positions.data(), labels.data(),
                                                        at_wall.empty() ? nullptr : at_wall.data()},
            ComponentForces<Real>{list.data(), list.size(), listed_weights.data(),
                                  listed_forces.data()},
            loop);
        for (std::size_t n = 0; n < list.size(); ++n)
            for (int axis = 0; axis < Dimension; ++axis)
                forces[list[n] * Dimension + axis] = listed_forces[n * Dimension + axis];
    }

    [[nodiscard]] Vector3 position(std::size_t i) const {
        return ComponentParticles<Real, Dimension, Stride>::vector_at(&positions[i * Stride]);
    }
    [[nodiscard]] Vector3 force(std::size_t i) const {
        return ComponentParticles<Real, Dimension, Stride>::vector_at(&forces[i * Dimension]);
    }
};

double length(const Vector3& vector) {
    return std::sqrt(dot(vector, vector));
}

/// Net force and torque of one component, and the sums of the sizes of what they are made of.
struct NetForce {
    Vector3 force{}, torque{};
    double forces = 0, torques = 0;
};

template <class State>
NetForce net_force(const State& state, std::uint32_t label = 0) {
    Vector3 center{};
    double count = 0;
    for (const std::uint32_t i : state.list)
        if (state.labels[i] == label) {
            center = sum(center, state.position(i));
            ++count;
        }
    center = scaled(1 / count, center);
    NetForce net;
    for (const std::uint32_t i : state.list) {
        if (state.labels[i] != label)
            continue;
        const Vector3 arm = difference(state.position(i), center);
        net.force = sum(net.force, state.force(i));
        net.torque = sum(net.torque, cross(arm, state.force(i)));
        net.forces += length(state.force(i));
        net.torques += length(arm) * length(state.force(i));
    }
    return net;
}

/// Removes the net force and checks that none is left, measured by the forces left; by those
/// before, where next to nothing needs to be left.
template <class Real, int Dimension, int Stride>
void expect_balanced(Components<Real, Dimension, Stride>& state, bool measure_by_forces_left = true,
                     std::uint32_t label = 0) {
    const NetForce before = net_force(state, label);
    state.remove_net_force();
    const NetForce after = net_force(state, label);
    const NetForce& measure = measure_by_forces_left ? after : before;
    EXPECT_LE(length(after.force), tolerance<Real> * measure.forces);
    EXPECT_LE(length(after.torque), tolerance<Real> * measure.torques);
}

class Random {
public:
    explicit Random(unsigned seed) : engine(seed) {}

    double uniform() { return std::uniform_real_distribution<>()(engine); }

    template <int Dimension>
    Vector3 vector() {
        std::normal_distribution<> normal;
        const double x = normal(engine);
        const double y = normal(engine);
        return {x, y, Dimension == 3 ? normal(engine) : 0};
    }

private:
    std::mt19937 engine;
};

template <class Real, int Dimension, int Stride = Dimension>
Components<Real, Dimension, Stride> random_component(int size, unsigned seed) {
    Random random(seed);
    Components<Real, Dimension, Stride> state;
    for (int n = 0; n < size; ++n)
        state.add(random.vector<Dimension>(), random.vector<Dimension>(), random.uniform());
    return state;
}

template <class Real, int Dimension, int Stride>
void balance_random_components() {
    for (unsigned seed = 0; seed < 200; ++seed)
        for (const int size : {Dimension + 1, 10, 300}) {
            auto state = random_component<Real, Dimension, Stride>(size, seed);
            expect_balanced(state);
        }
}

TEST(Momentum, RandomBodiesDouble3D) {
    balance_random_components<double, 3, 3>();
}
TEST(Momentum, RandomBodiesFloat3DPadded) {
    balance_random_components<float, 3, 4>();
}
TEST(Momentum, RandomBodiesDouble2DInThreeCoordinates) {
    balance_random_components<double, 2, 3>();
}
TEST(Momentum, RandomBodiesFloat2D) {
    balance_random_components<float, 2, 2>();
}

/// The least change is, per weight, the velocity of a rigid motion: no distance would change.
TEST(Momentum, ChangesAsLittleAsPossible) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        auto state = random_component<double, 3>(30, seed);
        const auto before = state;
        state.remove_net_force();
        std::vector<Vector3> motion;
        for (std::size_t i = 0; i < state.size(); ++i)
            motion.push_back(
                scaled(1 / state.weights[i], difference(before.force(i), state.force(i))));
        for (std::size_t i = 0; i < state.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                EXPECT_NEAR(dot(difference(motion[i], motion[j]),
                                difference(state.position(i), state.position(j))),
                            0, 1e-10);
    }
}

TEST(Momentum, ForcesInBalanceStay) {
    auto state = random_component<double, 3>(100, 1);
    state.remove_net_force();
    const auto balanced = state.forces;
    state.remove_net_force();
    for (std::size_t n = 0; n < balanced.size(); ++n)
        EXPECT_NEAR(state.forces[n], balanced[n], 1e-13);
}

/// Positions that float holds exactly near and far, so that the forces must be the same.
TEST(Momentum, FarFromTheOrigin) {
    Random random(3);
    Components<float, 3> near;
    for (int n = 0; n < 50; ++n) {
        Vector3 position;
        for (double& coordinate : position)
            coordinate = std::floor(random.uniform() * 1024) / 256;
        near.add(position, random.vector<3>(), random.uniform());
    }
    auto far = near;
    for (float& coordinate : far.positions)
        coordinate += 10000;
    expect_balanced(near);
    expect_balanced(far);
    EXPECT_EQ(far.forces, near.forces);
}

TEST(Momentum, OneParticleHasNoForce) {
    for (int weight = 1; weight < 100; ++weight) {
        Components<double, 3> state;
        state.add({1, 2, 3}, {0.1, 0.2, 0.3}, weight);
        state.remove_net_force();
        EXPECT_EQ(state.forces, std::vector<double>(3, 0));
    }
}

TEST(Momentum, TwoParticlesPullAlongTheirLine) {
    Components<double, 3> state;
    state.add({0, 0, 0}, {3, 4, 5}, 1);
    state.add({2, 0, 0}, {1, 1, 1}, 1);
    state.remove_net_force();
    const std::vector<double> expected{1, 0, 0, -1, 0, 0};
    for (std::size_t n = 0; n < 6; ++n)
        EXPECT_NEAR(state.forces[n], expected[n], 1e-15);
}

/// Particles in a line in any direction, and ever so little off it: whatever stands across is
/// balanced without forces that grow beyond those there were.
template <class Real, int Dimension>
void balance_lines() {
    for (unsigned seed = 0; seed < 300; ++seed)
        for (const double width : {0.0, 1e-5, 3e-5, 1e-4, 1e-3, 3e-3, 1e-2, 3e-2, 1e-1}) {
            Random random(seed);
            const Vector3 along = random.vector<Dimension>();
            const Vector3 start = random.vector<Dimension>();
            Components<Real, Dimension> state;
            for (int n = 0; n < 20; ++n)
                state.add(sum(sum(start, scaled(random.uniform(), along)),
                              scaled(width, random.vector<Dimension>())),
                          random.vector<Dimension>(), 0.1 + random.uniform());
            const double before = net_force(state).forces;
            SCOPED_TRACE(width);
            expect_balanced(state);
            EXPECT_LE(net_force(state).forces, 4 * before);
        }
}

TEST(Momentum, LinesDouble3D) {
    balance_lines<double, 3>();
}
TEST(Momentum, LinesFloat3D) {
    balance_lines<float, 3>();
}
TEST(Momentum, LinesDouble2D) {
    balance_lines<double, 2>();
}
TEST(Momentum, LinesFloat2D) {
    balance_lines<float, 2>();
}

TEST(Momentum, ParticlesInOnePlace) {
    Random random(8);
    Components<float, 3> state;
    for (int n = 0; n < 30; ++n)
        state.add({1234.5, 0.1, -7}, random.vector<3>(), random.uniform());
    expect_balanced(state);
}

/// All weight in one place, where no force has a lever arm: the net force goes, the torque stays.
TEST(Momentum, WeightInOnePlaceAwayFromOtherForces) {
    for (unsigned seed = 0; seed < 100; ++seed) {
        auto state = random_component<double, 3>(10, seed);
        std::fill(state.weights.begin(), state.weights.begin() + 7, 0.0);
        for (std::size_t n = 24; n < 30; ++n)
            state.positions[n] = state.positions[n - 3];
        const double before = net_force(state).forces;
        state.remove_net_force();
        const NetForce after = net_force(state);
        EXPECT_LE(length(after.force), tolerance<double> * before);
        EXPECT_LE(after.forces, 2 * before);
    }
}

/// Many components in one list, in turns.
template <class Real, int Dimension>
Components<Real, Dimension> many_components() {
    constexpr std::uint32_t components = 50;
    Random random(4);
    Components<Real, Dimension> state;
    for (std::uint32_t i = 0; i < 3000; ++i) {
        const std::uint32_t label = i % components;
        state.add(sum({10.0 * label, 0, 0}, random.vector<Dimension>()), random.vector<Dimension>(),
                  random.uniform() < 0.1 ? 0 : random.uniform(), label);
    }
    return state;
}

TEST(Momentum, EveryFreeBodyForItself) {
    auto state = many_components<double, 3>();
    for (const std::uint32_t label : state.labels)
        state.at_wall.push_back(label % 3 == 0 ? 1 : 0);
    const auto before = state;
    state.remove_net_force();
    for (std::uint32_t label = 0; label < 50; ++label) {
        if (label % 3 == 0)
            continue;
        const NetForce net = net_force(state, label);
        EXPECT_LE(length(net.force), tolerance<double> * net.forces) << label;
        EXPECT_LE(length(net.torque), tolerance<double> * net.torques) << label;
    }
    for (std::size_t i = 0; i < state.size(); ++i)
        EXPECT_EQ(state.force(i) == before.force(i), state.at_wall[i] != 0 || state.weights[i] == 0)
            << i;
}

/// Forces and weights stand in the order of the list: as if there were no other particles.
TEST(Momentum, OnlyListedParticlesCount) {
    auto state = random_component<double, 3>(100, 6);
    const auto before = state;
    for (auto& i : state.list)
        i *= 2;
    state.list.resize(50);
    expect_balanced(state);
    for (std::size_t i = 0; i < 100; ++i)
        EXPECT_EQ(state.force(i) == before.force(i), i % 2 == 1) << i;
}

TEST(Momentum, WeightsThatAreNoneChangeNothing) {
    for (const float weight : {0.0F, -1.0F, std::numeric_limits<float>::quiet_NaN(),
                               std::numeric_limits<float>::infinity()}) {
        auto state = random_component<float, 3>(60, 9);
        std::fill_n(state.weights.begin(), 20, weight);
        const auto before = state.forces;
        expect_balanced(state);
        EXPECT_TRUE(std::equal(before.begin(), before.begin() + 60, state.forces.begin()));

        std::fill(state.weights.begin(), state.weights.end(), weight);
        state.forces = before;
        state.remove_net_force();
        EXPECT_EQ(state.forces, before);
    }
}

TEST(Momentum, EmptyList) {
    auto state = random_component<double, 2>(5, 1);
    const auto before = state.forces;
    state.list.clear();
    state.remove_net_force();
    EXPECT_EQ(state.forces, before);
}

/// Compared with the same loop on one thread: under -ffast-math another loop is other code.
template <class Real, int Dimension, class Loop>
void compare_threads(const Loop& one_thread, const std::vector<Loop>& loops) {
    const auto start = many_components<Real, Dimension>();
    auto reference = start;
    reference.remove_net_force(one_thread);
    for (const Loop& loop : loops) {
        auto other = start;
        other.remove_net_force(loop);
        EXPECT_EQ(other.forces, reference.forces) << loop.threads;
    }
}

TEST(Momentum, SameOnAnyNumberOfThreads) {
    const std::vector<ThreadedLoop> loops{{1, 1}, {2, 7}, {3, 16}, {8, 1000}};
    compare_threads<double, 3>(ThreadedLoop{1, 4000}, loops);
    compare_threads<float, 2>(ThreadedLoop{1, 4000}, loops);
#if defined(_OPENMP)
    const std::vector<OpenMpLoop> open_mp_loops{{2}, {3}, {8}};
    compare_threads<double, 3>(OpenMpLoop{1}, open_mp_loops);
    compare_threads<float, 2>(OpenMpLoop{1}, open_mp_loops);
#endif
}

/// The memory of one balance serves one list after another.
TEST(Momentum, BalanceIsUsedAgain) {
    MomentumBalance balance;
    balance.reserve(10, 1);
    for (const unsigned seed : {1U, 2U}) {
        auto state = many_components<double, 3>();
        auto fresh = state;
        fresh.remove_net_force();
        for (std::uint32_t& label : state.labels)
            label += 1000 * seed;
        balance.remove_net_force(
            ComponentParticles<double, 3>{state.positions.data(), state.labels.data(), nullptr},
            ComponentForces<double>{state.list.data(), state.list.size(), state.weights.data(),
                                    state.forces.data()},
            SerialLoop{});
        EXPECT_EQ(state.forces, fresh.forces);
    }
}

} // namespace
} // namespace meniscus
