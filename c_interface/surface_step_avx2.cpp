#include "standard_headers.hpp"
#include "surface_step.hpp"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#include <immintrin.h>
#define MENISCUS_INSTRUCTION_SET_NAME avx2
#define MENISCUS_VECTOR_BYTES 32
#pragma GCC push_options
#pragma GCC target("avx2")
#include "surface_step_kernel.hpp"
#pragma GCC pop_options
#define MENISCUS_HAS_KERNEL 1
#endif

namespace meniscus {

std::unique_ptr<SurfaceStep> surface_step_avx2([[maybe_unused]] const meniscus_options& options,
                                               [[maybe_unused]] int dimension,
                                               [[maybe_unused]] int precision) {
#if defined(MENISCUS_HAS_KERNEL)
    if (__builtin_cpu_supports("avx2"))
        return make_surface_step(options, dimension, precision);
#endif
    return nullptr;
}

} // namespace meniscus
