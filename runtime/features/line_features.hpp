// Lines in the plane of any two features (list.hpp). A coefficient header whose line is not in the
// paper's plane names its features and its side; the sums that it needs are then put together at
// compile time:
//     LineSum<Coefficients, Real, Dimension> sum;   // one a particle
//     sum.add(displacement, mass, i, j, radii, range);   // one a neighbor
//     is_surface(sum)
// A header without names is of the paper's pair, whose faster sums are in features.hpp. Boundary
// particles, where a header says that they count, come after the fluid's: sum.add_boundary().
#pragma once

#include "../neighbors/boundary.hpp"
#include "classifier_options.hpp"
#include "list.hpp"

#include <limits>
#include <type_traits>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// Tests the bits, because -ffast-math lets a compiler assume that std::isfinite is always true.
template <class Real>
MENISCUS_HOST_DEVICE bool is_finite(Real value) {
    constexpr auto sign_bit = sizeof(Real) * 8 - 1;
    const auto magnitude = static_cast<decltype(bits_of(value))>(bits_of(value) << 1) >> 1;
    static_assert(sizeof(magnitude) * 8 - 1 == sign_bit);
    return magnitude < bits_of(std::numeric_limits<Real>::infinity());
}

/// Whether a point of a plane of features is surface: where y <= k x + d, or, where surface lies
/// above the line, y >= k x + d. Likewise where a feature is not finite: a false positive costs
/// time, a false negative corrupts the physics.
template <class Real>
MENISCUS_HOST_DEVICE bool is_on_surface_side(Real x, Real y, Real k, Real d, bool above) {
    const Real line = k * x + d;
    return (above ? y >= line : y <= line) || !is_finite(x) || !is_finite(y);
}

/// The features of a coefficient struct: the paper's, unless it names others.
template <class Coefficients, class = void>
struct LineFeatures {
    static constexpr FeaturePair pair{};
    static constexpr bool surface_above = false;
};
template <class Coefficients>
struct LineFeatures<Coefficients, std::void_t<decltype(Coefficients::features)>> {
    static constexpr FeaturePair pair{find_feature(Coefficients::features[0]),
                                      find_feature(Coefficients::features[1])};
    static_assert(pair.first < feature_count && pair.second < feature_count,
                  "this coefficient header names a feature that runtime/features/list.hpp lacks: "
                  "use a runtime of its version");
    static constexpr bool surface_above = Coefficients::surface_above;
};

/// By which share of their volume boundary particles count in the features of a coefficient struct;
/// 0: they only cover.
template <class Coefficients, class = void>
inline constexpr double boundary_weight = 0;
template <class Coefficients>
inline constexpr double
    boundary_weight<Coefficients, std::void_t<decltype(Coefficients::boundary_weight)>> =
        Coefficients::boundary_weight;

/// The support radius over particle spacing that the numbers of a coefficient struct are for, where
/// its lines follow the host's; 0 where they are for counts as they are.
template <class Coefficients, class = void>
inline constexpr double home_spacing_ratio = 0;
template <class Coefficients>
inline constexpr double
    home_spacing_ratio<Coefficients, std::void_t<decltype(Coefficients::reference_spacing_ratio)>> =
        Coefficients::reference_spacing_ratio;

/// How much larger counts are at a support radius of so many particle spacings than where the lines
/// of the struct are at home: their ratio to the power of the dimension; 1 where they do not
/// follow.
template <class Coefficients>
constexpr double count_scale(double spacing_ratio) {
    constexpr double reference = home_spacing_ratio<Coefficients>;
    if constexpr (reference == 0) {
        return 1;
    } else {
        const double ratio = spacing_ratio / reference;
        return Coefficients::dimension == 2 ? ratio * ratio : ratio * ratio * ratio;
    }
}

/// The number k or d of a line where counts are so much larger: features that are no fractions grow
/// as counts do.
constexpr double scaled_k(double k, const FeaturePair& pair, double scale) {
    const double x = feature_list[pair.first].is_fraction ? 1 : scale;
    const double y = feature_list[pair.second].is_fraction ? 1 : scale;
    return k * y / x;
}
constexpr double scaled_d(double d, const FeaturePair& pair, double scale) {
    return feature_list[pair.second].is_fraction ? d : d * scale;
}

/// Whether a coefficient struct has a second line, for the candidates of the first.
template <class Coefficients, class = void>
inline constexpr bool has_second_line = false;
template <class Coefficients>
inline constexpr bool
    has_second_line<Coefficients, std::void_t<typename Coefficients::SecondLine>> = true;

/// The line of a coefficient struct as a second one, where counts are so much larger.
template <class Coefficients>
constexpr SecondLine as_second_line(double scale) {
    using Features = LineFeatures<Coefficients>;
    return {true,
            Features::pair.first,
            Features::pair.second,
            scaled_k(Coefficients::k, Features::pair, scale),
            scaled_d(Coefficients::d, Features::pair, scale),
            Features::surface_above};
}

