// One step of the fluid, whole (symplectic Euler): cell order, neighbors, densities, the
// divergence-free solve where the solver has one, forces, time step, velocities, pressure, places.
// Included by step_kernel.cpp, inside the region that is compiled for an instruction set.
#pragma once

#include "leaving.hpp"
#include "relieve.hpp"
#include "step.hpp"
#include "time_step.hpp"
#include "velocity_change.hpp"

#include <meniscus/sph/fluid/coincident.hpp>
#include <meniscus/sph/fluid/neighbor_lists.hpp>
#include <meniscus/sph/fluid/viscosity.hpp>
#include <meniscus/sph/pressure/pressure_solvers.hpp>
#include <meniscus/sph/tension/tension_models.hpp>

#include <chrono>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// Adds up the seconds since it was last asked.
class StageClock {
public:
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        const std::chrono::duration<double> passed = now - last;
        last = now;
        return passed.count();
    }

private:
    std::chrono::steady_clock::time_point last = std::chrono::steady_clock::now();
};

template <class Real, int Dimension>
class FluidStep : public Step {
public:
    FluidStep(const Scene& step_scene, const SceneParticles& particles, int threads)
        : scene(step_scene), domain(scene_domain(step_scene, particles)),
          solver_row(pressure_solvers()[pressure_solver_place(scene.pressure.solver)]),
          first_count(particles.positions.size()) {
        fluid.loop.loop.threads = threads > 0 ? threads : omp_get_max_threads();
        fluid.kernel = scene.kernel;
        fluid.units.support_radius = scene.support_radius;
        fluid.units.rest_density = scene.rest_density;
        for (int axis = 0; axis < 3; ++axis)
            fluid.units.origin[axis] = (domain[0][axis] + domain[1][axis]) / 2;
        const double h = scene.support_radius;
        fluid.mass =
            static_cast<Real>(particles.mass / (scene.rest_density * std::pow(h, Dimension)));
        fluid.spacing = scene.particle_spacing / h;
        solver = make_solver<Real, Dimension>(scene.pressure);
        const double rest_spacing = 1 / spacing_ratio(scene);
        tension =
            make_tension_model<Real, Dimension>(scene.surface_tension, fluid.units, rest_spacing);
        if (tension && scene.surface_tension.restrict_to_surface)
            detector = std::make_unique<MonteCarloTension<Real, Dimension>>(
                scene.surface_tension, fluid.units, rest_spacing);
        add_walls(particles.walls);
        add_contact_angles(particles.wall_contact_angles);
    }

    StepReport advance(SimulationState& state, double longest) override {
        StepReport report;
        StageClock clock;
        sort(state);
        report.seconds.sort = clock.lap();
        find_neighbors();
        report.seconds.neighbors = clock.lap();
        if (find_densities(fluid)) {
            part_coincident(fluid, state.positions);
            sort(state);
            find_neighbors();
            find_densities(fluid);
        }
        solver->prepare(fluid);
        report.seconds.density = clock.lap();

        const double last_step = state.time_step > 0 ? std::min(state.time_step, longest)
                                                     : time_step_for(scene, 0, 0, longest);
        const double first_speed = max_speed(0);
        fluid.keeps_rounding = is_short_step(scene, last_step, first_speed);
        const SolveReport divergence = remove_divergence(last_step);
        take_time_step(last_step);
        report.seconds.divergence = clock.lap();
        add_accelerations(report, clock);

        const double speed = max_speed(last_step);
        report.time_step = time_step_for(scene, speed, max_acceleration(), longest);
        fluid.keeps_rounding = is_short_step(scene, report.time_step, speed);
        apply_accelerations(static_cast<Real>(report.time_step));
        report.seconds.motion = clock.lap();
        fit_pressures(last_step, report.time_step);
        fit_pressures_to_speeds(report.time_step, first_speed, speed);
        const SolveReport pressure = solve_pressure(report, speed);
        report.seconds.pressure = clock.lap();

        stop_at_walls(static_cast<Real>(report.time_step));
        const double last_speed = max_speed(0);
        fit_pressures_to_speeds(report.time_step, speed, last_speed);
        move(state, report.time_step);
        report.time = state.time;
        report.max_speed = last_speed * scene.support_radius;
        report.divergence_iterations = divergence.iterations;
        report.divergence_error = divergence.error;
        report.pressure_iterations = pressure.iterations;
        report.density_error = pressure.error;
        report.converged = divergence.converged && pressure.converged;
        check(state, report);
        remove_outside(domain, Dimension, state);
        report.seconds.motion += clock.lap();
        return report;
    }

