// How far off the runtime's curvature is on a cloud whose curvature is known: mean and deviation of
// the error of h kappa over the surface particles, by exposure weight, as forces have it.
#pragma once

#include "support/known_state.hpp"
#include "support/statistics.hpp"

#include <meniscus/runtime/surface/surface_tension.hpp>

namespace meniscus {

/// The closed form as a map, so that it is averaged as the calibrated one is.
inline CurvatureMap closed_form_map(int dimension) {
    return {dimension, {0, 0, 0, 1}, 0, 0};
}

/// Of the closed form and of the map that ships.
using MapErrors = std::array<Spread, 2>;

/// A filled cloud, as deep as its curvature needs it.
inline KnownState<double> curvature_cloud(const Shape& shape, CloudOptions options) {
    options.thickness = 3.2;
    return known_state<double>(shape.name, shape, options);
}

/// Adds the errors of each map to its entry, all after the same coverage and normals; `samples` 0
/// is exact coverage. All may be surface, as with a perfect line.
template <int Dimension, class Loop>
void add_curvature_errors(const KnownState<double>& known, std::size_t samples, const Loop& loop,
                          MapErrors& errors) {
    const Cloud& cloud = known.cloud;
    const NeighborLists& lists = known.state.lists;
    std::vector<std::uint8_t> is_candidate;
    std::vector<std::uint32_t> neighbor_count;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        is_candidate.push_back(cloud.depth[i] < 1 ? 1 : 0);
        neighbor_count.push_back(
            static_cast<std::uint32_t>(lists.offsets[i + 1] - lists.offsets[i]));
    }
    SurfaceTensionOptions options;
    if (samples == 0)
        options.coverage = CoverageMethod::exact;
    else
        options.samples = samples;
    SurfaceTension<double, Dimension> tension(options);
    tension.step(known.state.view<Dimension>(), NoBoundary{}, cloud.size(),
                 UniformRadius<double>{1}, nullptr, is_candidate.data(), neighbor_count.data(),
                 loop);
    auto surface = tension.surface();
    std::vector<double> memory;
    const CurvatureMap maps[] = {closed_form_map(Dimension), shipped_curvature_map(Dimension)};
    for (std::size_t map = 0; map < errors.size(); ++map) {
        find_mapped_curvature<double, Dimension>(maps[map], options.radius_ratio,
                                                 UniformRadius<double>{1}, loop, surface, memory);
        for (std::size_t slot = 0; slot < surface.size(); ++slot) {
            const std::size_t i = surface.particle[slot];
            if (cloud.trusted[i] != 0 && surface.weight[slot] > 0)
                errors[map].add(surface.curvature[slot] - cloud.mean_curvature[i],
                                surface.weight[slot]);
        }
    }
}

} // namespace meniscus
