// Fluid that starts compressed, too close to a wall or to another body, moves apart before the
// first step, without velocities: pressure would throw it away.
#pragma once

#include "state.hpp"

#include <meniscus/sph/pressure/pressure_solvers.hpp>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// How many particles are denser than `limit` times the rest density.
template <class Real, int Dimension>
std::size_t count_denser(const Fluid<Real, Dimension>& fluid, double limit) {
    return static_cast<std::size_t>(
        std::count_if(fluid.density.begin(), fluid.density.end(),
                      [&](Real density) { return density > static_cast<Real>(limit); }));
}

/// Moves particles as pressure would within one step from rest, but none farther than `max_move`,
/// in support radii. Densities and neighbors of the fluid are those of the state; its velocities
/// are lost.
template <class Real, int Dimension>
void relieve(Fluid<Real, Dimension>& fluid, double max_move, SimulationState& state) {
    PressureSystem<Real, Dimension> system;
    std::vector<Real> pressure(fluid.count, 0);
    fluid.keeps_rounding = false;
    for (Row<Real>& velocity : fluid.velocity)
        velocity = {0, 0, 0, velocity.w};
    system.prepare(fluid);
    system.set_source(fluid, 1, [&](std::size_t i) { return fluid.density[i] - 1; });
    system.iterate(fluid, 1, 1e-5, {}, pressure);
    const Real longest = static_cast<Real>(max_move);
    fluid.loop.each(fluid.count, [&](std::size_t i) {
        const Row<Real> move = fluid.velocity[i];
        const Real length = std::sqrt(dot_rows(move, move));
        const double scale = fluid.units.support_radius *
                             static_cast<double>(length > longest ? longest / length : 1);
        for (int axis = 0; axis < Dimension; ++axis)
            state.positions[i][axis] += scale * static_cast<double>(axis == 0   ? move.x
                                                                    : axis == 1 ? move.y
                                                                                : move.z);
    });
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
