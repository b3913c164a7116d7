// Lines in the plane of any two features (list.hpp). A coefficient header whose line is not in the
// paper's plane names its features and its side; the sums that it needs are then put together at
// compile time:
//     LineSum<Coefficients, Real, Dimension> sum;   // one a particle
//     sum.add(displacement, mass, i, j, radii, range);   // one a neighbor
//     is_surface(sum)
// A header without names is of the paper's pair, whose faster sums are in features.hpp.
#pragma once

#include "list.hpp"

#include <limits>
#include <type_traits>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// Tests the bits, because -ffast-math lets a compiler assume that std::isfinite is always true.
template <class Real>
bool is_finite(Real value) {
    constexpr auto sign_bit = sizeof(Real) * 8 - 1;
    const auto magnitude = static_cast<decltype(bits_of(value))>(bits_of(value) << 1) >> 1;
    static_assert(sizeof(magnitude) * 8 - 1 == sign_bit);
    return magnitude < bits_of(std::numeric_limits<Real>::infinity());
}

/// Whether a point of a plane of features is surface: where y <= k x + d, or, where surface lies
/// above the line, y >= k x + d. Likewise where a feature is not finite: a false positive costs
/// time, a false negative corrupts the physics.
template <class Real>
bool is_on_surface_side(Real x, Real y, Real k, Real d, bool above) {
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
    bool has_neighbors = false;

    /// Adds a neighbor that counts.
    void add_counted(const FeatureNeighbor<Real, Dimension>& neighbor) {
        First::template add<Real>(neighbor, first);
        Second::template add<Real>(neighbor, second);
        has_neighbors = true;
    }

    /// Adds particle j at `displacement` = x_j - x_i (m) with mass m_j (kg) to the sums of particle
    /// i, which matter where radii vary. Outside `range`, which is range_of(radii), it adds
    /// nothing.
    template <class Vector, class Radii>
    void add(const Vector& displacement, Real mass, std::size_t i, std::size_t j,
             const Radii& radii, const NeighborRange<Real>& range) {
        visit_if_in_range<Dimension>(displacement, mass, i, j, radii, range,
                                     [&](const auto& neighbor) { add_counted(neighbor); });
    }
};

/// True for surface; a particle without neighbors is.
template <class Coefficients, class Real, int Dimension>
bool is_surface(const LineSum<Coefficients, Real, Dimension>& sum) {
    using Sum = LineSum<Coefficients, Real, Dimension>;
    return !sum.has_neighbors ||
           is_on_surface_side(Sum::First::template value<Dimension>(sum.first),
                              Sum::Second::template value<Dimension>(sum.second),
                              static_cast<Real>(Coefficients::k),
                              static_cast<Real>(Coefficients::d), Sum::Features::surface_above);
}

/// Classifies particles `begin` to `end - 1` of a neighborhood view by the line of a coefficient
/// struct of any two features, over UniformRadius or VaryingRadii: surface[i] becomes 1 or 0.
/// Returns how many are surface. Ranges that do not overlap may run concurrently.
template <class Coefficients, class Real, int Dimension, class View, class Radii>
std::size_t classify_by_features(const View& view, std::size_t begin, std::size_t end,
                                 const Radii& radii, std::uint8_t* surface) {
    const auto range = range_of(radii, Coefficients::radius_ratio);
    std::size_t found = 0;
    for (std::size_t i = begin; i < end; ++i) {
        LineSum<Coefficients, Real, Dimension> sum;
        view(i, [&](std::size_t j, const auto& displacement, Real mass) {
            sum.add(displacement, mass, i, j, radii, range);
        });
        surface[i] = static_cast<std::uint8_t>(is_surface(sum));
        found += surface[i];
    }
    return found;
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
