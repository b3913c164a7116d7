#include "surface_step.hpp"

#include <initializer_list>
#include <stdexcept>
#include <string>

namespace meniscus {
namespace {

/// Enums of meniscus.h have the values 0 and 1.
void check_choices(const meniscus_options& options, int dimension, int precision) {
    struct Choice {
        const char* name;
        int value;
    };
    for (const auto& [name, value] :
         {Choice{"coverage", options.coverage}, Choice{"verification", options.verification},
          Choice{"curvature", options.curvature}, Choice{"force", options.force},
          Choice{"precision", precision}})
        if (value != 0 && value != 1)
            throw std::invalid_argument(std::string(name) + " must be 0 or 1, found " +
                                        std::to_string(value));
    if (dimension != 2 && dimension != 3)
        throw std::invalid_argument("dimension must be 2 or 3, found " + std::to_string(dimension));
    if (options.threads < 0 || options.threads > most_threads)
        throw std::invalid_argument("threads must be between 0 and " +
                                    std::to_string(most_threads) + ", found " +
                                    std::to_string(options.threads));
}

} // namespace

std::unique_ptr<SurfaceStep> surface_step(const meniscus_options& options, int dimension,
                                          int precision) {
    check_choices(options, dimension, precision);
    if (auto widest = surface_step_avx512(options, dimension, precision))
        return widest;
    if (auto wide = surface_step_avx2(options, dimension, precision))
        return wide;
    return surface_step_baseline(options, dimension, precision);
}

} // namespace meniscus
