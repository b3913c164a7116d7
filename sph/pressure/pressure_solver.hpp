// What pressure solvers have in common: each changes the velocities so that, after the particles
// moved by them, the fluid is compressed no more than its limit says. Their pressures outlive the
// step, since the next one starts from them.
//
// IISPH and DFSPH solve the same linear system, by relaxed Jacobi iterations over w = p / rho^2
// with w >= 0 where negative pressures are clipped: the compression by the velocities v is taken
// back by the pressure accelerations a(w),
//     dt (m sum_j (v_i - v_j) . grad W_ij) + dt^2 (m sum_j (a_i - a_j) . grad W_ij) = 1 - rho_i
// (Ihmsen et al. 2014, eq. 8; Bender and Koschier 2017, eqs. 11 and 12). Its diagonal is
// -dt^2 (|g_i|^2 + m^2 sum_j |grad W_ij|^2) with g_i = m sum_j grad W_ij and the walls' part.
#pragma once

#include "lattice_waves.hpp"

#include <meniscus/sph/fluid/pair_sums.hpp>
#include <meniscus/sph/scene/methods.hpp>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

struct SolveReport {
    int iterations = 0;
    double error = 0;      ///< mean compression left, relative to the rest density
    bool converged = true; ///< error within the limit
};

/// Each has, for the list (pressure_solvers.hpp), a constructor as this one's and a
/// `static PressureSolverRow row()`.
template <class Real, int Dimension>
class PressureSolver {
public:
    using FluidType = Fluid<Real, Dimension>;

    explicit PressureSolver(const PressureOptions& solver_options) : options(solver_options) {}
    virtual ~PressureSolver() = default;

    /// After neighbors and densities of a step are known.
    virtual void prepare(const FluidType& /*fluid*/) {}

    /// Takes compression out of the velocities that the fluid has, before forces; a step of dt (s)
    /// is the measure of its error.
    virtual SolveReport remove_divergence(FluidType& /*fluid*/, Real /*dt*/) { return {}; }

    /// Adds the pressure accelerations times dt to the velocities.
    virtual SolveReport solve(FluidType& fluid, Real dt) = 0;

    /// What the next solves start from; one entry a particle in the order of the fluid.
    std::vector<Real> pressure;   ///< w = p / rho^2, in rest_density h^2/s^2
    std::vector<Real> divergence; ///< the same for remove_divergence, times the time step

protected:
    PressureOptions options;
};

/// The lowest pressure that particles may have.
template <class Real>
Real min_pressure(const PressureOptions& options) {
    return options.clip_negative ? 0 : -std::numeric_limits<Real>::infinity();
}

/// For rows: no step is too long for the pressure.
inline double any_step_is_stable(const Scene& /*scene*/) {
    return std::numeric_limits<double>::infinity();
}

/// By how much the pressure of particle i changes its own density rate, over dt^2: |g_i|^2 + m^2
/// sum_j |grad W_ij|^2.
template <class Real, int Dimension>
MENISCUS_INLINE Real own_share(const Fluid<Real, Dimension>& fluid, std::size_t i) {
    VectorSum<Real, Dimension> gradient;
    Lanes<Real> squares{};
    visit_neighbors(fluid, i, [&](const NeighborLanes<Real, Dimension>& lanes) {
        const Lanes<Real> slope = slopes_of(fluid, i, lanes);
        gradient.add(slope, lanes.step);
        squares += slope * slope * lanes.distance_squared;
    });
    const Row<Real> all = plus(fluid.wall_gradient[i], fluid.mass, gradient.total());
    return dot_rows(all, all) + fluid.mass * fluid.mass * sum_of_lanes(squares);
}

/// The linear system, and relaxed Jacobi iterations on it.
template <class Real, int Dimension>
class PressureSystem {
public:
    using FluidType = Fluid<Real, Dimension>;

    /// Sets the diagonal.
    void prepare(const FluidType& fluid) {
        if (relaxation_share == 0)
            relaxation_share = stable_share(fluid);
        inverse_diagonal.resize(fluid.count);
        acceleration.assign(fluid.count + 1, {});
        source.resize(fluid.count);
        fluid.loop.each(fluid.count, [&](std::size_t i) {
            const Real sum = own_share(fluid, i);
            // Without neighbors there is nothing to push against.
            inverse_diagonal[i] = sum > static_cast<Real>(1e-6) ? 1 / sum : 0;
        });
    }

