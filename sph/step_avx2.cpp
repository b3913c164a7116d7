#include "step_headers.hpp"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#include <immintrin.h>
#define MENISCUS_INSTRUCTION_SET_NAME avx2
#define MENISCUS_VECTOR_BYTES 32
#pragma GCC push_options
#pragma GCC target("avx2")
#include "fluid_step.hpp"
#pragma GCC pop_options
#define MENISCUS_HAS_KERNEL 1
#endif

namespace meniscus {

std::unique_ptr<Step> make_step_avx2([[maybe_unused]] const Scene& scene,
                                     [[maybe_unused]] const SceneParticles& particles,
                                     [[maybe_unused]] int threads) {
#if defined(MENISCUS_HAS_KERNEL)
    if (__builtin_cpu_supports("avx2"))
        return make_fluid_step(scene, particles, threads);
#endif
    return nullptr;
}

} // namespace meniscus
