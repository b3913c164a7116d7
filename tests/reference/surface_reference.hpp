// The step of surface_tension.hpp in plain loops: one particle, one neighbor and one sample at a
// time, over the host's view again for each average. Slow and easy to check: what the fast kernels
// are tested against and what benchmarks compare them with.
#pragma once

#include <meniscus/runtime/surface/surface_tension.hpp>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {
namespace surface_reference {

/// Calls visit(j, step) for the neighbors in range of particle i, steps in radii of the pair.
template <class Real, int Dimension, class View, class Radii, class Visit>
void visit_in_range(const View& view, const Radii& radii, double radius_ratio, std::size_t i,
                    const Visit& visit) {
    const auto range = neighbor_range<Real>(1, radius_ratio);
    view(i, [&](std::size_t j, const auto& displacement, Real /*mass*/) {
        std::array<Real, Dimension> step;
        for (int axis = 0; axis < Dimension; ++axis)
            step[axis] = displacement[axis] * radii.inverse_of_pair(i, j);
        if (range.contains(squared_length<Real, Dimension>(step)))
            visit(j, step);
    });
}

/// Whether a direction lies in no cap of the neighbors.
inline bool is_open(const Vector3& direction, const std::vector<Vector3>& steps, double ratio) {
    for (const Vector3& step : steps)
        if (dot(direction, step) > (dot(step, step) + 1 - ratio * ratio) / 2)
            return false;
    return true;
}

/// The axes of the frame that outward directions are given in.
template <int Dimension>
std::array<Vector3, 3> outward_axes(const std::vector<Vector3>& steps) {
    Vector3 outward = {0, 0, 0};
    for (const Vector3& step : steps)
        outward = difference(outward, step);
    const double length = std::sqrt(dot(outward, outward));
    if (length == 0)
        return {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}};
    const Vector3 axis = scaled(1 / length, outward);
    if (Dimension == 2)
        return {axis, Vector3{-axis[1], axis[0], 0}, Vector3{0, 0, 1}};
    const Frame frame(axis);
    return {frame.first, frame.second, axis};
}

/// The part that the directions of a set find uncovered.
template <int Dimension>
UncoveredPart sampled_part(const SampleDirections& directions, std::size_t set_begin,
                           const std::vector<Vector3>& steps, double ratio) {
    const auto axes = outward_axes<Dimension>(steps);
    UncoveredPart part{0, {0, 0, 0}};
    for (std::size_t k = set_begin; k < set_begin + directions.samples; ++k) {
        const Vector3 place = {directions.x[k], directions.y[k], directions.z[k]};
        Vector3 direction = {0, 0, 0};
        for (int axis = 0; axis < 3; ++axis)
            direction = sum(direction, scaled(place[axis], axes[axis]));
        const Vector3 sample = directions.outward ? direction : place;
        if (!is_open(sample, steps, ratio))
            continue;
        const double weight = static_cast<double>(directions.weight[k]);
        part.fraction += weight;
        part.moment = sum(part.moment, scaled(weight, sample));
    }
    return part;
}

} // namespace surface_reference

/// find_exposure in plain loops, without a boundary. Samples that lie within float rounding of a
/// cap's edge may be decided otherwise.
template <class Real, int Dimension, class View, class Radii>
void find_exposure_reference(const View& view, const Radii& radii,
                             const SampleDirections& directions, const CoverageCells& cells,
                             const SurfaceTensionOptions& options, ExactCoverage& exact,
                             SurfaceParticles<Real, Dimension>& list) {
    const double ratio = options.radius_ratio;
    std::vector<Vector3> steps;
    for (std::size_t slot = 0; slot < list.size(); ++slot) {
        const std::size_t i = list.particle[slot];
        steps.clear();
        surface_reference::visit_in_range<Real, Dimension>(
            view, radii, ratio, i, [&](std::size_t /*j*/, const auto& step) {
                Vector3 place = {0, 0, 0};
                for (int axis = 0; axis < Dimension; ++axis)
                    place[axis] = static_cast<double>(step[axis]);
                steps.push_back(place);
            });
        UncoveredPart part{0, {0, 0, 0}};
        if (options.coverage == CoverageMethod::sampled)
            part = surface_reference::sampled_part<Dimension>(directions, directions.set_begin(i),
                                                              steps, ratio);
        if (part.fraction == 0 && (options.coverage == CoverageMethod::exact ||
                                   options.verification == Verification::exact)) {
            exact.caps.clear();
            for (const Vector3& step : steps)
                add_cap<Dimension>(exact.caps, step, 1, ratio);
            part = uncovered_part<Dimension>(cells, exact);
        }
        surface_particles::note(part, part.fraction > zero_uncovered_fraction, options, slot, list);
    }
}

