#include "exact_labels.hpp"

namespace meniscus {

std::unique_ptr<ExactLabels> exact_labels(InstructionSet widest) {
    return with_instruction_set(widest, [](auto set) { return exact_labels(set); });
}

} // namespace meniscus
