#include "comparison/step_models.hpp"

#include <meniscus/sph/step_headers.hpp>

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#include <immintrin.h>
#define MENISCUS_INSTRUCTION_SET_NAME avx512
#define MENISCUS_VECTOR_BYTES 64
#pragma GCC push_options
#pragma GCC target("avx2,avx512f,avx512bw,avx512cd,avx512dq,avx512vl")
#include "comparison/step_models_kernel.hpp"
#pragma GCC pop_options
#define MENISCUS_HAS_KERNEL 1
#endif

namespace meniscus {

std::unique_ptr<StepModels>
step_models_avx512([[maybe_unused]] const StepState& state, [[maybe_unused]] double spacing,
                   [[maybe_unused]] const std::vector<StepModelKind>& kinds) {
#if defined(MENISCUS_HAS_KERNEL)
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
        __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl"))
        return std::make_unique<StepModelsKernel>(state, spacing, kinds);
#endif
    return nullptr;
}

} // namespace meniscus
