// One step of a simulation, over a state in SI units and double. What calculates it is compiled for
// several instruction sets (step_*.cpp), two number types and two dimensions; make_step() picks
// one.
#pragma once

#include "simulation.hpp"

#include <memory>

namespace meniscus {

/// What there is to know of each particle beside the state, in the state's order.
struct StepResults {
    std::vector<double> density;  ///< kg/m^3 (in 2D kg/m^2)
    std::vector<double> pressure; ///< of the last solve, Pa (in 2D N/m); 0 before the first
    SurfaceResults surface;
};

class Step {
public:
    virtual ~Step() = default;

    /// Sorts the state's particles by cell, and moves them and their velocities on by one step of
    /// at most `longest` (s). Throws Divergence.
    virtual StepReport advance(SimulationState& state, double longest) = 0;

    /// Sorts the state's particles by cell, as advance() does, and looks at them without moving
    /// them. Steps that follow are not affected.
    virtual StepResults evaluate(SimulationState& state) = 0;
};

/// A particle and the density around it when the step began, over the rest density.
struct DensePlace {
    std::uint32_t particle = 0;
    double density = 0;
};

/// Throws Divergence for the particle of that id that left the domain or the numbers, or, where no
/// particle did (the largest id there is), for the mean density error. Names the densest place too
/// where particles lie in one another there.
[[noreturn]] void report_divergence(std::uint32_t particle, const Place& place,
                                    const SimulationState& state, double density_error,
                                    const DensePlace& densest);

/// Throws Divergence for the particle of that id that moved so many support radii in one step.
[[noreturn]] void report_leap(std::uint32_t particle, double moved, const SimulationState& state);

/// The one for this machine.
std::unique_ptr<Step> make_step(const Scene& scene, const SceneParticles& particles, int threads);

/// Those for each instruction set; for the tests. Empty where this machine lacks it.
std::unique_ptr<Step> make_step_baseline(const Scene& scene, const SceneParticles& particles,
                                         int threads);
std::unique_ptr<Step> make_step_avx2(const Scene& scene, const SceneParticles& particles,
                                     int threads);
std::unique_ptr<Step> make_step_avx512(const Scene& scene, const SceneParticles& particles,
                                       int threads);

} // namespace meniscus
