#include "features/particle_features.hpp"
#include "reference/feature_reference.hpp"

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

/// All features of a particle as they are defined, those over the kernel in volumes.
template <int Dimension>
std::map<std::string, double> reference(const FluidState<float>& state, std::size_t i) {
    const double h = static_cast<double>(state.support_radius);
    std::vector<test::ReferenceNeighbor<Dimension>> around;
    for (std::size_t n = state.lists.offsets[i]; n < state.lists.offsets[i + 1]; ++n) {
        const std::size_t j = state.lists.neighbors[n];
        test::ReferenceNeighbor<Dimension> neighbor;
        for (int axis = 0; axis < Dimension; ++axis)
            neighbor.step[axis] =
                static_cast<double>(
                    state.positions[Dimension * j + static_cast<std::size_t>(axis)] -
                    state.positions[Dimension * i + static_cast<std::size_t>(axis)]) /
                h;
        around.push_back(neighbor);
    }
    auto values = test::features_by_definition<Dimension>(around);
    const double volume = static_cast<double>(state.particle_volume) / std::pow(h, Dimension);
    for (const char* name : {"kernel_sum", "gradient_eigenvalue", "position_divergence"})
        values.at(name) *= volume;
    return values;
}

template <int Dimension>
void expect_as_defined() {
    const auto state = random_state(Dimension, Dimension == 3 ? 450 : 350);
    const FeatureArrays features = all_features(state);
    for (std::size_t i = 0; i < state.size(); ++i) {
        const auto expected = reference<Dimension>(state, i);
        for (std::size_t f = 0; f < feature_count; ++f) {
            const double value = expected.at(feature_list[f].name);
            EXPECT_NEAR(features[f][i], value, 1e-4 * std::max(1.0, value))
                << feature_list[f].name << " of " << i;
        }
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
                find_features(state, {a, b}, pair);
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
        const bool is_kernel = f == find_feature("kernel_sum");
        EXPECT_NEAR(features[f].at(0), is_kernel ? 0.125 * 8 / pi : 0, 1e-6) << f;
    }
}

} // namespace
} // namespace meniscus