    std::size_t part_compressed(SimulationState& state) override {
        constexpr int max_rounds = 100;
        constexpr double max_density = 2;
        std::size_t compressed = 0;
        for (int round = 0; round < max_rounds; ++round) {
            sort(state);
            find_neighbors();
            if (find_densities(fluid) || count_denser(fluid, max_density) > 0)
                return compressed; // heaps are for the steps themselves
            const std::size_t denser = count_denser(fluid, round == 0 ? 1.1 : 1.01);
            compressed = round == 0 ? denser : compressed;
            if (denser == 0)
                break;
            relieve(fluid, 0.1 * scene.particle_spacing / scene.support_radius, state);
        }
        return compressed;
    }

    StepResults evaluate(SimulationState& state) override {
        sort(state);
        find_neighbors();
        find_densities(fluid);
        StepResults found;
        const double pressure_unit =
            scene.rest_density * scene.support_radius * scene.support_radius;
        const double ambient = tension ? tension->ambient_pressure() : 0;
        found.density.resize(fluid.count);
        found.pressure.resize(fluid.count);
        for (std::size_t i = 0; i < fluid.count; ++i) {
            const auto density = static_cast<double>(fluid.density[i]);
            found.density[i] = density * scene.rest_density;
            const double pressure = static_cast<double>(solver->pressure[i]) * density * density;
            // What nothing presses, as spray and all before the first step, has none.
            found.pressure[i] = pressure == 0 ? 0 : (pressure - ambient) * pressure_unit;
        }
        take_time_step(state.time_step > 0 ? state.time_step
                                           : time_step_for(scene, 0, 0, scene.duration));
        if (auto* const model = detector ? detector.get() : tension.get()) {
            model->add_accelerations(fluid);
            found.surface = model->results(fluid);
        }
        return found;
    }

private:
    Scene scene;
    Domain domain;
    const PressureSolverRow& solver_row;
    std::size_t first_count; ///< of particles, before any left the domain
    Fluid<Real, Dimension> fluid;
    std::unique_ptr<PressureSolver<Real, Dimension>> solver;
    std::unique_ptr<SurfaceTensionModel<Real, Dimension>> tension;
    /// Finds the surface for a model that does not, where forces are restricted to it.
    std::unique_ptr<SurfaceTensionModel<Real, Dimension>> detector;
    Cells<Real> cells;
    Cells<Real> wall_cells;
    std::vector<std::uint8_t> near_walls; ///< for each cell of the walls
    Real contact_density = 0;             ///< by walls, that no approach goes beyond
    ListBuffers buffers;
    ListBuffers wall_buffers;
    std::vector<std::uint32_t> cell_of;
    std::vector<std::uint32_t> order;
    std::vector<Row<Real>> rows;
    Positions sorted_places;
    std::vector<Row<Real>> accelerations_before;
    VelocityChange<Real, Dimension> pressure_change; ///< where the scene logs forces

    [[nodiscard]] Row<Real> to_row(const Place& place) const {
        const double inverse = 1 / scene.support_radius;
        Row<Real> row;
        row.x = static_cast<Real>((place[0] - fluid.units.origin[0]) * inverse);
        row.y = static_cast<Real>((place[1] - fluid.units.origin[1]) * inverse);
        if constexpr (Dimension == 3)
            row.z = static_cast<Real>((place[2] - fluid.units.origin[2]) * inverse);
        return row;
    }