/// True where a coefficient struct is of the paper's pair.
template <class Coefficients>
inline constexpr bool has_features_of_paper = is_of_paper(LineFeatures<Coefficients>::pair);

/// The sums for the line of a coefficient struct. Start from a value-initialized one.
template <class Coefficients, class Real, int Dimension>
struct LineSum {
    using Features = LineFeatures<Coefficients>;
    using First = FeatureAt<Features::pair.first>;
    using Second = FeatureAt<Features::pair.second>;
    static_assert(Coefficients::dimension == Dimension,
                  "these coefficients were trained in another dimension");

    Real first[First::template terms<Dimension>] = {};
    Real second[Second::template terms<Dimension>] = {};
    Real mass = 0;  ///< of all neighbors, kg
    Real count = 0; ///< their weights in sums

    /// Adds a neighbor that counts.
    MENISCUS_HOST_DEVICE void add_counted(const FeatureNeighbor<Real, Dimension>& neighbor) {
        First::template add<Real>(neighbor, first);
        Second::template add<Real>(neighbor, second);
        mass += neighbor.mass;
        count += neighbor.count;
    }

    /// Adds particle j at `displacement` = x_j - x_i (m) with mass m_j (kg) to the sums of particle
    /// i, which matter where radii vary. Outside `range`, which is range_of(radii), it adds
    /// nothing.
    template <class Vector, class Radii>
    MENISCUS_HOST_DEVICE void add(const Vector& displacement, Real neighbor_mass, std::size_t i,
                                  std::size_t j, const Radii& radii,
                                  const NeighborRange<Real>& range) {
        visit_if_in_range<Dimension>(displacement, neighbor_mass, i, j, radii, range,
                                     [&](const auto& neighbor) { add_counted(neighbor); });
    }

    /// Adds a boundary particle that stands for `weight` fluid particles (neighbors/boundary.hpp),
    /// each with the mean mass of the fluid neighbors, which come first.
    template <class Vector, class Radii>
    MENISCUS_HOST_DEVICE void add_boundary(const Vector& displacement, Real weight, std::size_t i,
                                           const Radii& radii, const NeighborRange<Real>& range) {
        const Real mean_mass = count > 0 ? mass / count : Real(1);
        visit_if_in_range<Dimension>(displacement, weight * mean_mass, i, i, radii, range,
                                     [&](auto neighbor) {
                                         neighbor.count = weight;
                                         add_counted(neighbor);
                                     });
    }
};

/// True for surface; a particle without neighbors is. `scale`: count_scale() of the struct that the
/// line belongs to.
template <class Coefficients, class Real, int Dimension>
MENISCUS_HOST_DEVICE bool is_surface(const LineSum<Coefficients, Real, Dimension>& sum,
                                     double scale = 1) {
    using Sum = LineSum<Coefficients, Real, Dimension>;
    constexpr FeaturePair pair = Sum::Features::pair;
    return sum.count == 0 ||
           is_on_surface_side(Sum::First::template value<Dimension>(sum.first),
                              Sum::Second::template value<Dimension>(sum.second),
                              static_cast<Real>(scaled_k(Coefficients::k, pair, scale)),
                              static_cast<Real>(scaled_d(Coefficients::d, pair, scale)),
                              Sum::Features::surface_above);
}

/// Whether particle i of a neighborhood view is surface by the line of a coefficient struct of any
/// two features, over UniformRadius or VaryingRadii. `boundary` has the boundary particles that
/// count, or is NoBoundary.
template <class Coefficients, class Real, int Dimension, class View, class Boundary, class Radii>
bool is_surface_by_features(const View& view, const Boundary& boundary, std::size_t i,
                            const Radii& radii, const NeighborRange<Real>& range, double scale) {
    LineSum<Coefficients, Real, Dimension> sum;
    view(i, [&](std::size_t j, const auto& displacement, Real mass) {
        sum.add(displacement, mass, i, j, radii, range);
    });
    boundary(i, [&](std::size_t, const auto& displacement, Real weight) {
        sum.add_boundary(displacement, weight, i, radii, range);
    });
    return is_surface(sum, scale);
}

/// Classifies particles `begin` to `end - 1` by it: surface[i] becomes 1 or 0. Returns how many are
/// surface. Ranges that do not overlap may run concurrently.
template <class Coefficients, class Real, int Dimension, class View, class Boundary, class Radii>
std::size_t classify_by_features(const View& view, const Boundary& boundary, std::size_t begin,
                                 std::size_t end, const Radii& radii, double spacing_ratio,
                                 std::uint8_t* surface) {
    const double scale = count_scale<Coefficients>(spacing_ratio);
    const auto range = range_of(radii, Coefficients::radius_ratio);
    std::size_t found = 0;
    for (std::size_t i = begin; i < end; ++i) {
        surface[i] =
            static_cast<std::uint8_t>(is_surface_by_features<Coefficients, Real, Dimension>(
                view, boundary, i, radii, range, scale));
        found += surface[i];
    }
    return found;
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
