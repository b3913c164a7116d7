// Divergence-free SPH (Bender and Koschier 2015, 2017): two solves a step. The first takes the
// compression out of the velocities that the last step left, the second keeps the density at rest
// after the forces of this one. Both start from half the pressures of the last step, as IISPH does:
// all of them are mostly too much, and since a fluid that expands is within the limits, what is too
// much stays, and a tank never comes to rest.
#pragma once

#include "pressure_solver.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

template <class Real, int Dimension>
class Dfsph : public PressureSolver<Real, Dimension> {
public:
    using FluidType = Fluid<Real, Dimension>;
    using PressureSolver<Real, Dimension>::PressureSolver;

    static PressureSolverRow row() {
        return {"dfsph",
                {"density_error", "divergence_error", "min_iterations", "max_iterations",
                 "clip_negative", "relaxation", "accelerate"},
                true,
                any_step_is_stable};
    }

    void prepare(const FluidType& fluid) override { system.prepare(fluid); }

    SolveReport remove_divergence(FluidType& fluid, Real dt) override {
        if (this->options.divergence_error == 0)
            return {};
        for (Real& value : this->divergence) // kept times dt, since the step may change
            value *= Real(0.5) / dt;
        // Below the rest density there is room: without it, a fluid that starts or tears loose
        // would keep its holes forever.
        system.set_source(fluid, dt,
                          [&](std::size_t i) { return std::min(fluid.density[i] - 1, Real(0)); });
        const SolveReport report = system.iterate(fluid, dt, this->options.divergence_error,
                                                  this->options, this->divergence);
        for (Real& value : this->divergence)
            value *= dt;
        return report;
    }

    SolveReport solve(FluidType& fluid, Real dt) override {
        for (Real& value : this->pressure)
            value *= Real(0.5);
        system.set_source(fluid, dt, [&](std::size_t i) { return fluid.density[i] - 1; });
        return system.iterate(fluid, dt, this->options.density_error, this->options,
                              this->pressure);
    }

private:
    PressureSystem<Real, Dimension> system;
};

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