    /// A place that no list of particles in such cells reaches.
    static Row<Real> far_from(const CellLayout<Real>& layout) {
        return {layout.low[0] - 10, layout.low[1] - 10, layout.low[2] - 10, 0};
    }

    /// Sorts the walls and says what each particle counts.
    void add_walls(const Positions& walls) {
        rows.resize(walls.size());
        for (std::size_t b = 0; b < walls.size(); ++b)
            rows[b] = to_row(walls[b]);
        sort_into_cells(rows.data(), rows.size(), fluid.loop.loop, cell_of, wall_cells, order);
        fluid.wall_place.resize(walls.size() + 1);
        for (std::size_t b = 0; b < walls.size(); ++b)
            fluid.wall_place[b] = rows[order[b]];
        fluid.wall_place.back() = far_from(wall_cells.layout);
        wall_cells.take_coordinates(fluid.wall_place.data(), walls.size());
        near_walls = occupied_surroundings(wall_cells);
        LaneLists lists;
        find_lists<Real, Dimension>(wall_cells, fluid.wall_place.data(), walls.size(), true,
                                    static_cast<std::uint32_t>(walls.size()), fluid.loop,
                                    wall_buffers, lists);
        contact_density = weigh_walls(fluid, lists);
    }

    /// In the order of the walls, which `order` has of add_walls().
    void add_contact_angles(const std::vector<float>& angles) {
        for (std::size_t b = 0; b < angles.size(); ++b)
            fluid.wall_contact_angle.push_back(angles[order[b]]);
    }

    void resize(std::size_t count) {
        fluid.count = count;
        fluid.place.resize(count + 1);
        fluid.velocity.resize(count + 1);
        fluid.acceleration.resize(count);
        fluid.density.resize(count);
        fluid.wall_density.resize(count);
        fluid.wall_gradient.resize(count);
        fluid.wall_ahead.resize(count);
        fluid.id.resize(count);
        solver->pressure.resize(count);
        solver->divergence.resize(count);
    }

    template <class Value>
    void reorder(std::vector<Value>& values) const {
        std::vector<Value> before(values);
        fluid.loop.each(values.size(), [&](std::size_t i) { values[i] = before[order[i]]; });
    }

    void sort(SimulationState& state) {
        const std::size_t count = state.positions.size();
        resize(count);
        rows.resize(count);
        fluid.loop.each(count, [&](std::size_t i) { rows[i] = to_row(state.positions[i]); });
        sort_into_cells(rows.data(), count, fluid.loop.loop, cell_of, cells, order);
        reorder(state.ids);
        reorder(state.positions);
        reorder(state.velocities);
        reorder(state.pressures);
        reorder(state.divergences);
        const double inverse = 1 / scene.support_radius;
        fluid.loop.each(count, [&](std::size_t i) {
            const Place& velocity = state.velocities[i];
            fluid.place[i] = rows[order[i]];
            fluid.velocity[i] = {static_cast<Real>(velocity[0] * inverse),
                                 static_cast<Real>(velocity[1] * inverse),
                                 static_cast<Real>(velocity[2] * inverse), 0};
            fluid.id[i] = state.ids[i];
            solver->pressure[i] = static_cast<Real>(state.pressures[i]);
            solver->divergence[i] = static_cast<Real>(state.divergences[i]);
        });
        take_rounding(state);
        fluid.place[count] = far_from(cells.layout);
        fluid.velocity[count] = {0, 0, 0, 1}; // a density to divide by
        cells.take_coordinates(fluid.place.data(), count);
    }

    /// What the velocities of the state have that those of the fluid have not, after short steps. A
    /// pass of its own: g++ 12 makes 0 of it where it stands beside the rounding.
    void take_rounding(const SimulationState& state) {
        fluid.rounding.resize(fluid.count);
        const double inverse = 1 / scene.support_radius;
        fluid.loop.each(fluid.count, [&](std::size_t i) {
            const Place& velocity = state.velocities[i];
            const Row<Real>& row = fluid.velocity[i];
            fluid.rounding[i] = {
                static_cast<Real>(velocity[0] * inverse - static_cast<double>(row.x)),
                static_cast<Real>(velocity[1] * inverse - static_cast<double>(row.y)),
                static_cast<Real>(velocity[2] * inverse - static_cast<double>(row.z)), 0};
        });
    }

