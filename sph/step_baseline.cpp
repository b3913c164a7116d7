#include "step_headers.hpp"

#include "fluid_step.hpp"

namespace meniscus {

std::unique_ptr<Step> make_step_baseline(const Scene& scene, const SceneParticles& particles,
                                         int threads) {
    return make_fluid_step(scene, particles, threads);
}

} // namespace meniscus
