// A running simulation: the state of a fluid and what takes it one step on. The step itself is
// compiled for several instruction sets, two number types and two dimensions (step.hpp), of which
// simulate() picks one; all instruction sets give the same bits.
#pragma once

#include "divergence.hpp"

#include <memory>

namespace meniscus {

/// Sums over the fluid, in double whatever the step calculates in.
struct Balance {
    std::size_t particles = 0;         ///< fewer than at the start where some left the domain
    double kinetic_energy = 0;         ///< J
    double potential_energy = 0;       ///< J, of gravity, with the origin at height 0
    double surface_area = 0;           ///< m^2 (in 2D m), as SurfaceResults has it; 0 without
    std::size_t surface_particles = 0; ///< of surface class 2
    Place momentum{};                  ///< kg m/s
    double momentum_size = 0;          ///< sum of |m v|
    Place center{};                    ///< of mass, m
    double max_speed = 0;              ///< m/s
    double mean_speed = 0;             ///< of |v| over the particles, m/s
};

class Simulation {
public:
    virtual ~Simulation() = default;

    /// One step, no longer than `longest` (s). Throws Divergence, then and ever after.
    virtual StepReport step(double longest) = 0;

    /// How many particles of the first state were moved since they were more than a tenth denser
    /// than at rest (Step::part_compressed).
    [[nodiscard]] virtual std::size_t parted() const = 0;
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
