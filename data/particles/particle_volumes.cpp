#include "particle_volumes.hpp"

#include "neighbor_search.hpp"
#include "particle_arrays.hpp"

#include <meniscus/data/threads/threads.hpp>
#include <meniscus/runtime/math/cubic_spline.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace meniscus {
namespace {

double kernel_scale(int dimension) {
    return dimension == 2 ? cubic_spline_scale<2> : cubic_spline_scale<3>;
}

double median_radius(const SupportRadii& radii, const std::vector<std::uint8_t>& valid) {
    std::vector<double> some;
    for (std::size_t i = 0; radii.vary() && i < valid.size(); ++i)
        if (valid[i] != 0)
            some.push_back(radii.each[i]);
    if (some.empty())
        return radii.max;
    const auto middle = some.begin() + static_cast<std::ptrdiff_t>(some.size() / 2);
    std::nth_element(some.begin(), middle, some.end());
    return *middle;
}

} // namespace

double kernel_sum(const FoundNeighbors& found, std::size_t particle, const SupportRadii& radii,
                  int dimension, bool without_crowds) {
    double sum = cubic_spline(0.0);
    const double own = radii.of(particle);
    std::size_t crowd = 0;
    for (std::size_t n = 0; n < found.size(); ++n) {
        const auto& to = found.displacements[n];
        const double distance = std::sqrt(to[0] * to[0] + to[1] * to[1] + to[2] * to[2]);
        crowd += distance < crowd_radius * own ? 1 : 0;
        if (!radii.vary()) {
            sum += cubic_spline(distance / own);
            continue;
        }
        const double other = radii.of(found.particles[n]);
        sum += std::pow(2 * other / (own + other), dimension) *
               cubic_spline(2 * distance / (own + other));
    }
    return without_crowds && crowd > usual_max_crowd ? std::numeric_limits<double>::quiet_NaN()
                                                     : kernel_scale(dimension) * sum;
}

std::vector<double> kernel_sums(const NeighborGrid& grid, const SupportRadii& radii, int dimension,
                                int threads, bool without_crowds) {
    std::vector<double> sums(grid.size());
    const auto loop = loop_over(threads);
    std::vector<FoundNeighbors> found_by(loop.workers());
    loop(grid.size(), [&](std::size_t begin, std::size_t end, int worker) {
        FoundNeighbors& found = found_by[worker];
        for (std::size_t place = begin; place < end; ++place) {
            grid.find(place, found);
            sums[place] = kernel_sum(found, grid.particle(place), radii, dimension, without_crowds);
        }
    });
    return sums;
}

std::optional<double> spacing_ratio_of_sums(std::vector<double> sums, const Snapshot& snapshot,
                                            const SupportRadii& radii) {
    sums.erase(std::remove_if(sums.begin(), sums.end(), [](double sum) { return std::isnan(sum); }),
               sums.end());
    if (sums.empty())
        return {};
    const auto quartile = sums.begin() + static_cast<std::ptrdiff_t>(quartile_place(sums.size()));
    std::nth_element(sums.begin(), quartile, sums.end());
    return spacing_ratio_of_sum(*quartile, snapshot, radii);
}

double spacing_ratio_of_sum(double quartile, const Snapshot& snapshot, const SupportRadii& radii) {
    const double measured = std::pow(quartile, 1.0 / snapshot.dimension);
    return snapshot.particle_spacing && !radii.vary()
               ? std::max(measured, radii.max / *snapshot.particle_spacing)
               : measured;
}

std::optional<double> stored_spacing_ratio(const Snapshot& snapshot, const SupportRadii& radii) {
    if (!snapshot.particle_volume || radii.vary())
        return {};
    return radii.max / std::pow(*snapshot.particle_volume, 1.0 / snapshot.dimension);
}

double measured_spacing_ratio(const Snapshot& snapshot, const SupportRadii& radii,
                              const std::vector<std::uint8_t>& valid, int threads) {
    if (const auto stored = stored_spacing_ratio(snapshot, radii))
        return *stored;
    const NeighborGrid grid(snapshot.positions, radii, {&valid, nullptr}, threads);
    for (const bool without_crowds : {true, false})
        if (const auto ratio = spacing_ratio_of_sums(
                kernel_sums(grid, radii, snapshot.dimension, threads, without_crowds), snapshot,
                radii))
            return *ratio;
    return 1;
}

double BoundaryWeights::of(std::size_t boundary_particle, double support_radius,
                           int dimension) const {
    const double weight = at_radius[boundary_particle];
    return support_radius == radius ? weight
                                    : weight * std::pow(radius / support_radius, dimension);
}

BoundaryWeights boundary_weights(const Snapshot& snapshot, const SupportRadii& radii,
                                 const std::vector<std::uint8_t>& valid, double spacing_ratio,
                                 int threads) {
    BoundaryWeights weights;
    weights.radius = median_radius(radii, valid);
    if (snapshot.boundary.empty())
        return weights;
    check_boundary(snapshot);
    const double fluid = std::pow(spacing_ratio, snapshot.dimension); // h^D / V_0
    const NeighborGrid grid(snapshot.boundary, weights.radius, {}, threads);
    const auto sums = kernel_sums(grid, weights.radius, snapshot.dimension, threads, false);
    weights.at_radius.resize(snapshot.boundary.size());
    for (std::size_t place = 0; place < sums.size(); ++place)
        weights.at_radius[grid.particle(place)] = fluid / sums[place];
    return weights;
}

} // namespace meniscus
