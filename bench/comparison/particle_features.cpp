#include "comparison/particle_features.hpp"

#include "comparison/renormalization.hpp"

#include <utility>

namespace meniscus {
namespace {

constexpr unsigned bit(Feature feature) {
    return 1U << static_cast<unsigned>(feature);
}

constexpr unsigned offsets =
    bit(Feature::offset) | bit(Feature::unit_offset) | bit(Feature::squared_offset);
constexpr unsigned moments = bit(Feature::direction_eigenvalue) | bit(Feature::moment_eigenvalue);
constexpr unsigned gradients = bit(Feature::eigenvalue) | bit(Feature::divergence);

template <int Dimension>
struct PackVector {
    Pack<float> axis[Dimension] = {};

    MENISCUS_INLINE void add(const Pack<float>& weight, const PairPack<float, Dimension>& pairs) {
        for (int a = 0; a < Dimension; ++a)
            axis[a] += weight * pairs.step[a];
    }
    [[nodiscard]] MENISCUS_INLINE float length() const {
        float squared = 0;
        for (const Pack<float>& lanes : axis) {
            const float sum = sum_of<float>(lanes);
            squared += sum * sum;
        }
        return std::sqrt(squared);
    }
};

/// A symmetric matrix; what lies above the diagonal is not kept.
template <int Dimension>
struct PackMatrix {
    Pack<float> entry[Dimension][Dimension] = {};

    MENISCUS_INLINE void add(const Pack<float>& weight, const PairPack<float, Dimension>& pairs) {
        for (int row = 0; row < Dimension; ++row) {
            const Pack<float> along = weight * pairs.step[row];
            for (int column = 0; column <= row; ++column)
                entry[row][column] += along * pairs.step[column];
        }
    }
    [[nodiscard]] float least_eigenvalue(float scale) const {
        SquareMatrix<float, Dimension> matrix;
        for (int row = 0; row < Dimension; ++row)
            for (int column = 0; column <= row; ++column)
                matrix(row, column) = matrix(column, row) =
                    scale * sum_of<float>(entry[row][column]);
        return smallest_eigenvalue<float, Dimension>(matrix);
    }
};

/// The sums for the features of a set of bits, and the features from them. What is not wanted is
/// not worked out.
template <unsigned Wanted, int Dimension>
struct FeatureLoop {
    using Kernel = SplinePack<float, Dimension>;
    static constexpr bool wants(unsigned features) { return (Wanted & features) != 0; }

    const FluidState<float>& state;
    GradientSums<float, Dimension> sums;
    NeighborRange<float> range =
        neighbor_range<float>(static_cast<double>(state.support_radius), 0.8);

