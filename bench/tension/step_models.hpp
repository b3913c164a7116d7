// The surface-tension models of the SPH step on a fixed state, without a simulation around them.
// Like the step they are compiled for several instruction sets (step_models_kernel.cpp): eight
// lanes are several times as fast where they are one register, and no simulation runs without.
#pragma once

#include <meniscus/data/particles/neighbor_search.hpp>
#include <meniscus/runtime/simd/dispatch.hpp>
#include <meniscus/sph/scene/scene.hpp>

#include <memory>
#include <vector>

namespace meniscus {

/// Particles of one mass; what is pointed to must outlive the models.
struct StepState {
    const std::vector<float>* positions; ///< m, three values a particle
    const NeighborLists* lists;          ///< of particles closer than the support radius
    float support_radius;                ///< m
    float particle_volume;               ///< m^3
};

struct StepModelKind {
    TensionOptions options;
    bool is_exact = false; ///< `meniscus` with exact coverage
};

/// Models of those kinds on a state, whose neighbor lists and densities the step has found.
class StepModels {
public:
    virtual ~StepModels() = default;

    /// All that the model of that index does in a step, on so many threads. Adds up over calls.
    virtual void run(std::size_t model, int threads) = 0;

    /// The accelerations of one call, m/s^2.
    virtual std::vector<Place> accelerations(std::size_t model) = 0;
};

/// Those for the widest instruction set of this machine, up to `widest`. `spacing` is the one at
/// rest, in support radii.
std::unique_ptr<StepModels> step_models(const StepState& state, double spacing,
                                        const std::vector<StepModelKind>& kinds,
                                        InstructionSet widest = widest_instruction_set);
MENISCUS_KERNEL(std::unique_ptr<StepModels>, step_models, const StepState& state, double spacing,
                const std::vector<StepModelKind>& kinds);

} // namespace meniscus
