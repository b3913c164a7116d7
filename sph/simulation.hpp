// A running simulation: the state of a fluid and what takes it one step on. The step itself is
// compiled for several instruction sets, two number types and two dimensions (step.hpp), of which
// simulate() picks one; all instruction sets give the same bits. Particles are kept in the order of
// the cells that they lie in, which changes from step to step: `id` tells which is which.
#pragma once

#include "scene.hpp"

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace meniscus {

/// Seconds that a step spent, stage by stage.
struct StageTimes {
    double sort = 0;      ///< cell order
    double neighbors = 0; ///< lists
    double density = 0;   ///< densities and the solver's factors
    double surface_tension = 0;
    double viscosity = 0;  ///< and XSPH
    double divergence = 0; ///< divergence-free solve
    double pressure = 0;   ///< constant-density solve
    double motion = 0;     ///< time step and integration
};

struct StepReport {
    double time = 0;      ///< simulated, after the step, s
    double time_step = 0; ///< s
    int pressure_iterations = 0;
    int divergence_iterations = 0;
    double density_error = 0;          ///< mean compression that the solver left, relative
    double divergence_error = 0;       ///< likewise
    bool converged = true;             ///< false: an iteration ended at most_iterations
    double largest_speed = 0;          ///< m/s
    std::size_t surface_particles = 0; ///< of model `meniscus`
    StageTimes seconds;
};

/// What a surface-tension model found, one entry a particle; empty where it knows no surface.
struct SurfaceResults {
    std::vector<std::uint8_t> surface_class; ///< 0 interior, 1 covered, 2 surface
    std::vector<double> curvature;           ///< mean curvature, 1/m
    std::vector<Place> normal;               ///< unit vectors out of the fluid, or zero
    double area = 0;                         ///< of the surface, m^2 (in 2D m)
};

/// Sums over the fluid, in double whatever the step calculates in.
struct Balance {
    double kinetic_energy = 0;         ///< J
    double potential_energy = 0;       ///< J, of gravity, with the origin at height 0
    double surface_area = 0;           ///< m^2 (in 2D m), as SurfaceResults has it; 0 without
    std::size_t surface_particles = 0; ///< of surface class 2
    Place momentum{};                  ///< kg m/s
    double momentum_size = 0;          ///< sum of |m v|
    Place center{};                    ///< of mass, m
    double largest_speed = 0;          ///< m/s
};

/// All that the next step depends on. Arrays have one entry a particle, in the order that the step
/// keeps them in; a simulation that starts from it goes on bit for bit.
struct SimulationState {
    double time = 0;
    std::uint64_t steps = 0;
    double time_step = 0; ///< the last one, s
    std::vector<std::uint32_t> ids;
    Positions positions;
    std::vector<Place> velocities;
    std::vector<double> pressures;   ///< what the pressure solve starts from
    std::vector<double> divergences; ///< what DFSPH's divergence-free solve starts from
};

/// The simulation diverged: a value is not finite, density is out of bounds, or a particle left the
/// domain. Names the particle and says what to try.
class Divergence : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

class Simulation {
public:
    virtual ~Simulation() = default;

    /// One step, no longer than `longest` (s). Throws Divergence, then and ever after.
    virtual StepReport step(double longest) = 0;

    [[nodiscard]] virtual std::size_t size() const = 0;
    [[nodiscard]] virtual double time() const = 0;
    /// Of the state. Looks for the surface, where the scene has one that is known.
    [[nodiscard]] virtual Balance balance() const = 0;
    [[nodiscard]] virtual SimulationState state() const = 0;

    /// The state in the order of ids, with velocity, density, mass, pressure and id as point data,
    /// and what the surface-tension model finds of it. After a Divergence without density, pressure
    /// and surface.
    [[nodiscard]] virtual Snapshot snapshot() const = 0;
};

/// Starts a scene from its first state, or from a later one. `threads` 0 takes all cores; no result
/// depends on it.
std::unique_ptr<Simulation> simulate(const Scene& scene, const SceneParticles& particles,
                                     int threads);
std::unique_ptr<Simulation> simulate(const Scene& scene, const SceneParticles& particles,
                                     const SimulationState& state, int threads);

} // namespace meniscus