    MENISCUS_INLINE void particle(std::size_t i, FeatureArrays& features) const {
        PackVector<Dimension> offset, unit, squared;
        Pack<float> count{}, density{}, divergence{};
        PackMatrix<Dimension> matrix, directions, moment;
        visit_packs<Dimension>(state, i, [&](const auto& pairs) {
            if constexpr (wants(offsets | moments | bit(Feature::count))) {
                const Pack<float> zero{};
                const Pack<float> one = zero + 1.0F;
                const auto counted =
                    (pairs.squared > range.inner_squared) & (pairs.squared < range.outer_squared);
                const Pack<float> weight = counted ? one : zero;
                count += weight;
                if constexpr (wants(bit(Feature::offset)))
                    offset.add(weight, pairs);
                if constexpr (wants(bit(Feature::moment_eigenvalue)))
                    moment.add(weight, pairs);
                if constexpr (wants(bit(Feature::direction_eigenvalue)))
                    directions.add(counted ? one / pairs.squared : zero, pairs);
                if constexpr (wants(bit(Feature::unit_offset) | bit(Feature::squared_offset))) {
                    const Pack<float> distance = square_root<float>(pairs.squared);
                    if constexpr (wants(bit(Feature::unit_offset)))
                        unit.add(counted ? one / distance : zero, pairs);
                    if constexpr (wants(bit(Feature::squared_offset)))
                        squared.add(weight * distance, pairs);
                }
            }
            const Pack<float> q_squared = pairs.squared * sums.per_radius_squared;
            if constexpr (wants(bit(Feature::density)))
                density += Kernel::value(q_squared);
            if constexpr (wants(gradients)) {
                const Pack<float> slope = Kernel::slope(q_squared);
                if constexpr (wants(bit(Feature::eigenvalue)))
                    matrix.add(slope, pairs);
                if constexpr (wants(bit(Feature::divergence)))
                    divergence += slope * pairs.squared;
            }
        });
        const auto set = [&](Feature feature, float value) {
            features[static_cast<std::size_t>(feature)][i] = value;
        };
        const float neighbors = sum_of<float>(count);
        const float per_neighbor = neighbors > 0 ? 1 / neighbors : 0;
        const float radius = state.support_radius;
        if constexpr (wants(bit(Feature::offset)))
            set(Feature::offset, offset.length() * per_neighbor / radius);
        if constexpr (wants(bit(Feature::count)))
            set(Feature::count, neighbors);
        if constexpr (wants(bit(Feature::unit_offset)))
            set(Feature::unit_offset, unit.length() * per_neighbor);
        if constexpr (wants(bit(Feature::squared_offset)))
            set(Feature::squared_offset, squared.length() * per_neighbor / (radius * radius));
        if constexpr (wants(bit(Feature::density)))
            set(Feature::density, density_of(i, sum_of<float>(density)));
        if constexpr (wants(bit(Feature::eigenvalue)))
            set(Feature::eigenvalue, matrix.least_eigenvalue(sums.scale));
        if constexpr (wants(bit(Feature::divergence)))
            set(Feature::divergence, sums.scale * sum_of<float>(divergence));
        if constexpr (wants(bit(Feature::direction_eigenvalue)))
            set(Feature::direction_eigenvalue, directions.least_eigenvalue(1));
        if constexpr (wants(bit(Feature::moment_eigenvalue)))
            set(Feature::moment_eigenvalue, moment.least_eigenvalue(sums.per_radius_squared));
    }

private:
    /// With the particle itself once, not as often as it fills up the list.
    [[nodiscard]] float density_of(std::size_t i, float sum) const {
        const std::size_t size = state.lists.offsets[i + 1] - state.lists.offsets[i];
        const std::size_t filled = (pack_size<float> - size % pack_size<float>) % pack_size<float>;
        const float itself = Kernel::value(Pack<float>{})[0];
        const float radius_squared = state.support_radius * state.support_radius;
        return sums.scale * radius_squared * (sum + (1 - static_cast<float>(filled)) * itself);
    }
};

template <unsigned Wanted, int Dimension>
void find_wanted(const FluidState<float>& state, FeatureArrays& features) {
    for (std::size_t f = 0; f < feature_count; ++f)
        if ((Wanted >> f & 1U) != 0)
            features[f].resize(state.size());
    const FeatureLoop<Wanted, Dimension> loop{state, {state}};
    for (std::size_t i = 0; i < state.size(); ++i)
        loop.particle(i, features);
}

using FindWanted = void (*)(const FluidState<float>&, FeatureArrays&);

/// The loop for features a and b stands at place a * feature_count + b.
template <int Dimension, std::size_t... Places>
constexpr std::array<FindWanted, sizeof...(Places)> loops_of_pairs(std::index_sequence<Places...>) {
    return {
        find_wanted<(1U << Places / feature_count) | (1U << Places % feature_count), Dimension>...};
}

using AllPairs = std::make_index_sequence<feature_count * feature_count>;

} // namespace

const char* feature_name(Feature feature) {
    constexpr const char* names[] = {
        "offset",     "count",      "offset of directions",     "squared offset",       "density",
        "eigenvalue", "divergence", "eigenvalue of directions", "eigenvalue of moments"};
    return names[static_cast<std::size_t>(feature)];
}

void find_features(const FluidState<float>& state, Feature a, Feature b, FeatureArrays& features) {
    static constexpr auto in_space = loops_of_pairs<3>(AllPairs{});
    static constexpr auto in_the_plane = loops_of_pairs<2>(AllPairs{});
    const std::size_t place =
        static_cast<std::size_t>(a) * feature_count + static_cast<std::size_t>(b);
    (state.dimension == 3 ? in_space : in_the_plane)[place](state, features);
}

FeatureArrays all_features(const FluidState<float>& state) {
    FeatureArrays features;
    constexpr unsigned all = (1U << feature_count) - 1;
    (state.dimension == 3 ? find_wanted<all, 3> : find_wanted<all, 2>)(state, features);
    return features;
}

} // namespace meniscus
