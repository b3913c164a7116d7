// Mean curvature from how normals turn along the surface, calibrated. Two surface particles a step
// u apart (in radii) have normals that differ by the curvature times u, so that
//     turning = sum_j w_j W (n_j - n_i) . u_j / sum_j w_j W |u_j|^2
// is the mean of the normal curvatures around particle i, which is the mean curvature (Euler's
// theorem), and
//     square = sum_j w_j W |n_j - n_i|^2 / sum_j w_j W |u_j|^2
// is the mean of their squares. Both belong to the sheet through the outermost particles, about
// half a spacing inside the fluid. A parallel surface a distance d outside has, to first order, the
// curvature turning - d square: hence a map that is linear in the two, with coefficients from
// clouds of known curvature (`meniscus calibrate`). It may take the closed form of curvature.hpp
// too; on clouds like a solver's that adds nothing but scatter (docs/curvature.md).
#pragma once

#include "curvature.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// The map of an exported coefficient struct (coefficients/curvature_3d.hpp has one).
template <class Coefficients>
constexpr CurvatureMap curvature_map() {
    CurvatureMap map{};
    map.dimension = Coefficients::dimension;
    for (int term = 0; term < CurvatureMap::terms; ++term)
        map.coefficients[term] = Coefficients::coefficients[term];
    map.min = Coefficients::min;
    map.max = Coefficients::max;
    map.averaged = Coefficients::averaged;
    return map;
}

/// How the normals turn around a particle, times h and h^2.
struct Turning {
    double mean = 0;
    double square = 0;
};

/// h kappa from both. Where the turning leaves the range of training, square is held at that of a
/// sphere at its end, and the map follows its tangent.
inline double curvature_of(const CurvatureMap& map, const Turning& turning, double closed_form) {
    const double end = smaller(larger(turning.mean, map.min), map.max);
    const double max = larger(map.min * map.min, map.max * map.max);
    const double square = smaller(turning.square, max) + 2 * end * (turning.mean - end);
    return map.coefficients[0] + map.coefficients[1] * turning.mean + map.coefficients[2] * square +
           map.coefficients[3] * closed_form;
}

/// How the normals turn around the particle in a slot: 0 where no other surface particle is near.
template <class Real, int Dimension>
MENISCUS_INLINE Turning turning_around(const SurfaceParticles<Real, Dimension>& list,
                                       std::size_t slot) {
    Real along = 0;
    Real turned = 0;
    Real squares = 0;
    const auto& normal = list.normal[slot];
    const auto* pair = list.pairs.data() + list.pairs_begin[slot];
    for (const auto* last = pair + list.pairs_count[slot]; pair != last; ++pair) {
        const Real weight = list.weight[pair->slot] * pair->weight;
        const auto& other = list.normal[pair->slot];
        for (std::size_t axis = 0; axis < Dimension; ++axis) {
            const Real turn = other[axis] - normal[axis];
            const Real step = pair->step[axis];
            along += weight * turn * step;
            turned += weight * turn * turn;
            squares += weight * step * step;
        }
    }
    if (list.contact[slot].is_there())
        visit_wall_images(list, slot, list.normal, [&](const auto& image) {
            const Real weight = image.weight * weight_of(list, image);
            for (std::size_t axis = 0; axis < Dimension; ++axis) {
                const Real turn = image.normal[axis] - normal[axis];
                const Real step = image.step[axis];
                along += weight * turn * step;
                turned += weight * turn * turn;
                squares += weight * step * step;
            }
        });
    if (!(squares > 0))
        return {};
    return {static_cast<double>(along / squares), static_cast<double>(turned / squares)};
}

/// The mean of a value over the particle in a slot and the surface particles around it, by exposure
/// weight and W; 0 where none has any.
template <class Real, int Dimension>
MENISCUS_INLINE Real surface_average(const SurfaceParticles<Real, Dimension>& list,
                                     std::size_t slot, const std::vector<Real>& values) {
    Real weights = list.weight[slot];
    Real sum = weights * values[slot];
    const auto* pair = list.pairs.data() + list.pairs_begin[slot];
    for (const auto* last = pair + list.pairs_count[slot]; pair != last; ++pair) {
        const Real weight = list.weight[pair->slot] * pair->weight;
        sum += weight * values[pair->slot];
        weights += weight;
    }
    if (list.contact[slot].is_there())
        visit_wall_images(list, slot, list.normal, [&](const auto& image) {
            if (image.slot == image.is_line)
                return;
            const Real weight = image.weight * list.weight[image.slot];
            sum += weight * values[image.slot];
            weights += weight;
        });
    return weights > 0 ? sum / weights : 0;
}

/// Sets the turning of the normals at each surface particle, in 1/m, for those who want no map.
template <class Real, int Dimension, class Radii, class Loop>
void find_turning(const Radii& radii, const Loop& loop, SurfaceParticles<Real, Dimension>& list) {
    loop(list.size(), [&](std::size_t begin, std::size_t end, int /*worker*/) {
        for (std::size_t slot = begin; slot < end; ++slot)
            list.turning[slot] =
                static_cast<Real>(turning_around(list, slot).mean) / radii.of(list.particle[slot]);
    });
}

/// Sets turning and curvature of each surface particle by the map; 0 where covered. No curvature
/// exceeds the largest of the closed form. `mapped` is working memory.
template <class Real, int Dimension, class Radii, class Loop>
void find_mapped_curvature(const CurvatureMap& map, double radius_ratio, const Radii& radii,
                           const Loop& loop, SurfaceParticles<Real, Dimension>& list,
                           std::vector<Real>& mapped) {
    const double max = 2 / std::sqrt(1 - radius_ratio * radius_ratio);
    const auto is_surface = [&](std::size_t slot) {
        return list.surface_class[slot] == SurfaceClass::surface;
    };
    mapped.resize(list.size());
    loop(list.size(), [&](std::size_t begin, std::size_t end, int /*worker*/) {
        for (std::size_t slot = begin; slot < end; ++slot) {
            const Turning turning = turning_around(list, slot);
            const auto lambda = static_cast<double>(list.uncovered_fraction[slot]);
            const double closed_form = map.coefficients[3] != 0 && is_surface(slot)
                                           ? curvature_of<Dimension>(lambda, radius_ratio)
                                           : 0;
            const double curvature = curvature_of(map, turning, closed_form);
            const Real radius = radii.of(list.particle[slot]);
            list.turning[slot] = static_cast<Real>(turning.mean) / radius;
            mapped[slot] = static_cast<Real>(smaller(larger(curvature, -max), max)) / radius;
        }
    });
    loop(list.size(), [&](std::size_t begin, std::size_t end, int /*worker*/) {
        for (std::size_t slot = begin; slot < end; ++slot) {
            const Real curvature =
                map.averaged ? surface_average(list, slot, mapped) : mapped[slot];
            list.curvature[slot] = is_surface(slot) ? curvature : 0;
        }
    });
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
