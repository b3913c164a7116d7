// Sums over the neighbors of a particle, a vector of neighbors at a time, for rival methods: they
// are to be written as well as the runtime's own loop (runtime/features/features.hpp), so they
// fetch neighbors as it does, into vectors of 16 bytes. Lists are filled up with the particle
// itself, which adds nothing to a sum of terms that vanish with the distance.
#pragma once

#include "support/fluid_state.hpp"

#include <meniscus/runtime/simd/vector.hpp>

namespace meniscus {

/// Some neighbors of a particle, of which the last may be the particle itself.
template <class Real, int Dimension>
struct PairPack {
    Pack<Real> step[Dimension]; ///< x_j - x_i in m
    Pack<Real> squared;         ///< length of the step, in m^2
    const std::uint32_t* index; ///< one a lane
};

/// The coordinates at the particles of a list.
template <class Real, int Dimension>
MENISCUS_INLINE void fetch_places(const Real* positions, const std::uint32_t* index,
                                  Pack<Real> (&place)[Dimension]) {
    const Real* from[lanes_in<Pack<Real>>];
    for (int lane = 0; lane < lanes_in<Pack<Real>>; ++lane)
        from[lane] = positions + std::size_t{index[lane]} * Dimension;
    load_pairs(from, place[0], place[1]);
    if constexpr (Dimension == 3)
        place[2] = load_each(from, 2);
}

/// Calls visit(PairPack) until each neighbor of particle i has had its turn.
template <int Dimension, class Real, class Visit>
MENISCUS_INLINE void visit_packs(const FluidState<Real>& state, std::size_t i, Visit&& visit) {
    constexpr int size = lanes_in<Pack<Real>>;
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
