// The step, compiled for each instruction set.
#include "leaving.hpp"
#include "step.hpp"
#include "time_step.hpp"

#include <meniscus/sph/scene/methods.hpp>

#include <meniscus/runtime/simd/begin_kernel.hpp>

#include "fluid_step.hpp"

namespace meniscus {

std::unique_ptr<Step> make_step(MENISCUS_KERNEL_SET, const Scene& scene,
                                const SceneParticles& particles, int threads) {
    return make_fluid_step(scene, particles, threads);
}

} // namespace meniscus

#include <meniscus/runtime/simd/end_kernel.hpp>