    /// Sets the source of each particle: offset(i) + dt times the compression rate of the
    /// velocities.
    template <class Offset>
    void set_source(const FluidType& fluid, Real dt, const Offset& offset) {
        fluid.loop.each(fluid.count, [&](std::size_t i) {
            source[i] = offset(i) + dt * compression_rate(fluid, fluid.velocity, i);
        });
    }

    /// Iterates until the mean compression left, source + dt^2 (rate of the accelerations), is at
    /// most `limit`; then adds dt times the accelerations to the velocities.
    SolveReport iterate(FluidType& fluid, Real dt, double limit, const PressureOptions& options,
                        std::vector<Real>& pressure) {
        SolveReport report;
        // With momentum, steps must stay below half of what is stable without.
        const double share = options.accelerate ? 0.6 : 1;
        const Real step =
            relaxation_share * static_cast<Real>(share * options.relaxation) / (dt * dt);
        const Real min = min_pressure<Real>(options);
        before = pressure;
        double age = 1; // of the momentum of the pressures, in iterations
        for (;; ++report.iterations) {
            set_accelerations(fluid, pressure);
            report.error = update(fluid, dt, step, min, pressure);
            report.converged = report.error <= limit;
            if (report.iterations >= options.max_iterations ||
                (report.converged && report.iterations >= options.min_iterations))
                break;
            if (options.accelerate)
                age = extrapolate(fluid, age, min, pressure);
        }
        fluid.loop.each(fluid.count,
                        [&](std::size_t i) { accelerate(fluid, i, dt, acceleration[i]); });
        return report;
    }

private:
    Real relaxation_share = 0; ///< of one fluid; 0: not known yet
    std::vector<Real> inverse_diagonal;
    std::vector<Real> source;
    std::vector<Real> before; ///< pressures of the last iteration, before they were extrapolated
    std::vector<Row<Real>> acceleration; ///< one more than particles

    void set_accelerations(FluidType& fluid, const std::vector<Real>& pressure) {
        fluid.loop.each(fluid.count, [&](std::size_t i) { fluid.place[i].w = pressure[i]; });
        fluid.loop.each(fluid.count,
                        [&](std::size_t i) { acceleration[i] = pressure_acceleration(fluid, i); });
    }

    /// Carries the pressures on in the direction that they moved in (Nesterov 1983), from the
    /// beginning again where the last update turned against it (O'Donoghue and Candes 2015): the
    /// number of iterations grows with the depth of the fluid in place of with its square. Returns
    /// the new age.
    double extrapolate(const FluidType& fluid, double age, Real min, std::vector<Real>& pressure) {
        const double turn = fluid.loop.sum(fluid.count, [&](std::size_t i) {
            return (fluid.place[i].w - pressure[i]) * (pressure[i] - before[i]); // w: before update
        });
        const double next = turn > 0 ? 1 : (1 + std::sqrt(1 + 4 * age * age)) / 2;
        const auto share = static_cast<Real>(turn > 0 ? 0 : (age - 1) / next);
        fluid.loop.each(fluid.count, [&](std::size_t i) {
            const Real updated = pressure[i];
            pressure[i] = std::max(updated + share * (updated - before[i]), min);
            before[i] = updated;
        });
        return next;
    }

    /// Moves the pressures; returns the mean compression that they left before.
    double update(const FluidType& fluid, Real dt, Real step, Real min,
                  std::vector<Real>& pressure) {
        const double left = fluid.loop.sum(fluid.count, [&](std::size_t i) -> Real {
            if (inverse_diagonal[i] == 0)
                return 0;
            const Real residual = source[i] + dt * dt * compression_rate(fluid, acceleration, i);
            pressure[i] = std::max(pressure[i] + step * residual * inverse_diagonal[i], min);
            return std::max(residual, Real(0));
        });
        return fluid.count == 0 ? 0 : left / static_cast<double>(fluid.count);
    }
};

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