    void find_neighbors() {
        find_lists<Real, Dimension>(cells, fluid.place.data(), fluid.count, true,
                                    static_cast<std::uint32_t>(fluid.count), fluid.loop, buffers,
                                    fluid.neighbors);
        find_lists<Real, Dimension>(wall_cells, fluid.place.data(), fluid.count, false,
                                    static_cast<std::uint32_t>(fluid.wall_place.size() - 1),
                                    fluid.loop, wall_buffers, fluid.wall_neighbors, &near_walls);
    }

    SolveReport remove_divergence(double last_step) {
        if (scene.log.forces) {
            pressure_change.clear(fluid.count);
            pressure_change.begin(fluid);
        }
        const SolveReport report = solver->remove_divergence(fluid, static_cast<Real>(last_step));
        if (scene.log.forces)
            pressure_change.end(fluid);
        return report;
    }

    /// What makes newtons of a velocity in support radii a second that a step of dt (s) gives.
    [[nodiscard]] double force_unit(double dt) const {
        const double h = scene.support_radius;
        return static_cast<double>(fluid.mass) * scene.rest_density * std::pow(h, Dimension + 1) /
               dt;
    }

    void take_time_step(double seconds) {
        if (detector)
            detector->take_time_step(seconds);
        if (tension)
            tension->take_time_step(seconds);
    }

    void add_accelerations(StepReport& report, StageClock& clock) {
        const double h = scene.support_radius;
        const Row<Real> gravity{static_cast<Real>(scene.gravity[0] / h),
                                static_cast<Real>(scene.gravity[1] / h),
                                static_cast<Real>(scene.gravity[2] / h), 0};
        fluid.loop.each(fluid.count, [&](std::size_t i) { fluid.acceleration[i] = gravity; });
        add_viscosity(scene.viscosity, fluid);
        report.seconds.viscosity = clock.lap();
        if (tension)
            add_tension(report);
        report.surface_particles = detector  ? detector->surface_particles()
                                   : tension ? tension->surface_particles()
                                             : 0;
        report.seconds.surface_tension = clock.lap();
    }

    void add_tension(StepReport& report) {
        if (!scene.log.forces) {
            add_tension_where_it_acts();
            return;
        }
        std::vector<Row<Real>> change = fluid.acceleration;
        add_tension_where_it_acts();
        fluid.loop.each(fluid.count, [&](std::size_t i) {
            change[i] = plus(fluid.acceleration[i], Real(-1), change[i]);
        });
        report.tension_forces = sizes_of<Real, Dimension>(change, force_unit(1), fluid);
    }

    void add_tension_where_it_acts() {
        if (!detector) {
            tension->add_accelerations(fluid);
            return;
        }
        accelerations_before = fluid.acceleration;
        detector->add_accelerations(fluid);
        const auto is_surface = detector->results(fluid).surface_class;
        fluid.acceleration = accelerations_before;
        tension->add_accelerations(fluid);
        fluid.loop.each(fluid.count, [&](std::size_t i) {
            if (is_surface[i] != 2)
                fluid.acceleration[i] = accelerations_before[i];
        });
    }

    /// Of v + dt a, in support radii a second.
    [[nodiscard]] double max_speed(double dt) const {
        return std::sqrt(fluid.loop.max(fluid.count, 0, [&](std::size_t i) {
            const Row<Real> velocity =
                plus(fluid.velocity[i], static_cast<Real>(dt), fluid.acceleration[i]);
            return dot_rows(velocity, velocity);
        }));
    }

