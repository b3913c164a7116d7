// Weakly compressible SPH (Becker and Teschner 2007): the pressure is that of an equation of state,
// p = rho_0 c^2 / 7 ((rho / rho_0)^7 - 1), with c the speed of sound. No iteration and no limit on
// the compression, which falls with c, as does the time step that is stable.
#pragma once

#include "pressure_solver.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

template <class Real, int Dimension>
class Wcsph : public PressureSolver<Real, Dimension> {
public:
    using FluidType = Fluid<Real, Dimension>;
    using PressureSolver<Real, Dimension>::PressureSolver;

    static PressureSolverRow row() {
        return {"wcsph", {"clip_negative", "sound_speed"}, false, longest_stable_step};
    }

    /// In which sound gets no farther than 0.4 h.
    static double longest_stable_step(const Scene& scene) {
        return 0.4 * scene.support_radius / scene.pressure.sound_speed;
    }

    SolveReport solve(FluidType& fluid, Real dt) override {
        const double speed = this->options.sound_speed / fluid.units.support_radius;
        const Real min = min_pressure<Real>(this->options);
        const auto stiffness = static_cast<Real>(speed * speed / 7);
        fluid.loop.each(fluid.count, [&](std::size_t i) {
            const Real square = fluid.density[i] * fluid.density[i];
            const Real pressure = stiffness * (square * square * square * fluid.density[i] - 1);
            fluid.place[i].w = this->pressure[i] = std::max(pressure / square, min);
        });
        fluid.loop.each(fluid.count, [&](std::size_t i) {
            accelerate(fluid, i, dt, pressure_acceleration(fluid, i));
        });
        SolveReport report;
        report.error = fluid.count == 0 ? 0 : fluid.loop.sum(fluid.count, [&](std::size_t i) {
            return std::max(fluid.density[i] - 1, Real(0));
        }) / static_cast<double>(fluid.count);
        return report;
    }
};

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
