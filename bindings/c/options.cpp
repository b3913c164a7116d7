#include "options.hpp"

#include <algorithm>

namespace meniscus {
namespace {

CurvatureMap map_from_c(const meniscus_curvature_map& map, int dimension) {
    static_assert(sizeof map.coefficients == sizeof CurvatureMap::coefficients);
    CurvatureMap made{};
    made.dimension = dimension;
    std::copy_n(map.coefficients, CurvatureMap::terms, made.coefficients);
    made.min = map.min;
    made.max = map.max;
    made.averaged = map.averaged != 0;
    return made;
}

} // namespace

/// The place of a feature; one that does not exist where there is none of that name.
std::size_t feature_from_c(const char* name) {
    return name != nullptr ? find_feature(name) : feature_count;
}

SecondLine second_line_from_c(const meniscus_second_line& line) {
    return {true,   feature_from_c(line.features[0]), feature_from_c(line.features[1]), line.k,
            line.d, line.surface_above != 0};
}

meniscus_options to_c(const SurfaceTensionOptions& options) {
    meniscus_options made{};
    made.size = sizeof made;
#define MENISCUS_ROW(name, range, only_sampled, unit, meaning)                                     \
    made.name = static_cast<decltype(made.name)>(options.name);
    MENISCUS_SURFACE_TENSION_OPTIONS(MENISCUS_ROW)
#undef MENISCUS_ROW
    return made;
}

SurfaceTensionOptions from_c(const meniscus_options& options, int dimension) {
    SurfaceTensionOptions made;
#define MENISCUS_ROW(name, range, only_sampled, unit, meaning)                                     \
    made.name = static_cast<decltype(made.name)>(options.name);
    MENISCUS_SURFACE_TENSION_OPTIONS(MENISCUS_ROW)
#undef MENISCUS_ROW
    if (options.second_line != nullptr)
        made.second_line = second_line_from_c(*options.second_line);
    if (options.curvature_map != nullptr)
        made.curvature_map = map_from_c(*options.curvature_map, dimension);
    return made;
}

} // namespace meniscus