    /// The largest acceleration of a particle, in support radii over s^2.
    [[nodiscard]] double max_acceleration() const {
        return std::sqrt(fluid.loop.max(fluid.count, 0, [&](std::size_t i) {
            return dot_rows(fluid.acceleration[i], fluid.acceleration[i]);
        }));
    }

    [[nodiscard]] double time_to_solve(double dt, double speed) const {
        return solver_row.iterates ? solve_time(scene, dt, speed) : dt;
    }

    SolveReport solve_pressure(StepReport& step, double speed) {
        const double dt = step.time_step;
        const double ahead = time_to_solve(dt, speed);
        if (scene.log.forces)
            pressure_change.begin(fluid);
        scale_pressures(dt / ahead); // the state keeps them as they act during a step
        const SolveReport report = solver->solve(fluid, static_cast<Real>(ahead));
        scale_pressures(ahead / dt);
        if (scene.log.forces) {
            pressure_change.end(fluid);
            step.pressure_forces = pressure_change.sizes(force_unit(dt), fluid);
        }
        return report;
    }

    void scale_pressures(double factor) {
        if (factor == 1)
            return;
        const auto share = static_cast<Real>(factor);
        fluid.loop.each(fluid.count, [&](std::size_t i) { solver->pressure[i] *= share; });
    }

    void apply_accelerations(Real dt) {
        fluid.loop.each(fluid.count,
                        [&](std::size_t i) { accelerate(fluid, i, dt, fluid.acceleration[i]); });
        if (scene.viscosity.xsph > 0) {
            smooth_velocities(static_cast<Real>(scene.viscosity.xsph), fluid, rows);
            fluid.velocity.swap(rows);
        }
    }

    /// What a longer step starts from, half of what is kept, must not move particles farther than
    /// the last step did: the pressure of an impact would throw them away, once they have come to
    /// rest and steps are long again.
    void fit_pressures(double last_step, double dt) {
        const double ratio = last_step / dt;
        if (2 * ratio * ratio < 1)
            scale_pressures(2 * ratio * ratio);
    }

    /// The same where steps stay as they are, but solves get more time since particles slow down.
    void fit_pressures_to_speeds(double dt, double last_speed, double speed) {
        fit_pressures(time_to_solve(dt, last_speed), time_to_solve(dt, speed));
    }

    /// Takes out the approach to a wall that would lead closer to it than half a spacing. Pressure
    /// keeps a fluid farther off, but a particle alone is as dense as the fluid at rest only when
    /// it is within the wall, and would pass.
    void stop_at_walls(Real dt) {
        with_kernel<Real, Dimension>(fluid.kernel, [&](auto kernel) {
            fluid.loop.each(fluid.count, [&](std::size_t i) {
                const Row<Real>& ahead = fluid.wall_ahead[i];
                if (ahead.w == 0)
                    return;
                stop_approach(i, dt, ahead, ahead.w + dt * dot_rows(fluid.velocity[i], ahead));
                // Close to a wall, density grows too fast for a gradient to tell.
                const Row<Real> place = plus(fluid.place[i], dt, fluid.velocity[i]);
                const Row<Real> there = wall_sums(fluid, i, place, kernel);
                stop_approach(i, dt, there, there.w);
            });
        });
    }

    /// Takes so much of the velocity along `gradient` out as leads to a larger `density` by walls
    /// than there may be after dt.
    void stop_approach(std::size_t i, Real dt, const Row<Real>& gradient, Real density) {
        const Real approach = dot_rows(fluid.velocity[i], gradient);
        const Real excess = density - contact_density;
        if (approach > 0 && excess > 0)
            fluid.velocity[i] =
                plus(fluid.velocity[i],
                     -std::min(excess / dt, approach) / dot_rows(gradient, gradient), gradient);
    }

