#include "particle_features.hpp"

#include "detectors/neighbor_packs.hpp"

#include <meniscus/runtime/features/second_line.hpp>

#include <utility>

namespace meniscus {
namespace {

/// Neighbors as features take them; lanes that do not count lie at h and weigh nothing.
template <int Dimension>
MENISCUS_INLINE FeatureNeighbor<Pack<float>, Dimension>
in_radii(const PairPack<float, Dimension>& pairs, const NeighborRange<float>& range,
         float inverse_radius) {
    const Pack<float> zero{};
    const Pack<float> one = zero + 1.0F;
    const auto counted =
        (pairs.squared > range.inner_squared) & (pairs.squared < range.outer_squared);
    FeatureNeighbor<Pack<float>, Dimension> neighbor;
    for (int axis = 0; axis < Dimension; ++axis)
        neighbor.step[axis] = pairs.step[axis] * inverse_radius;
    neighbor.squared = counted ? pairs.squared * (inverse_radius * inverse_radius) : one;
    neighbor.mass = neighbor.count = counted ? one : zero;
    return neighbor;
}

/// One feature's sums over the neighbors of a particle.
template <class Feature, int Dimension>
struct FeatureLanes {
    static constexpr int terms = Feature::template terms<Dimension>;
    Pack<float> lanes[terms] = {};

    MENISCUS_INLINE void add(const FeatureNeighbor<Pack<float>, Dimension>& neighbor) {
        Feature::template add<float>(neighbor, lanes);
    }
    [[nodiscard]] MENISCUS_INLINE float value(float volume) const {
        float sums[terms];
        for (int t = 0; t < terms; ++t)
            sums[t] = sum_of_lanes(lanes[t]);
        const float value = Feature::template value<Dimension>(sums);
        return Feature::is_over_kernel ? volume * value : value;
    }
};

/// Sets the arrays of these features of the list, each of them once.
template <int Dimension, std::size_t... Features>
void find_listed(const FluidState<float>& state, FeatureArrays& arrays) {
    ((arrays[Features].resize(state.size())), ...);
    const float h = state.support_radius;
    const auto range = neighbor_range<float>(static_cast<double>(h), 0.8);
    const float volume = state.particle_volume / (Dimension == 3 ? h * h * h : h * h);
    for (std::size_t i = 0; i < state.size(); ++i) {
        std::tuple<FeatureLanes<FeatureAt<Features>, Dimension>...> sums;
        visit_packs<Dimension>(state, i, [&](const PairPack<float, Dimension>& pairs) {
            const auto neighbor = in_radii<Dimension>(pairs, range, 1 / h);
            std::apply([&](auto&... sum) { (sum.add(neighbor), ...); }, sums);
        });
        std::apply([&](const auto&... sum) { ((arrays[Features][i] = sum.value(volume)), ...); },
                   sums);
    }
}

template <int Dimension, std::size_t First, std::size_t Second>
void find_pair(const FluidState<float>& state, FeatureArrays& arrays) {
    if constexpr (First == Second)
        find_listed<Dimension, First>(state, arrays);
    else
        find_listed<Dimension, First, Second>(state, arrays);
}

using FindPair = void (*)(const FluidState<float>&, FeatureArrays&);

/// The loop for features a and b stands at place a * feature_count + b.
template <int Dimension, std::size_t... Places>
constexpr std::array<FindPair, sizeof...(Places)> loops_of_pairs(std::index_sequence<Places...>) {
    return {find_pair<Dimension, Places / feature_count, Places % feature_count>...};
}

using AllPairs = std::make_index_sequence<feature_count * feature_count>;

template <int Dimension, std::size_t... Features>
void find_all(const FluidState<float>& state, FeatureArrays& arrays,
              std::index_sequence<Features...>) {
    find_listed<Dimension, Features...>(state, arrays);
}

} // namespace

void find_features(const FluidState<float>& state, const FeaturePair& features,
                   FeatureArrays& arrays) {
    static constexpr auto in_space = loops_of_pairs<3>(AllPairs{});
    static constexpr auto in_the_plane = loops_of_pairs<2>(AllPairs{});
    const std::size_t place = features.first * feature_count + features.second;
    (state.dimension == 3 ? in_space : in_the_plane)[place](state, arrays);
}

FeatureArrays all_features(const FluidState<float>& state) {
    FeatureArrays arrays;
    constexpr std::make_index_sequence<feature_count> all;
    if (state.dimension == 3)
        find_all<3>(state, arrays, all);
    else
        find_all<2>(state, arrays, all);
    return arrays;
}

} // namespace meniscus
