// Sums over the neighbors of a particle, a vector of neighbors at a time, for rival methods: they
// are to be written as well as the runtime's own loop (runtime/features.hpp), so they fetch
// neighbors as it does, into vectors of 16 bytes. Lists are filled up with the particle itself,
// which adds nothing to a sum of terms that vanish with the distance.
#pragma once

#include "comparison/fluid_state.hpp"

#include <cmath>

namespace meniscus {

template <class Real>
struct PackType;
template <>
struct PackType<float> {
    using Type = float __attribute__((vector_size(16)));
};
template <>
struct PackType<double> {
    using Type = double __attribute__((vector_size(16)));
};

/// Four floats or two doubles. Arithmetic is the compiler's; a comparison gives a mask, mask ? a :
/// b picks.
template <class Real>
using Pack = typename PackType<Real>::Type;

template <class Real>
inline constexpr int pack_size = static_cast<int>(16 / sizeof(Real));

template <class Real>
MENISCUS_INLINE Pack<Real> pack_of(Real value) {
    return Pack<Real>{} + value;
}

template <class Real>
MENISCUS_INLINE Pack<Real> square_root(Pack<Real> a) {
    for (int lane = 0; lane < pack_size<Real>; ++lane) // one instruction
        a[lane] = std::sqrt(a[lane]);
    return a;
}

template <class Real>
MENISCUS_INLINE Real sum_of(const Pack<Real>& a) {
    Real sum = a[0] + a[1];
    if constexpr (pack_size<Real> == 4)
        sum = (a[0] + a[2]) + (a[1] + a[3]);
    return sum;
}

/// The values at the particles of a list.
template <class Real>
MENISCUS_INLINE Pack<Real> gather(const Real* values, const std::uint32_t* index) {
    if constexpr (pack_size<Real> == 4)
        return Pack<Real>{values[index[0]], values[index[1]], values[index[2]], values[index[3]]};
    else
        return Pack<Real>{values[index[0]], values[index[1]]};
}

/// Some neighbors of a particle, of which the last may be the particle itself.
template <class Real, int Dimension>
struct PairPack {
    Pack<Real> step[Dimension]; ///< x_j - x_i in m
    Pack<Real> squared;         ///< length of the step, in m^2
    const std::uint32_t* index; ///< pack_size of them
};

#if defined(__SSE2__)
/// The coordinates at the particles of a list.
template <class Real, int Dimension>
MENISCUS_INLINE void fetch_places(const Real* positions, const std::uint32_t* index,
                                  Pack<Real> (&place)[Dimension]) {
    using Lanes = typename LanesOf<Real>::Type;
    const Real* from[Lanes::count];
    for (int lane = 0; lane < Lanes::count; ++lane)
        from[lane] = positions + std::size_t{index[lane]} * Dimension;
    Lanes first, second;
    Lanes::pairs_of(from, first, second);
    place[0] = first.value;
    place[1] = second.value;
    if constexpr (Dimension == 3)
        place[2] = Lanes::singles_of(from, 2).value;
}
#else
template <class Real, int Dimension>
MENISCUS_INLINE void fetch_places(const Real* positions, const std::uint32_t* index,
                                  Pack<Real> (&place)[Dimension]) {
    for (int axis = 0; axis < Dimension; ++axis)
        for (int lane = 0; lane < pack_size<Real>; ++lane)
            place[axis][lane] = positions[std::size_t{index[lane]} * Dimension + axis];
}
#endif

/// Calls visit(PairPack) until each neighbor of particle i has had its turn.
template <int Dimension, class Real, class Visit>
MENISCUS_INLINE void visit_packs(const FluidState<Real>& state, std::size_t i, Visit&& visit) {
    constexpr int size = pack_size<Real>;
    const Real* positions = state.positions.data();
    const Real* own = positions + i * Dimension;
    const auto fetch = [&](const std::uint32_t* index) {
        PairPack<Real, Dimension> pairs;
        pairs.index = index;
        fetch_places<Real, Dimension>(positions, index, pairs.step);
        pairs.squared = Pack<Real>{};
        for (int axis = 0; axis < Dimension; ++axis) {
            pairs.step[axis] = pairs.step[axis] - own[axis];
            pairs.squared += pairs.step[axis] * pairs.step[axis];
        }
        visit(pairs);
    };
    const std::uint32_t* next = state.lists.neighbors.data() + state.lists.offsets[i];
    const std::uint32_t* end = state.lists.neighbors.data() + state.lists.offsets[i + 1];
    for (; end - next >= size; next += size)
        fetch(next);
    if (next == end)
        return;
    std::uint32_t rest[size];
    for (std::uint32_t& index : rest)
        index = next < end ? *next++ : static_cast<std::uint32_t>(i);
    fetch(rest);
}

} // namespace meniscus