    void move(SimulationState& state, double dt) {
        const double h = scene.support_radius;
        fluid.loop.each(fluid.count, [&](std::size_t i) {
            const Row<Real>& row = fluid.velocity[i];
            const Row<Real> lost = fluid.keeps_rounding ? fluid.rounding[i] : Row<Real>{};
            const Place velocity = {(static_cast<double>(row.x) + static_cast<double>(lost.x)) * h,
                                    (static_cast<double>(row.y) + static_cast<double>(lost.y)) * h,
                                    (static_cast<double>(row.z) + static_cast<double>(lost.z)) * h};
            state.velocities[i] = velocity;
            for (int axis = 0; axis < Dimension; ++axis)
                state.positions[i][axis] += dt * velocity[axis];
            state.pressures[i] = static_cast<double>(solver->pressure[i]);
            state.divergences[i] = static_cast<double>(solver->divergence[i]);
        });
        state.time += dt;
        state.time_step = dt;
        ++state.steps;
    }

    void check(const SimulationState& state, const StepReport& report) const {
        const double outside = fluid.loop.sum(fluid.count, [&](std::size_t i) {
            return is_in_domain(state.positions[i], domain, Dimension) ? 0.0 : 1.0;
        });
        const std::size_t lost = first_count - fluid.count + static_cast<std::size_t>(outside);
        const bool too_many = outside > 0 && lost > max_removed(scene.leaving, first_count);
        if (too_many || !are_finite(state) || !(report.density_error <= max_density_error))
            throw_divergence(state, report);
        if (report.max_speed * report.time_step > longest_move * scene.support_radius)
            throw_leap(state, report);
    }

    [[nodiscard]] bool are_finite(const SimulationState& state) const {
        return std::isfinite(fluid.loop.sum(fluid.count, [&](std::size_t i) {
            const Place& place = state.positions[i];
            return place[0] + place[1] + place[2];
        }));
    }

    [[noreturn]] void throw_divergence(const SimulationState& state,
                                       const StepReport& report) const;
    [[noreturn]] void throw_leap(const SimulationState& state, const StepReport& report) const;

    static constexpr double max_density_error = 0.5;
    /// Of a particle in one step, in support radii: more than any courant_factor allows.
    static constexpr double longest_move = 5;
};

template <class Real, int Dimension>
void FluidStep<Real, Dimension>::throw_divergence(const SimulationState& state,
                                                  const StepReport& report) const {
    std::uint32_t particle = std::numeric_limits<std::uint32_t>::max();
    Place place{};
    for (std::size_t i = 0; i < fluid.count; ++i)
        if (!is_in_domain(state.positions[i], domain, Dimension) && state.ids[i] < particle) {
            particle = state.ids[i];
            place = state.positions[i];
        }
    const auto densest = static_cast<std::size_t>(
        std::max_element(fluid.density.begin(), fluid.density.end()) - fluid.density.begin());
    report_divergence(particle, place, state, report.density_error,
                      {state.ids[densest], static_cast<double>(fluid.density[densest])});
}

template <class Real, int Dimension>
void FluidStep<Real, Dimension>::throw_leap(const SimulationState& state,
                                            const StepReport& report) const {
    std::size_t fastest = 0;
    const auto squared_speed = [&](std::size_t i) {
        return dot_rows(fluid.velocity[i], fluid.velocity[i]);
    };
    for (std::size_t i = 1; i < fluid.count; ++i)
        if (squared_speed(i) > squared_speed(fastest))
            fastest = i;
    report_leap(state.ids[fastest], report.max_speed * report.time_step / scene.support_radius,
                state);
}

/// The step for the scene's number type and dimension.
inline std::unique_ptr<Step> make_fluid_step(const Scene& scene, const SceneParticles& particles,
                                             int threads) {
    const bool is_double = scene.precision == Precision::float64;
    if (scene.dimension == 2) {
        if (is_double)
            return std::make_unique<FluidStep<double, 2>>(scene, particles, threads);
        return std::make_unique<FluidStep<float, 2>>(scene, particles, threads);
    }
    if (is_double)
        return std::make_unique<FluidStep<double, 3>>(scene, particles, threads);
    return std::make_unique<FluidStep<float, 3>>(scene, particles, threads);
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
