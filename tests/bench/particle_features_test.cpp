#include "comparison/particle_features.hpp"

#include <meniscus/runtime/angles.hpp>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace meniscus {
namespace {

/// Random places, about 30 in a support radius, and two in one place.
FluidState<float> random_state(int dimension, std::size_t count) {
    std::mt19937_64 generator(11);
    std::uniform_real_distribution<float> place(0, 6);
    FluidState<float> state;
    state.dimension = dimension;
    state.support_radius = dimension == 3 ? 1.5F : 1.0F;
    state.particle_volume = 0.1F;
    Positions positions;
    for (std::size_t i = 0; i < count; ++i) {
        positions.push_back({place(generator), place(generator), 0});
        if (dimension == 3)
            positions.back()[2] = place(generator);
        if (i == 1)
            positions[1] = positions[0];
        for (int axis = 0; axis < dimension; ++axis)
            state.positions.push_back(
                static_cast<float>(positions.back()[static_cast<std::size_t>(axis)]));
    }
    state.lists = find_neighbors(positions, static_cast<double>(state.support_radius));
    state.surface.resize(count);
    return state;
}

double spline(double q, int dimension) {
    const double scale = dimension == 2 ? 40 / (7 * pi) : 8 / pi;
    return scale * (q <= 0.5 ? 1 - 6 * q * q + 6 * q * q * q : 2 * std::pow(1 - q, 3));
}

double spline_slope(double q, int dimension) {
    const double scale = dimension == 2 ? 40 / (7 * pi) : 8 / pi;
    return scale * (q <= 0.5 ? 18 * q * q - 12 * q : -6 * (1 - q) * (1 - q));
}

/// All features of a particle, written down as they are defined.
template <int Dimension>
std::array<double, feature_count> reference(const FluidState<float>& state, std::size_t i) {
    using Vector = Eigen::Matrix<double, Dimension, 1>;
    using Matrix = Eigen::Matrix<double, Dimension, Dimension>;
    const double h = static_cast<double>(state.support_radius);
    const double volume = static_cast<double>(state.particle_volume) / std::pow(h, Dimension);
    const auto place = [&](std::size_t j) {
        Vector x;
        for (int axis = 0; axis < Dimension; ++axis)
            x[axis] = static_cast<double>(
                state.positions[Dimension * j + static_cast<std::size_t>(axis)]);
        return x;
    };
    Vector offset = Vector::Zero(), unit = offset, squared = offset;
    Matrix renormalization = Matrix::Zero(), directions = renormalization, moments = directions;
    double count = 0;
    double density = spline(0, Dimension);
    for (std::size_t n = state.lists.offsets[i]; n < state.lists.offsets[i + 1]; ++n) {
        const Vector step = (place(state.lists.neighbors[n]) - place(i)) / h;
        const double q = step.norm();
        density += spline(q, Dimension);
        if (q > 0)
            renormalization -= spline_slope(q, Dimension) / q * step * step.transpose();
        if (q <= 0.2)
            continue;
        ++count;
        offset += step;
        unit += step / q;
        squared += step * q;
        moments += step * step.transpose();
        directions += step * step.transpose() / (q * q);
    }
    const auto least = [](const Matrix& matrix) {
        return Eigen::SelfAdjointEigenSolver<Matrix>(matrix).eigenvalues()[0];
    };
    const double per = 1 / std::max(1.0, count);
    return {offset.norm() * per,
            count,
            unit.norm() * per,
            squared.norm() * per,
            volume * density,
            least(volume * renormalization),
            volume * renormalization.trace(),
            least(directions),
            least(moments)};
}

template <int Dimension>
void expect_as_defined() {
    const auto state = random_state(Dimension, Dimension == 3 ? 450 : 350);
    const FeatureArrays features = all_features(state);
    for (std::size_t i = 0; i < state.size(); ++i) {
        const auto expected = reference<Dimension>(state, i);
        for (std::size_t f = 0; f < feature_count; ++f)
            EXPECT_NEAR(features[f][i], expected[f], 1e-4 * std::max(1.0, expected[f]))
                << feature_name(static_cast<Feature>(f)) << " of " << i;
    }
}

TEST(ParticleFeaturesTest, AsDefined) {
    expect_as_defined<3>();
    expect_as_defined<2>();
}

TEST(ParticleFeaturesTest, PapersPairAsInTheRuntime) {
    const auto state = random_state(3, 450);
    const FeatureArrays features = all_features(state);
    const auto range = neighbor_range<float>(1.5, 0.8);
    for (std::size_t i = 0; i < state.size(); ++i) {
        const auto sum = sum_features(state.view<3>(), i, range);
        EXPECT_EQ(features[1][i], static_cast<float>(sum.count));
        EXPECT_NEAR(features[0][i], mass_offset(sum, 1.5F), 1e-6);
    }
}

TEST(ParticleFeaturesTest, EachPairAsAmongAll) {
    for (const int dimension : {2, 3}) {
        const auto state = random_state(dimension, 200);
        const FeatureArrays all = all_features(state);
        for (std::size_t a = 0; a < feature_count; ++a)
            for (std::size_t b = 0; b < feature_count; ++b) {
                FeatureArrays pair;
                find_features(state, static_cast<Feature>(a), static_cast<Feature>(b), pair);
                for (std::size_t f = 0; f < feature_count; ++f)
                    EXPECT_EQ(pair[f], f == a || f == b ? all[f] : std::vector<float>());
            }
    }
}

TEST(ParticleFeaturesTest, NobodyAround) {
    FluidState<float> state;
    state.support_radius = 1;
    state.particle_volume = 0.125F;
    state.positions = {1, 2, 3};
    state.surface.resize(1);
    state.lists = find_neighbors({{1, 2, 3}}, 1.0);
    const FeatureArrays features = all_features(state);
    for (std::size_t f = 0; f < feature_count; ++f) {
        const bool is_density = static_cast<Feature>(f) == Feature::density;
        EXPECT_NEAR(features[f].at(0), is_density ? 0.125 * 8 / pi : 0, 1e-6) << f;
    }
}

} // namespace
} // namespace meniscus
