// Predictive-corrective incompressible SPH (Solenthaler and Pajarola 2009): pressures grow with the
// density that they would leave, which is summed up anew at the predicted places in each iteration.
#pragma once

#include "pressure_solver.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

template <class Real, int Dimension>
class Pcisph : public PressureSolver<Real, Dimension> {
public:
    using FluidType = Fluid<Real, Dimension>;
    using PressureSolver<Real, Dimension>::PressureSolver;

    static PressureSolverRow row() {
        return {"pcisph",
                {"density_error", "min_iterations", "max_iterations", "clip_negative"},
                true,
                any_step_is_stable};
    }

    SolveReport solve(FluidType& fluid, Real dt) override {
        SolveReport report;
        std::fill(this->pressure.begin(), this->pressure.end(), Real(0));
        acceleration.assign(fluid.count, {});
        if (relaxation_share == 0)
            relaxation_share = stable_share(fluid);
        with_kernel<Real, Dimension>(fluid.kernel, [&](auto kernel) {
            // eq. 8; on a lattice sum_j grad W vanishes
            const auto gradients =
                static_cast<Real>(lattice_gradients<Real, Dimension>(kernel, fluid.spacing));
            const Real rest = fluid.mass * fluid.mass * gradients;
            const Real step = relaxation_share * relaxation / (2 * dt * dt * rest);
            // Beside walls, whose density grows faster, a particle's own share is larger.
            share.resize(fluid.count);
            fluid.loop.each(fluid.count, [&](std::size_t i) {
                share[i] = rest / std::max(rest, own_share(fluid, i));
            });
            for (;; ++report.iterations) {
                predict(fluid, dt);
                report.error = update(fluid, kernel, step);
                report.converged = report.error <= this->options.density_error;
                if (report.iterations >= this->options.max_iterations ||
                    (report.converged && report.iterations >= this->options.min_iterations))
                    break;
                fluid.loop.each(fluid.count,
                                [&](std::size_t i) { fluid.place[i].w = this->pressure[i]; });
                fluid.loop.each(fluid.count, [&](std::size_t i) {
                    acceleration[i] = pressure_acceleration(fluid, i);
                });
            }
        });
        fluid.loop.each(fluid.count,
                        [&](std::size_t i) { accelerate(fluid, i, dt, acceleration[i]); });
        return report;
    }

private:
    /// Of the factor that the paper takes from a lattice at rest. At a free surface under surface
    /// tension particles lie closer, where all of it overshoots and throws some out.
    static constexpr Real relaxation = 0.5;

    Real relaxation_share = 0; ///< 0: not known yet
    /// What one iteration takes back at most: a place that is predicted within a wall, whose
    /// density grows fast, asks for a pressure that would throw the particle away.
    static constexpr Real max_excess = Real(0.05);

    std::vector<Real> share; ///< of the step of the pressures, for each particle
    std::vector<Row<Real>> acceleration;
    std::vector<Row<Real>> predicted; ///< places; one more than particles

    void predict(const FluidType& fluid, Real dt) {
        predicted.resize(fluid.count + 1);
        predicted[fluid.count] = fluid.place[fluid.count];
        fluid.loop.each(fluid.count, [&](std::size_t i) {
            const Row<Real> velocity = plus(fluid.velocity[i], dt, acceleration[i]);
            predicted[i] = plus(fluid.place[i], dt, velocity);
        });
    }

    /// Moves the pressures by the compression at the predicted places; returns its mean.
    template <class Kernel>
    double update(const FluidType& fluid, const Kernel& kernel, Real step) {
        const Real min = min_pressure<Real>(this->options);
        const double left = fluid.loop.sum(fluid.count, [&](std::size_t i) -> Real {
            Lanes<Real> sum = kernel.value(Lanes<Real>{}) * Lanes<Real>{1, 0, 0, 0, 0, 0, 0, 0};
            visit_lists<Real, Dimension>(predicted.data(), predicted[i], fluid.neighbors, i,
                                         [&](const NeighborLanes<Real, Dimension>& lanes) {
                                             sum += kernel.value(lanes.distance_squared);
                                         });
            const Real excess =
                fluid.mass * sum_of_lanes(sum) + wall_sums(fluid, i, predicted[i], kernel).w - 1;
            this->pressure[i] =
                std::max(this->pressure[i] + share[i] * step * std::min(excess, max_excess), min);
            return std::max(excess, Real(0));
        });
        return fluid.count == 0 ? 0 : left / static_cast<double>(fluid.count);
    }
};

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
