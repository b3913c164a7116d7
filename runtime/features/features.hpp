// The two features of the paper (2020, section 3.1, eq. 1) in one pass without a root: how far the
// neighborhood's center of mass lies off the particle (mass_offset.hpp), and how many neighbors it
// has (neighbor_count.hpp). Both come from sums over the neighbors that any SPH step visits anyway,
// so a host can add them up in its density loop: one FeatureSum a particle, one add() a neighbor.
// Other pairs have their sums in line_features.hpp.
#pragma once

#include "../math/coordinates.hpp"
#include "../simd/vector.hpp"
#include "feature_neighbor.hpp"

#include <cmath>
#include <limits>
#include <type_traits>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// The sums over a particle's neighbors. Start from a value-initialized one. `Count` is a floating-
/// point type where support radii vary (scaled_features.hpp).
template <class Real, int Dimension, class Count = int>
struct FeatureSum {
    Real moment[axis_count<Dimension>] = {}; ///< sum of m_j (x_j - x_i) in kg m
    Real mass = 0;                           ///< sum of m_j in kg; 0: all masses are 1
    Count count = 0;                         ///< number of neighbors

    /// Adds a particle at `displacement` = x_j - x_i (m), whose squared length (m^2) the caller
    /// has, with mass m_j (kg). Outside the range (itself, too close, beyond h) it adds nothing.
    template <class Vector>
    MENISCUS_HOST_DEVICE void add(const Vector& displacement, Real distance_squared,
                                  Real neighbor_mass, const NeighborRange<Real>& range) {
        // A branch, not a mask: hosts deliver little else than neighbors, so it is predicted.
        if (!range.contains(distance_squared))
            return;
        add_counted(displacement, neighbor_mass, Count(1));
    }

    /// The same without a look at the range, for a neighbor that counts `weight` times.
    template <class Vector>
    MENISCUS_HOST_DEVICE void add_counted(const Vector& displacement, Real neighbor_mass,
                                          Count weight) {
        for (std::size_t axis = 0; axis < Dimension; ++axis)
            moment[axis] += neighbor_mass * displacement[axis];
        mass += neighbor_mass;
        count += weight;
    }

    /// The same where all particles have the same mass, which then cancels out and costs nothing.
    /// Not to be mixed with the other.
    template <class Vector>
    MENISCUS_HOST_DEVICE void add_equal_mass(const Vector& displacement, Real distance_squared,
                                             const NeighborRange<Real>& range) {
        if (!range.contains(distance_squared))
            return;
        for (std::size_t axis = 0; axis < Dimension; ++axis)
            moment[axis] += displacement[axis];
        ++count;
    }

    /// Adds a boundary particle that stands for `weight` fluid particles (neighbors/boundary.hpp),
    /// each with the mean mass of the fluid neighbors, which come first. Counts are real then.
    template <class Vector>
    MENISCUS_HOST_DEVICE void add_boundary(const Vector& displacement, Real distance_squared,
                                           Real weight, const NeighborRange<Real>& range) {
        static_assert(!std::is_integral_v<Count>, "boundary particles count by their volume: use "
                                                  "FeatureSum<Real, Dimension, Real>");
        if (!range.contains(distance_squared))
            return;
        const Real boundary_mass = weight * mean_mass();
        for (std::size_t axis = 0; axis < Dimension; ++axis)
            moment[axis] += boundary_mass * displacement[axis];
        mass = mass == 0 ? 0 : mass + boundary_mass;
        count += weight;
    }

    /// Of the neighbors so far, boundary included; 1 where all masses are.
    [[nodiscard]] MENISCUS_HOST_DEVICE Real mean_mass() const {
        return mass == 0 ? Real(1) : mass / static_cast<Real>(count);
    }

    /// What `mass` stands for: their number where all masses are 1.
    [[nodiscard]] MENISCUS_HOST_DEVICE Real total_mass() const {
        return mass == 0 ? static_cast<Real>(count) : mass;
    }
};

/// Feature x (eq. 1): |sum_j m_j (x_j - x_i)| / (h sum_j m_j), without unit, between 0 and 1; 0
/// where there is no neighbor.
template <class Real, int Dimension, class Count>
MENISCUS_HOST_DEVICE Real mass_offset(const FeatureSum<Real, Dimension, Count>& sum,
                                      Real support_radius) {
    if (sum.count == 0)
        return 0;
    using Limits = std::numeric_limits<Real>;
    const auto is_in_range = [](Real value) {
        return value >= (Limits::min)() && value <= (Limits::max)();
    };
    const Real scale = support_radius * sum.total_mass();
    const Real squared = squared_length<Real, Dimension>(sum.moment);
    if (is_in_range(scale) && is_in_range(squared))
        return std::sqrt(squared) / scale;
    // Masses so small or large that products leave the range of Real: divided first.
    Real offset[axis_count<Dimension>];
    for (std::size_t axis = 0; axis < Dimension; ++axis)
        offset[axis] = sum.moment[axis] / sum.total_mass() / support_radius;
    return std::sqrt(squared_length<Real, Dimension>(offset));
}

