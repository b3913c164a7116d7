#include <meniscus/sph/step_headers.hpp>

#include "comparison/step_models_kernel.hpp"

namespace meniscus {

std::unique_ptr<StepModels> step_models_baseline(const StepState& state, double spacing,
                                                 const std::vector<StepModelKind>& kinds) {
    return std::make_unique<StepModelsKernel>(state, spacing, kinds);
}

std::unique_ptr<StepModels> step_models(const StepState& state, double spacing,
                                        const std::vector<StepModelKind>& kinds) {
    if (auto widest = step_models_avx512(state, spacing, kinds))
        return widest;
    if (auto wide = step_models_avx2(state, spacing, kinds))
        return wide;
    return step_models_baseline(state, spacing, kinds);
}

} // namespace meniscus
