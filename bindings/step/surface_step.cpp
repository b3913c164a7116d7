#include "surface_step.hpp"

#include <algorithm>
#include <omp.h>
#include <stdexcept>
#include <string>

namespace meniscus {
namespace {

void check_setup(const StepSetup& setup) {
    if (setup.dimension != 2 && setup.dimension != 3)
        throw std::invalid_argument("dimension must be 2 or 3, found " +
                                    std::to_string(setup.dimension));
    if (setup.threads < 0 || setup.threads > max_threads)
        throw std::invalid_argument("threads must be between 0 and " + std::to_string(max_threads) +
                                    ", found " + std::to_string(setup.threads));
}

} // namespace

std::unique_ptr<SurfaceStep> surface_step(const SurfaceTensionOptions& options,
                                          const StepSetup& setup, InstructionSet widest) {
    check_setup(setup);
    StepSetup resolved = setup;
    if (setup.threads == 0) // OMP_NUM_THREADS may say anything
        resolved.threads = std::clamp(omp_get_max_threads(), 1, max_threads);
    return with_instruction_set(widest,
                                [&](auto set) { return surface_step(set, options, resolved); });
}

} // namespace meniscus