/// The sums over the fluid neighbors of particle i and the boundary particles around it, which a
/// BoundaryView or NoBoundary delivers.
template <class Real, int Dimension, class Count, class Boundary>
MENISCUS_INLINE FeatureSum<Real, Dimension, Real>
with_boundary(const FeatureSum<Real, Dimension, Count>& fluid, const Boundary& boundary,
              std::size_t i, const NeighborRange<Real>& range) {
    FeatureSum<Real, Dimension, Real> sum;
    for (std::size_t axis = 0; axis < Dimension; ++axis)
        sum.moment[axis] = fluid.moment[axis];
    sum.mass = fluid.mass;
    sum.count = static_cast<Real>(fluid.count);
    boundary(i, [&](std::size_t, const auto& displacement, Real weight) {
        sum.add_boundary(displacement, squared_length<Real, Dimension>(displacement), weight,
                         range);
    });
    return sum;
}

/// The sums of particle i over any neighborhood view: the plain reference.
template <class Real, int Dimension, class View>
FeatureSum<Real, Dimension> sum_features_reference(const View& view, std::size_t i,
                                                   const NeighborRange<Real>& range) {
    FeatureSum<Real, Dimension> sum;
    view(i, [&](std::size_t, const auto& displacement, Real mass) {
        sum.add(displacement, squared_length<Real, Dimension>(displacement), mass, range);
    });
    return sum;
}

/// The sums of particle i over a neighborhood view.
template <class Real, int Dimension, class View>
FeatureSum<Real, Dimension> sum_features(const View& view, std::size_t i,
                                         const NeighborRange<Real>& range) {
    return sum_features_reference<Real, Dimension>(view, i, range);
}

#if defined(__SSE2__)

/// Adds up neighbors a vector at a time.
template <class Real, int Dimension, int Stride>
struct LaneSums {
    Pack<Real> center[axis_count<Dimension>];
    Pack<Real> inner;
    Pack<Real> outer;
    Pack<Real> moment[axis_count<Dimension>];
    Pack<Real> mass;
    int count = 0;

    LaneSums(const Real* position, const NeighborRange<Real>& range)
        : inner(all_lanes<Pack<Real>>(range.inner_squared)),
          outer(all_lanes<Pack<Real>>(range.outer_squared)), mass(all_lanes<Pack<Real>>(0)) {
        for (std::size_t axis = 0; axis < Dimension; ++axis) {
            center[axis] = all_lanes<Pack<Real>>(position[axis]);
            moment[axis] = all_lanes<Pack<Real>>(0);
        }
    }

    /// Adds the neighbors at `neighbors`, one a lane; of the first lanes none where Part is set, so
    /// that only the last `taken` are added.
    template <bool Part, class Index>
    void add(const Real* positions, const Real* masses, const Index* neighbors, int taken) {
        const Real* from[lanes_in<Pack<Real>>];
        for (int lane = 0; lane < lanes_in<Pack<Real>>; ++lane)
            from[lane] = positions + static_cast<std::size_t>(neighbors[lane]) * Stride;
        Pack<Real> displacement[axis_count<Dimension>];
        load_pairs(from, displacement[0], displacement[1]);
        if constexpr (Dimension == 3)
            displacement[2] = load_each(from, 2);
        for (std::size_t axis = 0; axis < Dimension; ++axis)
            displacement[axis] = displacement[axis] - center[axis];
        Pack<Real> squared = displacement[0] * displacement[0];
        for (std::size_t axis = 1; axis < Dimension; ++axis)
            squared = squared + displacement[axis] * displacement[axis];
        MaskOf<Pack<Real>> counts = below(inner, squared) & below(squared, outer);
        if (Part)
            counts &= last_lanes<Pack<Real>>(taken);
        const unsigned bits = mask_bits(counts);
        if (bits != (1U << lanes_in<Pack<Real>>)-1) { // rare but for the last part
            for (Pack<Real>& coordinate : displacement)
                coordinate = keep(counts, coordinate);
            count += bits_set(bits);
        } else {
            count += lanes_in<Pack<Real>>;
        }
        if (masses == nullptr) {
            for (std::size_t axis = 0; axis < Dimension; ++axis)
                moment[axis] = moment[axis] + displacement[axis];
            return;
        }
        for (int lane = 0; lane < lanes_in<Pack<Real>>; ++lane)
            from[lane] = masses + static_cast<std::size_t>(neighbors[lane]);
        const Pack<Real> weight = load_each(from, 0);
        mass = mass + keep(counts, weight);
        for (std::size_t axis = 0; axis < Dimension; ++axis)
            moment[axis] = moment[axis] + weight * displacement[axis];
    }

private:
    /// Of up to four bits, from a table of 16 hexadecimal digits.
    static int bits_set(unsigned bits) {
        return static_cast<int>((0x4332322132212110ULL >> (4 * bits)) & 15U);
    }
};

