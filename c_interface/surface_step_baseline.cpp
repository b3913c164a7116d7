#include "standard_headers.hpp"
#include "surface_step.hpp"

#include "surface_step_kernel.hpp"

namespace meniscus {

std::unique_ptr<SurfaceStep> surface_step_baseline(const meniscus_options& options, int dimension,
                                                   int precision) {
    return make_surface_step(options, dimension, precision);
}

} // namespace meniscus
