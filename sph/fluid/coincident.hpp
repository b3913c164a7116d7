// Particles in one place: no pressure parts them, since no direction leads from one to the other,
// so that they would stay one heavy particle for good. The step moves them apart by a hundredth of
// a support radius, each pair in a direction of its own and by opposite ways, so that their center
// of mass stays; pressure does the rest, where the fluid is compressed.
#pragma once

#include "fluid.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// Numbers in [-1, 1) that belong to two ids.
inline std::array<double, 3> numbers_of(std::uint32_t low, std::uint32_t high) {
    std::uint64_t state = (static_cast<std::uint64_t>(low) << 32 | high) + 1;
    std::array<double, 3> numbers{};
    for (double& number : numbers) { // Steele et al. 2014 (SplitMix64)
        state += 0x9e3779b97f4a7c15U;
        std::uint64_t mixed = (state ^ state >> 30) * 0xbf58476d1ce4e5b9U;
        mixed = (mixed ^ mixed >> 27) * 0x94d049bb133111ebU;
        number = static_cast<double>((mixed ^ mixed >> 31) >> 11) * 0x1p-52 - 1;
    }
    return numbers;
}

/// Moves the places, in m and in the order of the fluid, of particles that are in one place as the
/// fluid has them.
template <class Real, int Dimension>
void part_coincident(const Fluid<Real, Dimension>& fluid, Positions& places) {
    const double distance = 0.01 * fluid.units.support_radius;
    fluid.loop.each(fluid.count, [&](std::size_t i) {
        for (std::uint32_t at = 0; at < fluid.neighbors.count[i]; ++at) {
            const std::uint32_t j = fluid.neighbors.begin[i][at];
            const Row<Real> step = plus(fluid.place[i], Real(-1), fluid.place[j]);
            if (!(dot_rows(step, step) < std::numeric_limits<Real>::min()))
                continue;
            const std::uint32_t own = fluid.id[i];
            const std::uint32_t other = fluid.id[j];
            const auto direction = numbers_of(std::min(own, other), std::max(own, other));
            for (int axis = 0; axis < Dimension; ++axis)
                places[i][axis] += (own < other ? -distance : distance) * direction[axis];
        }
    });
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
