#include "step_models.hpp"

namespace meniscus {

std::unique_ptr<StepModels> step_models(const StepState& state, double spacing,
                                        const std::vector<StepModelKind>& kinds,
                                        InstructionSet widest) {
    return with_instruction_set(widest,
                                [&](auto set) { return step_models(set, state, spacing, kinds); });
}

} // namespace meniscus
