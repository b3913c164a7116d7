// How a host shows its neighbor lists: as a view, never a copy. A view is anything that can be
// called as `view(i, visit)` and calls `visit(j, displacement, mass)` once for each neighbor j of
// particle i, where `displacement` is x_j - x_i in metres (anything that has operator[] for the
// coordinates) and `mass` is m_j. Because the displacement is the host's own, periodic images,
// ghosts and several point sets need nothing from us. A view may also deliver i itself and
// particles beyond the support radius: NeighborRange sorts them out. CsrNeighborhood is the view
// for the common case of offsets and indices.
#pragma once

#include "../math/coordinates.hpp"
#include "../simd/instruction_set.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// Pair distances within this fraction of a limit count as at the limit. On the lattices that
/// scenes start from, six neighbors stand at exactly h = 2 spacings, and without a band the last
/// bit of a coordinate decides which of them count. Wide enough for float coordinates up to about
/// 80 support radii from the origin; narrow enough that in developed flow a pair inside it is rare.
inline constexpr double neighbor_band = 1e-5;

/// The bits of a floating-point number as an unsigned integer. For numbers that are not negative
/// their order is that of the numbers; infinity and NaN come last.
template <class Real>
MENISCUS_HOST_DEVICE auto bits_of(Real value) {
    static_assert(std::is_same_v<Real, float> || std::is_same_v<Real, double>);
    std::conditional_t<std::is_same_v<Real, float>, std::uint32_t, std::uint64_t> bits;
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
}

/// True for positive numbers but infinity; by bits, so that it holds for NaN even under
/// -ffast-math.
template <class Real>
MENISCUS_HOST_DEVICE bool is_positive_and_finite(Real value) {
    using Limits = std::numeric_limits<Real>;
    return bits_of(value) - 1 < bits_of(Limits::infinity()) - 1;
}

/// Which distances make a neighbor: farther than the radius at which its sphere (r2) still lies
/// inside the particle's own (r1 - r2; closer ones cover nothing, so hundreds of particles in one
/// place are all surface) and closer than the support radius, each by the neighbor band.
template <class Real>
struct NeighborRange {
    Real inner_squared; ///< m^2, not negative
    Real outer_squared; ///< m^2

    /// True for distances strictly between the limits. One comparison of integers in place of two
    /// of numbers, and right for NaN even under -ffast-math.
    [[nodiscard]] MENISCUS_HOST_DEVICE bool contains(Real distance_squared) const {
        const auto above_inner = bits_of(distance_squared) - bits_of(inner_squared) - 1;
        return above_inner < bits_of(outer_squared) - bits_of(inner_squared) - 1;
    }
};

/// The range for a support radius r1 = h (m) and r2 = radius_ratio * h (2020 paper, section 3.2;
/// 0.8 in its implementation).
template <class Real>
constexpr NeighborRange<Real> neighbor_range(double support_radius, double radius_ratio) {
    const double inner = (1 - radius_ratio) * support_radius * (1 + neighbor_band);
    const double outer = support_radius * (1 - neighbor_band);
    return {static_cast<Real>(inner * inner), static_cast<Real>(outer * outer)};
}

/// View over neighbor lists in compressed rows: the neighbors of i are neighbors[offsets[i]] to
/// neighbors[offsets[i + 1] - 1]. `positions` holds `Stride` values a particle, of which the first
/// `Dimension` are coordinates in m; `masses` in kg, nullptr where all are equal.
template <class Real, int Dimension, int Stride = Dimension, class Offset = std::size_t,
          class Index = std::uint32_t>
struct CsrNeighborhood {
    const Real* positions;
    const Real* masses;
    const Offset* offsets;
    const Index* neighbors;

    template <class Visit>
    void operator()(std::size_t i, Visit&& visit) const {
        const Real* center = positions + i * Stride;
        for (Offset n = offsets[i]; n < offsets[i + 1]; ++n) {
            const auto j = static_cast<std::size_t>(neighbors[n]);
            Coordinates<Real, Dimension> displacement;
            for (std::size_t axis = 0; axis < Dimension; ++axis)
                displacement[axis] = positions[j * Stride + axis] - center[axis];
            visit(j, displacement, masses != nullptr ? masses[j] : Real(1));
        }
    }
};

/// The same lists with a promise: all that they hold lies within the NeighborRange, as when the
/// search was made with its outer limit and no two particles are as close as its inner one. Then
/// nothing is tested, which is faster (docs/speed.md).
template <class Real, int Dimension, int Stride = Dimension, class Offset = std::size_t,
          class Index = std::uint32_t>
struct ExactCsrNeighborhood : CsrNeighborhood<Real, Dimension, Stride, Offset, Index> {};

/// A view of a fluid of several phases that delivers neighbors of the same phase only: each phase
/// then has a surface of its own where it meets another. `phases` holds one number a particle.
template <class View, class Phase>
struct SamePhase {
    View view;
    const Phase* phases;

    template <class Visit>
    void operator()(std::size_t i, Visit&& visit) const {
        view(i, [&](std::size_t j, const auto& displacement, auto mass) {
            if (phases[j] == phases[i])
                visit(j, displacement, mass);
        });
    }
};

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
