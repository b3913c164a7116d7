#include "watched_run.hpp"

#include <meniscus/data/particles/neighbor_search.hpp>

#include <algorithm>
#include <cmath>

namespace meniscus {
namespace {

double length_of(const Place& vector) {
    return std::sqrt(vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2]);
}

/// Follows energy and momentum through a run.
class BalanceWatch {
public:
    BalanceWatch(const Scene& scene, RunSummary& run)
        : sigma(scene.surface_tension.model == "meniscus" ? scene.surface_tension.coefficient : 0),
          summary(run) {}

    void look(const Simulation& simulation) {
        if (simulation.time() < next)
            return;
        next = simulation.time() + 0.01;
        const Balance balance = simulation.balance();
        const double energy =
            balance.kinetic_energy + balance.potential_energy + sigma * balance.surface_area;
        if (first) {
            summary.first_energy = lowest = energy;
            first = false;
        }
        lowest = std::min(lowest, energy);
        summary.energy_rise = std::max(summary.energy_rise, energy - lowest);
        summary.max_kinetic = std::max(summary.max_kinetic, balance.kinetic_energy);
        if (balance.momentum_size > 0)
            summary.max_momentum =
                std::max(summary.max_momentum, length_of(balance.momentum) / balance.momentum_size);
    }

private:
    double sigma;
    RunSummary& summary;
    double next = 0;
    double lowest = 0;
    bool first = true;
};

} // namespace

double total_seconds(const StageTimes& seconds) {
    double sum = 0;
    for (const auto stage : all_stages)
        sum += seconds.*stage;
    return sum;
}

RunSummary watch_run(const Scene& scene, const Watch& watch, int threads) {
    return watch_run(scene, fill_scene(scene), watch, threads);
}

RunSummary watch_run(const Scene& scene, const SceneParticles& particles, const Watch& watch,
                     int threads) {
    RunSummary run;
    run.particles = particles.positions.size();
    run.wall_particles = particles.walls.size();
    BalanceWatch balance(scene, run);
    const auto simulation = simulate(scene, particles, threads);
    try {
        while (simulation->time() < scene.duration) {
            const StepReport report = simulation->step(scene.duration);
            ++run.steps;
            run.time_step += report.time_step;
            run.pressure_iterations += report.pressure_iterations;
            run.divergence_iterations += report.divergence_iterations;
            run.mean_density_error += report.density_error;
            run.max_density_error = std::max(run.max_density_error, report.density_error);
            run.unconverged += report.converged ? 0 : 1;
            run.surface_particles += static_cast<double>(report.surface_particles);
            for (const auto stage : all_stages)
                run.seconds.*stage += report.seconds.*stage;
            balance.look(*simulation);
            if (watch)
                watch(*simulation, report);
        }
    } catch (const Divergence& divergence) {
        run.failure = divergence.what();
    }
    const double steps = std::max<double>(1, static_cast<double>(run.steps));
    for (double* mean : {&run.time_step, &run.pressure_iterations, &run.divergence_iterations,
                         &run.mean_density_error, &run.surface_particles})
        *mean /= steps;
    for (const auto stage : all_stages)
        run.seconds.*stage /= steps;
    return run;
}

DropletShape droplet_shape(const SimulationState& state, double support_radius) {
    const auto count = static_cast<double>(state.positions.size());
    Place center{};
    for (const Place& place : state.positions)
        for (int axis = 0; axis < 3; ++axis)
            center[axis] += place[axis] / count;
    const auto lists = find_neighbors(state.positions, support_radius);
    DropletShape shape;
    double sum = 0;
    double squares = 0;
    for (std::size_t i = 0; i < state.positions.size(); ++i) {
        Place out;
        for (int axis = 0; axis < 3; ++axis)
            out[axis] = state.positions[i][axis] - center[axis];
        const double radius = length_of(out);
        bool outermost = radius > 0;
        for (std::size_t n = lists.offsets[i]; outermost && n < lists.offsets[i + 1]; ++n) {
            const Place& other = state.positions[lists.neighbors[n]];
            double along = 0;
            double squared = 0;
            for (int axis = 0; axis < 3; ++axis) {
                const double step = other[axis] - state.positions[i][axis];
                along += step * out[axis] / radius;
                squared += step * step;
            }
            // In a cone of 45 degrees about the ray.
            outermost = along <= 0 || along * along <= squared / 2;
        }
        if (!outermost)
            continue;
        ++shape.outermost;
        sum += radius;
        squares += radius * radius;
    }
    const double outermost = std::max<double>(1, static_cast<double>(shape.outermost));
    shape.radius = sum / outermost;
    shape.deviation = std::sqrt(std::max(0.0, squares / outermost - shape.radius * shape.radius));
    return shape;
}

double mean_speed(const SimulationState& state) {
    double sum = 0;
    for (const Place& velocity : state.velocities)
        sum += velocity[0] * velocity[0] + velocity[1] * velocity[1] + velocity[2] * velocity[2];
    return std::sqrt(sum / std::max<double>(1, static_cast<double>(state.velocities.size())));
}

} // namespace meniscus
