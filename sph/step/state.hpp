// What a step takes and gives: the state of a simulation, a report of the step, and what there is
// to know of each particle beside the state. Particles are kept in the order of the cells that they
// lie in, which changes from step to step: `ids` tells which is which.
#pragma once

#include <meniscus/sph/tension/surface_results.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace meniscus {

/// All that the next step depends on. Arrays have one entry a particle, in the order that the step
/// keeps them in; a simulation that starts from it goes on bit for bit.
struct SimulationState {
    double time = 0;
    std::uint64_t steps = 0;
    double time_step = 0;           ///< the last one, s
    std::vector<std::uint32_t> ids; ///< places in the first state
    Positions positions;
    std::vector<Place> velocities;
    std::vector<double> pressures;   ///< what the pressure solve starts from
    std::vector<double> divergences; ///< what DFSPH's divergence-free solve starts from
};

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

/// Size of the forces on the particles, over all of them, N.
struct ForceSizes {
    double mean = 0;
    double deviation = 0;
};

struct StepReport {
    double time = 0;      ///< simulated, after the step, s
    double time_step = 0; ///< s
    int pressure_iterations = 0;
    int divergence_iterations = 0;
    double density_error = 0;          ///< mean compression that the solver left, relative
    double divergence_error = 0;       ///< likewise
    bool converged = true;             ///< false: an iteration ended at max_iterations
    double max_speed = 0;              ///< m/s
    std::size_t surface_particles = 0; ///< of surface class 2, where the surface is known
    ForceSizes tension_forces;         ///< by surface tension, where the scene logs forces
    ForceSizes pressure_forces;        ///< by both solves together, likewise
    StageTimes seconds;
};

/// What there is to know of each particle beside the state, in the state's order.
struct StepResults {
    std::vector<double> density;  ///< kg/m^3 (in 2D kg/m^2)
    std::vector<double> pressure; ///< of the last solve, Pa (in 2D N/m); 0 before the first
    SurfaceResults surface;
};

} // namespace meniscus
