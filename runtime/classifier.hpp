// The surface classifier that runs inside the SPH step: a particle is taken for surface where its
// neighbor count y lies on or below a straight line over its mass offset x, y <= k x + d (2020
// paper, section 3.1). k and d come from a coefficient header that `meniscus export` writes; the
// line is fitted so that no surface particle of the training set is missed, and lets some interior
// particles through, which costs time but no correctness.
//
// Either fuse it into the density loop (FeatureSum::add for each neighbor, is_surface at the end)
// or run classify() over a neighborhood view.
#pragma once

#include "features.hpp"

#include <cstdint>
#include <cstring>
#include <type_traits>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// The line y = k x + d: y in neighbors, x without unit.
template <class Real>
struct SurfaceLine {
    Real k;
    Real d;
};

/// The line of an exported coefficient struct (see surface_coefficients.hpp for one).
template <class Coefficients, class Real>
constexpr SurfaceLine<Real> surface_line() {
    return {static_cast<Real>(Coefficients::k), static_cast<Real>(Coefficients::d)};
}

/// Tests the bits, because -ffast-math lets a compiler assume that std::isfinite is always true.
template <class Real>
bool is_finite(Real value) {
    static_assert(std::is_same_v<Real, float> || std::is_same_v<Real, double>);
    using Bits = std::conditional_t<std::is_same_v<Real, float>, std::uint32_t, std::uint64_t>;
    constexpr Bits exponent = std::is_same_v<Real, float>
                                  ? static_cast<Bits>(0x7f800000U)
                                  : static_cast<Bits>(0x7ff0000000000000ULL);
    Bits bits;
    std::memcpy(&bits, &value, sizeof bits);
    return (bits & exponent) != exponent;
}

/// True for surface. A particle without neighbors is surface, and so is one whose features are
/// not finite: a false positive costs time, a false negative corrupts the physics.
template <class Real, int Dimension>
bool is_surface(const FeatureSum<Real, Dimension>& sum, const SurfaceLine<Real>& line,
                Real support_radius) {
    if (sum.count == 0)
        return true;
    const Real x = mass_offset(sum, support_radius);
    return static_cast<Real>(sum.count) <= line.k * x + line.d || !is_finite(x);
}

/// Classifies particles `begin` to `end - 1` of a neighborhood view with the line of an exported
/// coefficient struct: surface[i] becomes 1 or 0. Returns how many are surface. Ranges that do not
/// overlap may run concurrently. Refuses coefficients of another dimension at compile time.
template <class Coefficients, class Real, int Dimension, class View>
std::size_t classify(const View& view, std::size_t begin, std::size_t end, Real support_radius,
                     std::uint8_t* surface) {
    static_assert(Coefficients::dimension == Dimension,
                  "these coefficients were trained in another dimension");
    const auto line = surface_line<Coefficients, Real>();
    const auto range = neighbor_range<Real>(support_radius, Coefficients::radius_ratio);
    std::size_t found = 0;
    for (std::size_t i = begin; i < end; ++i) {
        const auto sum = sum_features<Real, Dimension>(view, i, range);
        surface[i] = static_cast<std::uint8_t>(is_surface(sum, line, support_radius));
        found += surface[i];
    }
    return found;
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
