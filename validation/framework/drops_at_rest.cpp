#include "drops_at_rest.hpp"

#include <meniscus/runtime/math/angles.hpp>

namespace meniscus {

double volume_radius(const Scene& scene, std::size_t particles) {
    const double volume = particle_volume(scene) * static_cast<double>(particles);
    return scene.dimension == 3 ? std::cbrt(3 * volume / (4 * pi)) : std::sqrt(volume / pi);
}

} // namespace meniscus
