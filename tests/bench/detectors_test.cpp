#include "detectors/detector.hpp"
#include "detectors/renormalization.hpp"

#include <meniscus/runtime/math/angles.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace meniscus {
namespace {

/// Spacing 1, support radius 2; positions have z = 0 in the plane.
template <class Real>
FluidState<Real> made_state(const Positions& positions, int dimension) {
    FluidState<Real> state;
    state.dimension = dimension;
    state.support_radius = 2;
    state.particle_volume = 1;
    state.lists = find_neighbors(positions, 2.0);
    state.surface.resize(positions.size());
    for (const auto& position : positions)
        for (int axis = 0; axis < dimension; ++axis)
            state.positions.push_back(static_cast<Real>(position[static_cast<std::size_t>(axis)]));
    return state;
}

template <class Real>
std::vector<Detector<Real>> rivals(int dimension) {
    std::vector<Detector<Real>> all;
    add_coverage_detectors(dimension, all);
    all.erase(all.begin(), all.end() - 1); // but for the cover vector, they are not others'
    add_eigenvalue_detectors(dimension, all);
    add_divergence_detectors(dimension, all);
    add_visibility_detectors(dimension, all);
    return all;
}

/// The one of that group whose name ends in `end`.
template <class Real>
Detector<Real> rival(int dimension, const std::string& group, const std::string& end) {
    for (const auto& one : rivals<Real>(dimension))
        if (one.group == group && one.name.size() >= end.size() &&
            one.name.compare(one.name.size() - end.size(), end.size(), end) == 0)
            return one;
    throw std::invalid_argument("no detector of " + group + " " + end);
}

template <class Real>
std::vector<std::uint8_t> detect(const Detector<Real>& detector, const FluidState<Real>& state,
                                 int threads = 1) {
    std::vector<std::uint8_t> surface(3, 7); // whatever it held before
    const Detection detection = detector.prepare(state, threads);
    detection(surface);
    return surface;
}

/// A lattice of `edge` particles along each axis, each moved by up to `jitter` along each axis.
Positions block(int edge, int dimension, double jitter) {
    std::mt19937_64 generator(3);
    std::uniform_real_distribution<double> move(-jitter, jitter);
    Positions positions;
    for (int x = 0; x < edge; ++x)
        for (int y = 0; y < edge; ++y)
            for (int z = 0; z < (dimension == 3 ? edge : 1); ++z) {
                positions.push_back({x + move(generator), y + move(generator), double(z)});
                if (dimension == 3)
                    positions.back()[2] += move(generator);
            }
    return positions;
}

/// Layers between a particle of such a block and the nearest face; 0 at the face.
int layer(const std::array<double, 3>& position, int edge, int dimension) {
    int min = edge;
    for (int axis = 0; axis < dimension; ++axis) {
        const int place = static_cast<int>(std::lround(position[static_cast<std::size_t>(axis)]));
        min = std::min({min, place, edge - 1 - place});
    }
    return min;
}

template <class Real, int Dimension>
struct Sums {
    FluidState<Real> state;

