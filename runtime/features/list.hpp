// The list of features. Whatever takes or gives a feature by name reads it: labels, training,
// audit, classification, coefficient headers, comparisons. A new feature is its file and a row
// here.
#pragma once

#include "direction_eigenvalue.hpp"
#include "direction_offset.hpp"
#include "gradient_eigenvalue.hpp"
#include "kernel_sum.hpp"
#include "mass_offset.hpp"
#include "moment_eigenvalue.hpp"
#include "neighbor_count.hpp"
#include "position_divergence.hpp"
#include "squared_offset.hpp"

#include <array>
#include <cstddef>
#include <string_view>
#include <tuple>
#include <utility>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// In the order of tables.
using FeatureList =
    std::tuple<MassOffset, NeighborCount, DirectionOffset, SquaredOffset, KernelSum,
               GradientEigenvalue, PositionDivergence, DirectionEigenvalue, MomentEigenvalue>;

inline constexpr std::size_t feature_count = std::tuple_size_v<FeatureList>;

/// The feature at a place of the list.
template <std::size_t Feature>
using FeatureAt = std::tuple_element_t<Feature, FeatureList>;

/// What is to be known of a feature at run time (feature_neighbor.hpp).
struct FeatureRow {
    const char* name;
    const char* meaning;
    double float_error;
    bool is_fraction;
    int terms_in_2d; ///< sums that each neighbor adds to
    int terms_in_3d;
};

template <std::size_t... Features>
constexpr std::array<FeatureRow, feature_count> feature_rows(std::index_sequence<Features...>) {
    return {FeatureRow{FeatureAt<Features>::name, FeatureAt<Features>::meaning,
                       FeatureAt<Features>::float_error, FeatureAt<Features>::is_fraction,
                       FeatureAt<Features>::template terms<2>,
                       FeatureAt<Features>::template terms<3>}...};
}

inline constexpr auto feature_list = feature_rows(std::make_index_sequence<feature_count>{});

/// The place of the feature of that name; feature_count where there is none.
constexpr std::size_t find_feature(std::string_view name) {
    std::size_t place = 0;
    while (place < feature_count && name != feature_list[place].name)
        ++place;
    return place;
}

/// The two features of a line's plane, by their places in the list. Lines are over the first, in
/// units of the second.
struct FeaturePair {
    std::size_t first = find_feature(MassOffset::name);
    std::size_t second = find_feature(NeighborCount::name);
};

/// Whether it is the pair of the paper, which FeatureSum (features.hpp) adds up fastest.
constexpr bool is_of_paper(const FeaturePair& pair) {
    return pair.first == FeaturePair{}.first && pair.second == FeaturePair{}.second;
}

/// One feature's value for neighbors that all count.
template <class Feature, class Real, int Dimension>
Real value_of(const FeatureNeighbor<Real, Dimension>* neighbors, std::size_t count) {
    Real sums[Feature::template terms<Dimension>] = {};
    for (std::size_t n = 0; n < count; ++n)
        Feature::template add<Real>(neighbors[n], sums);
    return Feature::template value<Dimension>(sums);
}

template <class Real, int Dimension, std::size_t... Features>
Real value_at(std::size_t feature, const FeatureNeighbor<Real, Dimension>* neighbors,
              std::size_t count, std::index_sequence<Features...>) {
    using Value = Real (*)(const FeatureNeighbor<Real, Dimension>*, std::size_t);
    static constexpr Value values[] = {value_of<FeatureAt<Features>, Real, Dimension>...};
    return values[feature](neighbors, count);
}

/// The value, without unit, of the feature at a place of the list, which must be below
/// feature_count, for `count` neighbors that all count. Where there is none: that of the particle
/// alone.
template <class Real, int Dimension>
Real feature_value(std::size_t feature, const FeatureNeighbor<Real, Dimension>* neighbors,
                   std::size_t count) {
    return value_at<Real, Dimension>(feature, neighbors, count,
                                     std::make_index_sequence<feature_count>{});
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
