// One step of a simulation, over a state in SI units and double. What calculates it is compiled for
// several instruction sets (step_kernel.cpp), two number types and two dimensions; make_step()
// picks one.
#pragma once

#include "divergence.hpp"

#include <meniscus/runtime/simd/dispatch.hpp>

#include <memory>

namespace meniscus {

class Step {
public:
    virtual ~Step() = default;

    /// Sorts the state's particles by cell, and moves them and their velocities on by one step of
    /// at most `longest` (s). Takes those out that leave the domain, where the scene lets them.
    /// Throws Divergence.
    virtual StepReport advance(SimulationState& state, double longest) = 0;

    /// Moves apart, without a change of velocities, what starts too close together, to a wall or to
    /// each other: pressure would throw it away. Returns how many particles were more than a tenth
    /// denser than at rest; none moves where that is 0. Particles in one place and heaps more than
    /// twice as dense stay.
    virtual std::size_t part_compressed(SimulationState& state) = 0;

    /// Sorts the state's particles by cell, as advance() does, and looks at them without moving
    /// them. Steps that follow are not affected.
    virtual StepResults evaluate(SimulationState& state) = 0;
};

/// The one for the widest instruction set of this machine, up to `widest`.
std::unique_ptr<Step> make_step(const Scene& scene, const SceneParticles& particles, int threads,
                                InstructionSet widest = widest_instruction_set);
MENISCUS_KERNEL(std::unique_ptr<Step>, make_step, const Scene& scene,
                const SceneParticles& particles, int threads);

} // namespace meniscus