namespace surface_reference {

/// Calls visit(slot, weight W, step) for the candidates among the neighbors of a slot's particle.
template <class Real, int Dimension, class View, class Radii, class Visit>
void visit_surface(const View& view, const Radii& radii, double radius_ratio,
                   const SurfaceParticles<Real, Dimension>& list, std::size_t slot,
                   const Visit& visit) {
    visit_in_range<Real, Dimension>(
        view, radii, radius_ratio, list.particle[slot], [&](std::size_t j, const auto& step) {
            if (list.slot_of[j] >= 0)
                visit(static_cast<std::size_t>(list.slot_of[j]),
                      1 - std::sqrt(squared_length<Real, Dimension>(step)),
                      surface_particles::in_own_radius(step, radii, list.particle[slot], j));
        });
}

} // namespace surface_reference

/// What follows in a step, in plain loops: one smoothing pass of the normals, their turning, the
/// mapped curvature and the calibrated force.
template <class Real, int Dimension, class View, class Radii>
void find_force_reference(const View& view, const Radii& radii,
                          const SurfaceTensionOptions& options,
                          SurfaceParticles<Real, Dimension>& list) {
    using Vector = std::array<Real, Dimension>;
    const double ratio = options.radius_ratio;
    const auto around = [&](std::size_t slot, const auto& visit) {
        surface_reference::visit_surface(view, radii, ratio, list, slot, visit);
    };
    const auto own = static_cast<Real>(1 - options.tau);
    const auto others = static_cast<Real>(options.tau);
    const std::vector<Vector> before = list.normal;
    for (std::size_t slot = 0; slot < list.size(); ++slot) {
        Vector sum = {};
        around(slot, [&](std::size_t other, Real weight, const Vector& /*step*/) {
            for (int axis = 0; axis < Dimension; ++axis)
                sum[axis] += weight * before[other][axis];
        });
        for (int axis = 0; axis < Dimension; ++axis)
            sum[axis] = own * before[slot][axis] + others * sum[axis];
        if (list.exposure[slot] > static_cast<Real>(min_exposure))
            list.normal[slot] = normalized<Real, Dimension>(sum);
    }
    std::vector<Real> mapped(list.size());
    const double max = 2 / std::sqrt(1 - ratio * ratio);
    for (std::size_t slot = 0; slot < list.size(); ++slot) {
        Real along = 0;
        Real turned = 0;
        Real squares = 0;
        around(slot, [&](std::size_t other, Real weight, const Vector& step) {
            weight *= list.weight[other];
            for (int axis = 0; axis < Dimension; ++axis) {
                const Real turn = list.normal[other][axis] - list.normal[slot][axis];
                along += weight * turn * step[axis];
                turned += weight * turn * turn;
            }
            squares += weight * squared_length<Real, Dimension>(step);
        });
        const Turning turning{static_cast<double>(squares > 0 ? along / squares : 0),
                              static_cast<double>(squares > 0 ? turned / squares : 0)};
        const double closed_form =
            list.surface_class[slot] == SurfaceClass::surface
                ? curvature_of<Dimension>(static_cast<double>(list.uncovered_fraction[slot]), ratio)
                : 0;
        const double curvature = curvature_of(options.curvature_map, turning, closed_form);
        const auto radius = static_cast<double>(radii.of(list.particle[slot]));
        list.turning[slot] = static_cast<Real>(turning.mean / radius);
        mapped[slot] = static_cast<Real>(std::min(std::max(curvature, -max), max) / radius);
    }
    for (std::size_t slot = 0; slot < list.size(); ++slot) {
        Real weights = list.weight[slot];
        Real sum = weights * mapped[slot];
        around(slot, [&](std::size_t other, Real weight, const Vector& /*step*/) {
            weight *= list.weight[other];
            weights += weight;
            sum += weight * mapped[other];
        });
        const bool is_surface = list.surface_class[slot] == SurfaceClass::surface && weights > 0;
        list.curvature[slot] = 0;
        if (is_surface)
            list.curvature[slot] = options.curvature_map.averaged ? sum / weights : mapped[slot];
    }
    for (std::size_t slot = 0; slot < list.size(); ++slot) {
        Real sum = list.exposure[slot];
        around(slot, [&](std::size_t other, Real weight, const Vector& /*step*/) {
            if (product<Real, Dimension>(list.normal[slot], list.normal[other]) > 0)
                sum += list.exposure[other] * weight;
        });
        using namespace surface_force;
        const auto radius = static_cast<double>(radii.of(list.particle[slot]));
        const double half_spacing = radius / options.spacing_ratio / 2;
        const double side = radius * (1 + static_cast<double>(list.turning[slot]) * half_spacing);
        const double share = sum > 0 ? static_cast<double>(list.exposure[slot] / sum) : 0;
        const double area = kernel_integral<Dimension> * share * to_area<Dimension>(side);
        const double size = (Dimension - 1) * options.surface_tension *
                            static_cast<double>(list.curvature[slot]) * area;
        for (int axis = 0; axis < Dimension; ++axis)
            list.force[slot][axis] = static_cast<Real>(-size) * list.normal[slot][axis];
    }
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
