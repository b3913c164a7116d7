// Running scenes to an end and summing up how it went, for the tables of docs/simulation.md.
#pragma once

#include <meniscus/sph/step/simulation.hpp>

#include <functional>
#include <string>

namespace meniscus {

/// How a run went. Errors and iterations are those of the solver (StepReport).
struct RunSummary {
    std::size_t particles = 0;
    std::size_t wall_particles = 0;
    std::uint64_t steps = 0;
    double time_step = 0;             ///< mean, s
    double pressure_iterations = 0;   ///< mean a step
    double divergence_iterations = 0; ///< likewise
    double mean_density_error = 0;    ///< over the steps
    double max_density_error = 0;     ///< of a step
    std::uint64_t unconverged = 0;    ///< steps
    double surface_particles = 0;     ///< mean
    StageTimes seconds;               ///< mean a step
    /// Largest rise of the energy (kinetic, of gravity, of the surface) above its lowest value so
    /// far, J, looked at a hundred times a second.
    double energy_rise = 0;
    double first_energy = 0; ///< J
    double max_kinetic = 0;  ///< J
    double max_momentum = 0; ///< |sum m v| over sum |m v|
    std::string failure;     ///< why it ended early; empty: it did not
};

/// Sees the simulation after each step.
using Watch = std::function<void(const Simulation&, const StepReport&)>;

/// Runs the scene for its duration; a divergence ends it and is noted. 0 threads: all cores.
RunSummary watch_run(const Scene& scene, const Watch& watch = {}, int threads = 0);

/// The same from a first state that need not be the scene's.
RunSummary watch_run(const Scene& scene, const SceneParticles& particles, const Watch& watch,
                     int threads);

/// The stages of a step, in the order of the tables.
inline constexpr double StageTimes::*all_stages[] = {
    &StageTimes::sort,       &StageTimes::neighbors,       &StageTimes::density,
    &StageTimes::divergence, &StageTimes::surface_tension, &StageTimes::viscosity,
    &StageTimes::pressure,   &StageTimes::motion};

double total_seconds(const StageTimes& seconds);

/// Mean and standard deviation of the distance from the center of mass of the outermost particles
/// of one droplet: those with no neighbor in the cone of 45 degrees that points outward.
struct DropletShape {
    double radius = 0;
    double deviation = 0;
    std::size_t outermost = 0;
};
DropletShape droplet_shape(const SimulationState& state, double support_radius);

/// Root of the mean squared speed, m/s.
double mean_speed(const SimulationState& state);

} // namespace meniscus
