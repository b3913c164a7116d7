// Sums over the neighbors of a particle, eight neighbors at a time, for the methods that rest on
// gradients of a kernel: they are to run as fast as this project's own step, so they use its lanes.
// Lists are filled up with the particle itself, which adds nothing to a sum of terms that vanish
// with the distance.
#pragma once

#include "comparison/fluid_state.hpp"

#include <meniscus/sph/kernels.hpp>
#include <meniscus/sph/lanes.hpp>

namespace meniscus {

/// The positions as rows, from which lanes are fetched fastest. A solver keeps them so; here they
/// are copied anew at each detection, which costs about one neighbor a particle.
template <class Real, class Loop>
void copy_rows(const FluidState<Real>& state, const Loop& loop, std::vector<Row<Real>>& rows) {
    rows.resize(state.size());
    const Real* from = state.positions.data();
    loop(state.size(), [&](std::size_t begin, std::size_t end, int) {
        if (state.dimension == 3)
            for (std::size_t i = begin; i < end; ++i)
                rows[i] = {from[3 * i], from[3 * i + 1], from[3 * i + 2], 0};
        else
            for (std::size_t i = begin; i < end; ++i)
                rows[i] = {from[2 * i], from[2 * i + 1], 0, 0};
    });
}

/// Eight neighbors of a particle, of which the last may be the particle itself.
template <class Real, int Dimension>
struct PairLanes {
    Lanes<Real> step[Dimension]; ///< x_j - x_i in m
    Lanes<Real> squared;         ///< length of the step, in m^2
    const std::uint32_t* index;  ///< eight
};

/// Calls visit(PairLanes) until each neighbor of particle i has had its turn.
template <int Dimension, class Real, class Visit>
MENISCUS_INLINE void visit_eights(const Row<Real>* rows, const NeighborLists& lists, std::size_t i,
                                  Visit&& visit) {
    const Row<Real> own = rows[i];
    const auto fetch = [&](const std::uint32_t* index) {
        const RowLanes<Real> other = gather_rows(rows, index);
        PairLanes<Real, Dimension> pairs;
        pairs.index = index;
        pairs.step[0] = other.x - own.x;
        pairs.step[1] = other.y - own.y;
        pairs.squared = pairs.step[0] * pairs.step[0] + pairs.step[1] * pairs.step[1];
        if constexpr (Dimension == 3) {
            pairs.step[2] = other.z - own.z;
            pairs.squared += pairs.step[2] * pairs.step[2];
        }
        visit(pairs);
    };
    const std::uint32_t* next = lists.neighbors.data() + lists.offsets[i];
    const std::uint32_t* end = lists.neighbors.data() + lists.offsets[i + 1];
    for (; end - next >= lane_count; next += lane_count)
        fetch(next);
    if (next == end)
        return;
    std::uint32_t rest[lane_count];
    for (std::uint32_t& index : rest)
        index = next < end ? *next++ : static_cast<std::uint32_t>(i);
    fetch(rest);
}

} // namespace meniscus
