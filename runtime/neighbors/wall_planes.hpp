// Walls that are not particles: signed distance fields, volume maps, triangle meshes. What a host
// knows there is, for a particle and a wall, the distance of the particle and the normal of the
// wall. It hands over just that, and the plane at that place stands in for the wall as a boundary
// (boundary.hpp): as the one layer of boundary particles that models are trained with and walls of
// scenes have, half a spacing behind the plane, on a lattice below the particle. So all that is
// known of boundary particles holds: they cover what lies behind the plane, they count in the
// features by the share that a model says, and a surface meets them at the contact angle
// (surface/wall_contact.hpp). In a corner each wall is a plane of its own.
#pragma once

#include "../math/coordinates.hpp"
#include "../math/cubic_spline.hpp"
#include "../math/vector3.hpp"
#include "neighborhood.hpp"

#include <cmath>
#include <cstddef>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

namespace wall_planes {

/// Calls visit(a, b) for the points of a lattice of spacing 1 in the plane (in two dimensions on
/// the line, where b is 0) that are closer to the origin than the root of `squared`.
template <int Dimension, class Visit>
void visit_lattice(double squared, const Visit& visit) {
    const double reach = squared > 0 ? std::floor(std::sqrt(squared)) : -1;
    const double across = Dimension == 3 ? reach : (squared > 0 ? 0 : -1);
    for (double b = -across; b <= across; ++b)
        for (double a = -reach; a <= reach; ++a)
            if (a * a + b * b < squared)
                visit(a, b);
}

/// How many fluid particles one of a layer stands for, as boundary.hpp has it, at a support radius
/// of so many spacings.
template <int Dimension>
double weight_in_layer(double spacing_ratio) {
    double sum = 0;
    visit_lattice<Dimension>(spacing_ratio * spacing_ratio, [&](double a, double b) {
        sum += cubic_spline(std::sqrt(a * a + b * b) / spacing_ratio);
    });
    const double in_ball = Dimension == 2 ? spacing_ratio * spacing_ratio
                                          : spacing_ratio * spacing_ratio * spacing_ratio;
    return in_ball / (cubic_spline_scale<Dimension> * sum);
}

} // namespace wall_planes

/// Walls as a boundary. `walls(i, visit)` calls visit(b, distance, normal) for the walls around
/// fluid particle i, b being a number of the wall: `distance` is that of the particle's center in
/// m, negative inside of the wall, `normal` a vector out of the wall, towards the fluid (anything
/// that has operator[]; its length plays no part). Walls out of reach, and those whose distance or
/// normal is not finite or whose normal is 0, do nothing. A particle nearer than half a spacing, as
/// one that is pressed into the wall, counts as much as one there. `radii` as in the step,
/// `spacing_ratio` that of the options.
template <int Dimension, class Radii, class Walls>
class WallPlanes {
public:
    static constexpr bool is_there = true;

    WallPlanes(const Walls& host_walls, const Radii& of_particles, double ratio)
        : walls(host_walls), radii(of_particles), spacing_ratio(ratio),
          weight(wall_planes::weight_in_layer<Dimension>(ratio)) {}

    /// The angle, in degrees from 10 to 170, at which a surface at rest meets a wall, by b;
    /// nullptr: that of the options for all.
    const float* contact_angles = nullptr;

    template <class Visit>
    void operator()(std::size_t i, Visit&& visit) const {
        using Real = decltype(radii.of(i));
        const auto radius = static_cast<double>(radii.of(i));
        walls(i, [&](std::size_t b, auto distance, const auto& normal) {
            Vector3 out = {0, 0, 0};
            for (std::size_t axis = 0; axis < Dimension; ++axis)
                out[axis] = static_cast<double>(normal[axis]);
            visit_layer(static_cast<double>(distance) / radius, out, [&](const Vector3& step) {
                Coordinates<Real, Dimension> displacement;
                for (std::size_t axis = 0; axis < Dimension; ++axis)
                    displacement[axis] = static_cast<Real>(step[axis] * radius);
                visit(b, displacement, static_cast<Real>(weight));
            });
        });
    }

private:
    Walls walls;
    Radii radii;
    double spacing_ratio;
    double weight;

    /// Calls visit(step) with the particles of the layer, in radii.
    template <class Visit>
    void visit_layer(double distance, const Vector3& normal, const Visit& visit) const {
        const double spacing = 1 / spacing_ratio;
        // Particles closer than the inner limit of NeighborRange would cover nothing.
        constexpr double min_depth = 0.25;
        const double at_depth = distance + spacing / 2;
        const double depth = at_depth > min_depth ? at_depth : min_depth;
        const double length = std::sqrt(dot(normal, normal));
        if (!(at_depth < 1) || !is_positive_and_finite(length) ||
            !is_positive_and_finite(1 + std::fabs(distance)))
            return;
        const Vector3 up = scaled(1 / length, normal);
        Vector3 first = {-up[1], up[0], 0}, second = {0, 0, 0};
        if constexpr (Dimension == 3) {
            const Frame frame(up);
            first = frame.first;
            second = frame.second;
        }
        wall_planes::visit_lattice<Dimension>(
            (1 - depth * depth) * spacing_ratio * spacing_ratio, [&](double a, double b) {
                visit(sum(scaled(-depth, up),
                          sum(scaled(a * spacing, first), scaled(b * spacing, second))));
            });
    }
};

template <int Dimension, class Radii, class Walls>
WallPlanes<Dimension, Radii, Walls> wall_planes_of(const Walls& walls, const Radii& radii,
                                                   double spacing_ratio) {
    return {walls, radii, spacing_ratio};
}

/// As of a BoundaryView.
template <int Dimension, class Radii, class Walls>
double contact_angle_at(const WallPlanes<Dimension, Radii, Walls>& boundary, std::size_t b,
                        double usual) {
    return boundary.contact_angles != nullptr ? static_cast<double>(boundary.contact_angles[b])
                                              : usual;
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