    explicit Sums(const Positions& positions) : state(made_state<Real>(positions, Dimension)) {}
    [[nodiscard]] GradientSums<Real, Dimension> gradients() const { return {state}; }
};

template <class Real>
class RenormalizationTest : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(RenormalizationTest, Reals);

// At half the support radius the cubic spline of radius 1 has W' = -1.5 sigma, sigma = 8 / pi in
// space and 40 / (7 pi) in the plane, so V W' r / h^(D + 1) = 0.75 sigma / 2^D for V = 1, h = 2.
TYPED_TEST(RenormalizationTest, TwoParticlesByHand) {
    const Sums<TypeParam, 3> space({{5, 5, 5}, {5, 6, 5}});
    const auto matrix = renormalization_matrix(space.gradients(), 0);
    EXPECT_NEAR(matrix(1, 1), 0.75 * 8 / pi / 8, 1e-6);
    EXPECT_NEAR((matrix.array().abs().sum()), matrix(1, 1), 1e-12);
    EXPECT_NEAR((min_eigenvalue<TypeParam, 3>(matrix)), 0, 1e-4);
    EXPECT_NEAR(position_divergence(space.gradients(), 1), 0.75 * 8 / pi / 8, 1e-6);

    const Sums<TypeParam, 2> plane({{5, 5, 0}, {6, 5, 0}});
    EXPECT_NEAR(renormalization_matrix(plane.gradients(), 0)(0, 0), 0.75 * 40 / (7 * pi) / 4, 1e-6);
    EXPECT_NEAR(position_divergence(plane.gradients(), 1), 0.75 * 40 / (7 * pi) / 4, 1e-6);
}

TYPED_TEST(RenormalizationTest, GradientPointsToTheNeighbor) {
    const Sums<TypeParam, 3> sums({{5, 5, 5}, {5, 4, 5}});
    const auto around = renormalization(sums.gradients(), 0,
                                        [](const auto&) { return all_lanes<Pack<TypeParam>>(2); });
    // 2 V W' / h^4, the divergence of the pair over its distance, twice.
    EXPECT_NEAR(around.gradient[1], -2 * 0.75 * 8 / pi / 8, 1e-6);
    EXPECT_EQ(around.gradient[0], 0);
}

TYPED_TEST(RenormalizationTest, SmallestEigenvalueOfAKnownMatrix) {
    SquareMatrix<TypeParam, 3> m;
    m << 2, 1, 0, 1, 2, 0, 0, 0, 5; // 1, 3 and 5
    EXPECT_NEAR((min_eigenvalue<TypeParam, 3>(m)), 1, 1e-5);
    SquareMatrix<TypeParam, 2> plane;
    plane << 2, 1, 1, 2;
    EXPECT_NEAR((min_eigenvalue<TypeParam, 2>(plane)), 1, 1e-5);
}

template <class Real, int Dimension>
void expect_unity_inside() {
    const Positions positions = block(13, Dimension, 0.1);
    const Sums<Real, Dimension> sums(positions);
    std::size_t inside = 0;
    for (std::size_t i = 0; i < positions.size(); ++i)
        if (layer(positions[i], 13, Dimension) >= 3) {
            ++inside;
            const auto matrix = renormalization_matrix(sums.gradients(), i);
            const Real lambda = min_eigenvalue<Real, Dimension>(matrix);
            EXPECT_NEAR(lambda, 1, 0.2) << i;
            const Real divergence = position_divergence(sums.gradients(), i);
            EXPECT_NEAR(divergence, Dimension, 0.1 * Dimension) << i;
            EXPECT_NEAR(divergence, matrix.trace(), 1e-5) << i;
        }
    EXPECT_EQ(inside, Dimension == 3 ? 343U : 49U);
}

TYPED_TEST(RenormalizationTest, NearTheIdentityInside) {
    expect_unity_inside<TypeParam, 2>();
    expect_unity_inside<TypeParam, 3>();
}

template <class Real>
class DetectorTest : public testing::Test {};
TYPED_TEST_SUITE(DetectorTest, Reals);

TYPED_TEST(DetectorTest, FacesOfABlockAndNothingDeepInside) {
    for (const int dimension : {2, 3}) {
        constexpr int edge = 13;
        const Positions positions = block(edge, dimension, 0.05);
        const auto state = made_state<TypeParam>(positions, dimension);
        for (const auto& detector : rivals<TypeParam>(dimension)) {
            const auto surface = detect(detector, state);
            ASSERT_EQ(surface.size(), state.size());
            std::size_t missed = 0;
            for (std::size_t i = 0; i < state.size(); ++i) {
                missed += static_cast<std::size_t>(layer(positions[i], edge, dimension) == 0 &&
                                                   surface[i] == 0);
                if (layer(positions[i], edge, dimension) >= 2) {
                    EXPECT_EQ(surface[i], 0) << detector.name << " in " << dimension << "D";
                }
            }
            // In space the middle of a face has a divergence of about that threshold.
            if (dimension == 2 || detector.name.find("0.75 D") == std::string::npos) {
                EXPECT_EQ(missed, 0U) << detector.name << " in " << dimension << "D";
            }
        }
    }
}

TYPED_TEST(DetectorTest, AnyNumberOfThreadsSaysTheSame) {
    for (const int dimension : {2, 3}) {
        const auto state = made_state<TypeParam>(block(12, dimension, 0.3), dimension);
        for (const auto& detector : rivals<TypeParam>(dimension))
            EXPECT_EQ(detect(detector, state, 1), detect(detector, state, 3)) << detector.name;
    }
}

TYPED_TEST(DetectorTest, RepeatedDetectionsSayTheSame) {
    const auto state = made_state<TypeParam>(block(9, 3, 0.3), 3);
    for (const auto& detector : rivals<TypeParam>(3)) {
        const Detection detection = detector.prepare(state, 2);
        std::vector<std::uint8_t> first;
        std::vector<std::uint8_t> second;
        detection(first);
        detection(second);
        EXPECT_EQ(first, second) << detector.name;
    }
}

/// Sets of which every particle is at the surface.
std::vector<Positions> degenerate_sets(int dimension) {
    std::vector<Positions> sets = {{{1, 1, 0}}, {{1, 1, 0}, {1.5, 1, 0}}};
    sets.push_back({{0, 0, 0}, {2e6, 0, 0}});          // far apart
    sets.push_back(Positions(10, {1, 1, 0}));          // in one place
    sets.push_back({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}); // fewer than a hull needs
    Positions line;
    for (int n = 0; n < 9; ++n)
        line.push_back({0.75 * n, 0.5 * n, 0});
    sets.push_back(line);
    if (dimension == 3)
        sets.push_back(block(5, 2, 0)); // a film of one layer
    return sets;
}

TYPED_TEST(DetectorTest, DegenerateSetsAreAllSurface) {
    for (const int dimension : {2, 3}) {
        const auto sets = degenerate_sets(dimension);
        for (const auto& detector : rivals<TypeParam>(dimension)) {
            EXPECT_TRUE(detect(detector, made_state<TypeParam>({}, dimension)).empty());
            for (std::size_t s = 0; s < sets.size(); ++s) {
                const auto surface = detect(detector, made_state<TypeParam>(sets[s], dimension));
                EXPECT_EQ(surface, std::vector<std::uint8_t>(sets[s].size(), 1))
                    << detector.name << ", set " << s << " in " << dimension << "D";
            }
        }
    }
}

TYPED_TEST(DetectorTest, OneOfTwoParticlesInAPlaceIsSeen) {
    const auto state =
        made_state<TypeParam>({{1, 1, 0}, {1, 1, 0}, {1.5, 1, 0}, {1.5, 1, 0}, {1, 2, 0}}, 2);
    std::vector<Detector<TypeParam>> all;
    add_visibility_detectors(2, all);
    for (const auto& detector : all) {
        const auto surface = detect(detector, state);
        EXPECT_TRUE(surface[0] || surface[1]) << detector.name;
        EXPECT_TRUE(surface[2] || surface[3]) << detector.name;
        EXPECT_TRUE(surface[4]) << detector.name;
    }
}

TYPED_TEST(DetectorTest, IsolatedParticleBesideABlock) {
    for (const int dimension : {2, 3}) {
        Positions positions = block(9, dimension, 0);
        positions.push_back({4, 15, dimension == 3 ? 4.0 : 0.0});
        const auto state = made_state<TypeParam>(positions, dimension);
        for (const auto& detector : rivals<TypeParam>(dimension))
            EXPECT_EQ(detect(detector, state).back(), 1) << detector.name;
    }
}

/// The half of a lattice below one of its particles, which is particle 0.
Positions half_space(int dimension) {
    Positions positions = {{0, 0, 0}};
    for (int x = -4; x <= 4; ++x)
        for (int y = -4; y <= 0; ++y)
            for (int z = (dimension == 3 ? -4 : 0); z <= (dimension == 3 ? 4 : 0); ++z)
                if (x != 0 || y != 0 || z != 0)
                    positions.push_back({double(x), double(y), double(z)});
    return positions;
}

/// What the detectors with a cone say of particle 0, and the one without.
template <class Real>
std::array<int, 3> seen_by_eigenvalue(const Positions& positions, int dimension) {
    std::vector<Detector<Real>> all;
    add_eigenvalue_detectors(dimension, all);
    const auto state = made_state<Real>(positions, dimension);
    return {detect(all[0], state)[0], detect(all[1], state)[0], detect(all[2], state)[0]};
}

TYPED_TEST(DetectorTest, WhatLiesInTheUmbrellaCovers) {
    using Seen = std::array<int, 3>;
    for (const int dimension : {2, 3}) {
        const auto with = [&](std::array<double, 3> extra) {
            Positions positions = half_space(dimension);
            positions.push_back(extra);
            return seen_by_eigenvalue<TypeParam>(positions, dimension);
        };
        EXPECT_EQ(with({9, 9, 0}), (Seen{1, 1, 1}));     // nowhere near
        EXPECT_EQ(with({0.1, 1.9, 0}), (Seen{1, 0, 0})); // in the ball beyond the cone
        EXPECT_EQ(with({0.5, 1.75, 0}), (Seen{1, 0, 0}));
        EXPECT_EQ(with({1.1, 1.3, 0}), (Seen{1, 1, 1})); // beyond the cone, outside of the ball
        EXPECT_EQ(with({1.1, 0.6, 0}), (Seen{1, 1, 1})); // beside the cone
    }
}

TYPED_TEST(DetectorTest, DualSphysicsLooksIntoTheUmbrellaOfFewParticles) {
    for (const int dimension : {2, 3}) {
        const auto seen = [&](const Positions& positions) {
            const auto state = made_state<TypeParam>(positions, dimension);
            return int{detect(rival<TypeParam>(dimension, "divergence", "then cone"), state)[0]};
        };
        const auto with = [&](std::array<double, 3> extra) {
            Positions positions = half_space(dimension);
            positions.push_back(extra);
            return seen(positions);
        };
        EXPECT_EQ(with({9, 9, 0}), 1);     // nowhere near
        EXPECT_EQ(with({0.1, 1.9, 0}), 0); // in the ball beyond the cone
        EXPECT_EQ(with({0.5, 1.75, 0}), 0);
        EXPECT_EQ(with({0.2, 1.3, 0}), 0);          // in the cone
        EXPECT_EQ(with({1.1, 1.3, 0}), 1);          // beyond the cone, outside of the ball
        EXPECT_EQ(with({1.1, 0.6, 0}), 1);          // beside the cone
        EXPECT_EQ(seen({{0, 0, 0}, {0, 1, 0}}), 1); // isolated, whatever lies in front
    }
}

// On a slope the program's umbrella in the plane is a disc of 1 / sqrt(2) lengths, which leaves out
// the corners of the cone.
TYPED_TEST(DetectorTest, DualSphysicsUmbrellaInThePlaneTurnsWithTheAxes) {
    Positions slope = {{0, 0, 0}};
    for (int x = -4; x <= 4; ++x)
        for (int y = -4; y <= 4; ++y)
            if (x + y <= 0 && (x != 0 || y != 0))
                slope.push_back({double(x), double(y), 0});
    // Two particles, one on each side, so that the normal stays where it is.
    const auto with = [](Positions positions, double height, double across, bool is_slope) {
        for (const double side : {-across, across})
            positions.push_back(is_slope
                                    ? std::array<double, 3>{(height + side) / std::sqrt(2.0),
                                                            (height - side) / std::sqrt(2.0), 0}
                                    : std::array<double, 3>{side, height, 0});
        const auto state = made_state<TypeParam>(positions, 2);
        return int{detect(rival<TypeParam>(2, "divergence", "then cone"), state)[0]};
    };
    EXPECT_EQ(with(half_space(2), 0.8, 0.1, false), 0);
    EXPECT_EQ(with(slope, 0.8, 0.1, true), 0);
    EXPECT_EQ(with(half_space(2), 0.95, 0.8, false), 0);
    EXPECT_EQ(with(slope, 0.95, 0.8, true), 1);
}

TYPED_TEST(DetectorTest, SecondLayerIsWithinHalfTheSupportOfTheFirst) {
    const auto state = made_state<TypeParam>(half_space(2), 2);
    const auto surface = detect(rival<TypeParam>(2, "divergence", "second layer"), state);
    const auto first = detect(rival<TypeParam>(2, "divergence", "below 1.5"), state);
    EXPECT_EQ(first[0], 1);
    for (std::size_t i = 0; i < state.size(); ++i) {
        bool beside = first[i] != 0;
        for (std::size_t j = 0; j < state.size(); ++j)
            beside |= first[j] != 0 &&
                      std::hypot(state.positions[2 * i] - state.positions[2 * j],
                                 state.positions[2 * i + 1] - state.positions[2 * j + 1]) < 1;
        EXPECT_EQ(surface[i] != 0, beside) << i;
    }
}

TYPED_TEST(DetectorTest, CoverVectorHasAConeOfThirtyDegrees) {
    for (const int dimension : {2, 3}) {
        const auto with = [&](double degrees, double distance) {
            Positions positions = half_space(dimension);
            // One on each side, so that the vector stays upright.
            const double across = distance * std::sin(degrees * pi / 180);
            const double height = distance * std::cos(degrees * pi / 180);
            positions.push_back({across, height, 0});
            positions.push_back({-across, height, 0});
            const auto state = made_state<TypeParam>(positions, dimension);
            return int{detect(rival<TypeParam>(dimension, "cover vector", ""), state)[0]};
        };
        EXPECT_EQ(with(0, 5), 1);
        EXPECT_EQ(with(28, 0.5), 0);
        EXPECT_EQ(with(28, 1.9), 0);
        EXPECT_EQ(with(32, 0.5), 1);
        EXPECT_EQ(with(32, 1.9), 1);
    }
}

// Neighbors on a circle around one, all on one side but for one straight ahead.
TYPED_TEST(DetectorTest, CoverVectorTakesFewNeighborsForASurface) {
    const auto seen = [](int count) {
        Positions positions = {{0, 0, 0}, {0, 1, 0}, {0, 0, 0}}; // the last has no direction
        for (int n = 1; n < count; ++n)
            positions.push_back({0.1 * n - 0.05 * count, -1, 0});
        const auto state = made_state<TypeParam>(positions, 2);
        return int{detect(rival<TypeParam>(2, "cover vector", ""), state)[0]};
    };
    EXPECT_EQ(seen(4), 1);
    EXPECT_EQ(seen(5), 0);
}

/// A lattice within 8 spacings of its middle.
Positions ball() {
    Positions positions;
    for (int x = -8; x <= 8; ++x)
        for (int y = -8; y <= 8; ++y)
            for (int z = -8; z <= 8; ++z)
                if (x * x + y * y + z * z <= 64)
                    positions.push_back({double(x), double(y), double(z)});
    return positions;
}

TYPED_TEST(DetectorTest, OutermostLayerOfABallAndNotItsMiddle) {
    const Positions positions = ball();
    const auto state = made_state<TypeParam>(positions, 3);
    for (const auto& detector : {rival<TypeParam>(3, "cover vector", ""),
                                 rival<TypeParam>(3, "divergence", "then cone")}) {
        const auto surface = detect(detector, state);
        for (std::size_t i = 0; i < state.size(); ++i) {
            const auto& p = positions[i];
            const double radius = std::hypot(p[0], p[1], p[2]);
            if (radius > 7.8) {
                EXPECT_EQ(surface[i], 1) << detector.name << " at " << radius;
            }
            if (radius < 6) {
                EXPECT_EQ(surface[i], 0) << detector.name << " at " << radius;
            }
        }
    }
}

TYPED_TEST(DetectorTest, VisibilityFindsTheOutermostLayerOfABallAlone) {
    const Positions positions = ball();
    const auto state = made_state<TypeParam>(positions, 3);
    std::vector<Detector<TypeParam>> all;
    add_visibility_detectors(3, all);
    for (const auto& detector : all) {
        const auto surface = detect(detector, state);
        for (std::size_t i = 0; i < state.size(); ++i) {
            const auto& p = positions[i];
            const double radius = std::hypot(p[0], p[1], p[2]);
            if (radius > 7.8) {
                EXPECT_EQ(surface[i], 1) << detector.name << " at " << radius;
            }
            if (radius < 6) {
                EXPECT_EQ(surface[i], 0) << detector.name << " at " << radius;
            }
        }
    }
}

TYPED_TEST(DetectorTest, VisibilityFindsACavity) {
    Positions positions;
    for (const auto& p : block(31, 2, 0))
        if (std::hypot(p[0] - 15, p[1] - 15) > 2.5)
            positions.push_back(p);
    const auto state = made_state<TypeParam>(positions, 2);
    std::vector<Detector<TypeParam>> all;
    add_visibility_detectors(2, all);
    for (const auto& detector : all) {
        const auto surface = detect(detector, state);
        for (std::size_t i = 0; i < state.size(); ++i)
            if (std::hypot(positions[i][0] - 15, positions[i][1] - 15) < 3.1) {
                EXPECT_EQ(surface[i], 1) << detector.name;
            }
    }
}

} // namespace
} // namespace meniscus
