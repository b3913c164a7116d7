// Implicit incompressible SPH (Ihmsen et al. 2014): one solve a step, which starts from half the
// pressures of the last.
#pragma once

#include "pressure_solver.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

template <class Real, int Dimension>
class Iisph : public PressureSolver<Real, Dimension> {
public:
    using FluidType = Fluid<Real, Dimension>;
    using PressureSolver<Real, Dimension>::PressureSolver;

    static PressureSolverRow row() {
        return {"iisph",
                {"density_error", "min_iterations", "max_iterations", "clip_negative", "relaxation",
                 "accelerate"},
                true,
                any_step_is_stable};
    }

    void prepare(const FluidType& fluid) override { system.prepare(fluid); }

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
