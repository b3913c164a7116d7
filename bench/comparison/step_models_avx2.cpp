#include "comparison/step_models.hpp"

#include <meniscus/sph/step_headers.hpp>

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#include <immintrin.h>
#define MENISCUS_INSTRUCTION_SET_NAME avx2
#define MENISCUS_VECTOR_BYTES 32
#pragma GCC push_options
#pragma GCC target("avx2")
#include "comparison/step_models_kernel.hpp"
#pragma GCC pop_options
#define MENISCUS_HAS_KERNEL 1
#endif

namespace meniscus {

std::unique_ptr<StepModels>
step_models_avx2([[maybe_unused]] const StepState& state, [[maybe_unused]] double spacing,
                 [[maybe_unused]] const std::vector<StepModelKind>& kinds) {
#if defined(MENISCUS_HAS_KERNEL)
    if (__builtin_cpu_supports("avx2"))
        return std::make_unique<StepModelsKernel>(state, spacing, kinds);
#endif
    return nullptr;
}

} // namespace meniscus
