// How far off the runtime's curvature is on a cloud whose curvature is known: mean and deviation of
// the error of h kappa over the surface particles, by exposure weight, as forces have it.
#pragma once

#include <meniscus/data/clouds.hpp>
#include <meniscus/data/neighbor_search.hpp>
#include <meniscus/runtime/surface_tension.hpp>

#include <cmath>
#include <vector>

namespace meniscus {

/// Mean and deviation of weighed values.
struct Spread {
    double weights = 0;
    double sum = 0;
    double squares = 0;

    void add(double value, double weight = 1) {
        weights += weight;
        sum += weight * value;
        squares += weight * value * value;
    }
    void add(const Spread& other) {
        weights += other.weights;
        sum += other.sum;
        squares += other.squares;
    }
    [[nodiscard]] double mean() const { return sum / weights; }
    [[nodiscard]] double deviation() const {
        return std::sqrt(std::fmax(squares / weights - mean() * mean(), 0));
    }
};

/// The closed form as a map, so that it is averaged as the calibrated one is.
inline CurvatureMap closed_form_map(int dimension) {
    return {dimension, {0, 0, 0, 1}, 0, 0};
}

/// A cloud in support radii (h = 1), with neighbor lists.
template <int Dimension>
struct KnownCloud {
    Cloud cloud;
    NeighborLists lists;
    std::vector<double> positions;
    std::vector<std::uint8_t> is_candidate; ///< all that may be surface, as with a perfect line
    std::vector<std::uint32_t> neighbor_count;

    KnownCloud(const Shape& shape, double spacing_ratio, Arrangement arrangement, double jitter,
               std::uint64_t seed) {
        CloudOptions options;
        options.support_radius = 1;
        options.spacing = 1 / spacing_ratio;
        options.arrangement = arrangement;
        options.jitter = jitter;
        options.seed = seed;
        options.thickness = 3.2;
        cloud = fill(shape, options);
        lists = find_neighbors(cloud.positions, 1.0);
        for (std::size_t i = 0; i < cloud.size(); ++i) {
            for (int axis = 0; axis < Dimension; ++axis)
                positions.push_back(cloud.positions[i][static_cast<std::size_t>(axis)]);
            is_candidate.push_back(cloud.depth[i] < 1 ? 1 : 0);
            neighbor_count.push_back(
                static_cast<std::uint32_t>(lists.offsets[i + 1] - lists.offsets[i]));
        }
    }

    /// Adds the errors of each map to its entry of `errors`, all after the same coverage and
    /// normals; `samples` 0 is exact coverage.
    template <class Loop>
    void add_errors(const std::vector<CurvatureMap>& maps, std::size_t samples, const Loop& loop,
                    Spread* errors) const {
        SurfaceTensionOptions options = shipped_options<Dimension>();
        if (samples == 0)
            options.exposure.method = CoverageMethod::exact;
        else
            options.samples = samples;
        SurfaceTension<double, Dimension> tension(options);
        const CsrNeighborhood<double, Dimension> view{positions.data(), nullptr,
                                                      lists.offsets.data(), lists.neighbors.data()};
        tension.step(view, NoBoundary{}, cloud.size(), UniformRadius<double>{1}, nullptr,
                     is_candidate.data(), neighbor_count.data(), loop);
        auto surface = tension.surface();
        std::vector<double> memory;
        for (const CurvatureMap& map : maps) {
            find_mapped_curvature<double, Dimension>(map, options.exposure.radius_ratio,
                                                     UniformRadius<double>{1}, loop, surface,
                                                     memory);
            for (std::size_t slot = 0; slot < surface.size(); ++slot) {
                const std::size_t i = surface.particle[slot];
                if (cloud.trusted[i] != 0 && surface.weight[slot] > 0)
                    errors->add(surface.curvature[slot] - cloud.mean_curvature[i],
                                surface.weight[slot]);
            }
            ++errors;
        }
    }
};

} // namespace meniscus