/// The sums over lists in compressed rows, a vector of neighbors at a time.
template <class Real, int Dimension, int Stride, class Offset, class Index>
MENISCUS_INLINE FeatureSum<Real, Dimension>
sum_features(const CsrNeighborhood<Real, Dimension, Stride, Offset, Index>& view, std::size_t i,
             const NeighborRange<Real>& range) {
    using Sums = LaneSums<Real, Dimension, Stride>;
    constexpr int lanes = lanes_in<Pack<Real>>;
    const Index* begin = view.neighbors + view.offsets[i];
    const Index* end = view.neighbors + view.offsets[i + 1];
    if (end - begin < lanes) // too few for a vector
        return sum_features_reference<Real, Dimension>(view, i, range);
    Sums sums(view.positions + i * Stride, range);
    for (; end - begin >= lanes; begin += lanes)
        sums.template add<false>(view.positions, view.masses, begin, lanes);
    // The rest together with some that were added already, which are masked out.
    sums.template add<true>(view.positions, view.masses, end - lanes,
                            static_cast<int>(end - begin));
    FeatureSum<Real, Dimension> sum;
    for (std::size_t axis = 0; axis < Dimension; ++axis)
        sum.moment[axis] = sum_of_lanes(sums.moment[axis]);
    sum.mass = sum_of_lanes(sums.mass);
    sum.count = sums.count;
    return sum;
}

/// Adds up exact lists: two coordinates at a time, with two running sums in turn, since one alone
/// would wait for its own last addition.
template <class Real, int Dimension, int Stride, bool EqualMasses>
struct PairSums {
    Pack<Real> plane[2] = {}; ///< first two coordinates of the moment
    Real height[2] = {0, 0};  ///< the third
    Real mass[2] = {0, 0};

    MENISCUS_INLINE void add(const Real* position, Real neighbor_mass, const Real* center,
                             int which) {
        Pack<Real> offset = load_pair(position) - load_pair(center);
        if (!EqualMasses) {
            offset = offset * all_lanes<Pack<Real>>(neighbor_mass);
            mass[which] += neighbor_mass;
        }
        plane[which] = plane[which] + offset;
        if constexpr (Dimension == 3)
            height[which] += (EqualMasses ? 1 : neighbor_mass) * (position[2] - center[2]);
    }

    [[nodiscard]] FeatureSum<Real, Dimension> total() const {
        FeatureSum<Real, Dimension> sum;
        store_pair(plane[0] + plane[1], sum.moment);
        if constexpr (Dimension == 3)
            sum.moment[2] = height[0] + height[1];
        sum.mass = mass[0] + mass[1];
        return sum;
    }
};

template <bool EqualMasses, class Real, int Dimension, int Stride, class Offset, class Index>
MENISCUS_INLINE FeatureSum<Real, Dimension>
sum_all(const ExactCsrNeighborhood<Real, Dimension, Stride, Offset, Index>& view, std::size_t i) {
    PairSums<Real, Dimension, Stride, EqualMasses> sums;
    const Real* center = view.positions + i * Stride;
    const auto add = [&](Index neighbor, int which) {
        const auto j = static_cast<std::size_t>(neighbor);
        sums.add(view.positions + j * Stride, EqualMasses ? Real(1) : view.masses[j], center,
                 which);
    };
    const Index* next = view.neighbors + view.offsets[i];
    const Index* end = view.neighbors + view.offsets[i + 1];
    const auto count = static_cast<int>(end - next);
    for (; end - next >= 2; next += 2) {
        add(next[0], 0);
        add(next[1], 1);
    }
    if (next != end)
        add(next[0], 0);
    auto sum = sums.total();
    sum.count = count;
    return sum;
}

/// The sums where the lists are exact: gather and add.
template <class Real, int Dimension, int Stride, class Offset, class Index>
MENISCUS_INLINE FeatureSum<Real, Dimension>
sum_features(const ExactCsrNeighborhood<Real, Dimension, Stride, Offset, Index>& view,
             std::size_t i, const NeighborRange<Real>& /*range*/) {
    return view.masses == nullptr ? sum_all<true>(view, i) : sum_all<false>(view, i);
}

#endif

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
