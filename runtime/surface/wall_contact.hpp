// Where the surface meets a wall. Boundary particles cover (neighbors/boundary.hpp), those above a
// contact line too, though nothing wets them: taken as they are they turn the normals away from the
// wall, and a level surface pulls at its rim. So a surface particle near a wall is looked at once
// more, with the fluid continued into the wall in the place of the dry boundary:
//     x_j' = x_j + 2 D_j / sin(theta) e,   e = cos(theta) t - sin(theta) n_w
// is the image of neighbor j at the distance D_j from the wall, along the surface that meets it at
// the contact angle theta; n_w is the wall's normal, out of it, and t lies in the wall, at right
// angles to the contact line, and points to where it is dry. A surface that meets the wall at theta
// goes straight on, and nothing bends it; at 90 degrees the image is the mirror's. A surface at
// another angle has a bend there, whose force moves the contact line (Brackbill et al. 1992
// prescribe the normal at the line; Huber et al. 2016 carry that over to SPH).
//
// The wall is the plane through the boundary particles around, half a spacing in front of them.
#pragma once

#include "../coverage/sampled_coverage.hpp"
#include "../math/vector3.hpp"
#include "../neighbors/boundary.hpp"
#include "../neighbors/support_radius.hpp"

#include <cmath>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// The wall next to a surface particle whose surface reaches it, in radii of the particle.
template <class Real, int Dimension>
struct WallContact {
    Coordinates<Real, Dimension> normal = {}; ///< unit vector out of the wall
    Real distance = 0;                        ///< of the particle; 0: no wall in reach
    Real cosine = 0;                          ///< of the contact angle
    Real sine = 1;

    [[nodiscard]] bool is_there() const { return distance > 0; }
};

namespace wall_contact {

/// The smallest distance, in spacings, that a particle has from a wall: one that is pressed into it
/// still has its image at the other side.
inline constexpr double min_distance = 0.3;

/// How much the surface must lean over the wall, as the sine of its angle to it, to have a contact
/// line: a film that lies on the wall has none.
inline constexpr double min_lean = 0.05;

/// The same where the boundary covers a particle, so that it is surface only below an overhang:
/// more than the fluid's own surface towards a wall that it lies on is uneven.
inline constexpr double min_lean_below = 0.3;

/// A plane, seen from a particle, in radii.
struct Plane {
    Vector3 normal = {0, 0, 0}; ///< unit vector towards the particle
    double distance = 0;        ///< of the particle from it; 0: no plane
    std::size_t nearest = 0;    ///< boundary particle

    [[nodiscard]] bool is_there() const { return distance > 0; }
};

/// Of a boundary particle in the fit: the nearest wall of a corner is to decide.
inline double fit_weight(double squared) {
    const double away = 1 - std::sqrt(squared);
    return away * away * away / (squared + 0.01);
}

/// Calls visit(step, squared length, b) with the boundary particles around particle i, in its
/// radii.
template <int Dimension, class Boundary, class Radii, class Visit>
void visit_boundary(const Boundary& boundary, std::size_t i, const Radii& radii,
                    const Visit& visit) {
    const auto inverse = static_cast<double>(radii.inverse_of_pair(i, i));
    boundary(i, [&](std::size_t b, const auto& displacement, auto /*weight*/) {
        Vector3 step = {0, 0, 0};
        for (std::size_t axis = 0; axis < Dimension; ++axis)
            step[axis] = static_cast<double>(displacement[axis]) * inverse;
        const double squared = dot(step, step);
        if (squared < 1)
            visit(step, squared, b);
    });
}

/// Sums for a plane through the boundary particles, as a height over the plane of a frame.
struct HeightSums {
    double weight = 0, a = 0, b = 0, z = 0, aa = 0, ab = 0, bb = 0, az = 0, bz = 0;

    void add(double w, double at_a, double at_b, double height) {
        weight += w;
        a += w * at_a, b += w * at_b, z += w * height;
        aa += w * at_a * at_a, ab += w * at_a * at_b, bb += w * at_b * at_b;
        az += w * at_a * height, bz += w * at_b * height;
    }

    /// Slopes along a and b by least squares; 0 where the particles do not tell.
    template <int Dimension>
    [[nodiscard]] std::array<double, 2> slopes() const {
        const double mean_a = a / weight, mean_b = b / weight, mean_z = z / weight;
        const double caa = aa / weight - mean_a * mean_a;
        const double caz = az / weight - mean_a * mean_z;
        constexpr double min_spread = 1e-4; // in square radii
        if constexpr (Dimension == 2)
            return {caa > min_spread ? caz / caa : 0, 0};
        const double cab = ab / weight - mean_a * mean_b;
        const double cbb = bb / weight - mean_b * mean_b;
        const double cbz = bz / weight - mean_b * mean_z;
        const double determinant = caa * cbb - cab * cab;
        if (!(determinant > min_spread * min_spread))
            return {0, 0};
        return {(caz * cbb - cbz * cab) / determinant, (cbz * caa - caz * cab) / determinant};
    }
};

/// The wall around particle i; `spacing` in radii. None where no boundary particle is nearer than
/// the support radius.
template <int Dimension, class Boundary, class Radii>
Plane plane_of(const Boundary& boundary, std::size_t i, const Radii& radii, double spacing) {
    Vector3 away = {0, 0, 0}, nearest = {0, 0, 0};
    double least = 1;
    std::size_t nearest_particle = 0;
    visit_boundary<Dimension>(boundary, i, radii,
                              [&](const Vector3& step, double squared, std::size_t b) {
                                  away = difference(away, scaled(fit_weight(squared), step));
                                  if (squared < least) {
                                      least = squared;
                                      nearest = step;
                                      nearest_particle = b;
                                  }
                              });
    const double length = std::sqrt(dot(away, away));
    if (!(length > 0))
        return {};
    const Vector3 up = scaled(1 / length, away);
    Vector3 first = {-up[1], up[0], 0}, second = {0, 0, 0};
    if constexpr (Dimension == 3) {
        const Frame frame(up);
        first = frame.first;
        second = frame.second;
    }
    HeightSums sums;
    visit_boundary<Dimension>(
        boundary, i, radii, [&](const Vector3& step, double squared, std::size_t /*b*/) {
            sums.add(fit_weight(squared), dot(step, first), dot(step, second), dot(step, up));
        });
    const auto [along_first, along_second] = sums.slopes<Dimension>();
    const Vector3 normal =
        difference(up, sum(scaled(along_first, first), scaled(along_second, second)));
    const double scale = 1 / std::sqrt(dot(normal, normal));
    const double above = -dot(nearest, normal) * scale - spacing / 2;
    return {scaled(scale, normal), larger(above, min_distance * spacing), nearest_particle};
}

/// The contact of the surface with the wall, `outward` being about its normal; none where the
/// surface, gone straight on, does not reach the wall within the support radius, or leans over it
/// by less than `min_sine`.
template <class Real, int Dimension>
WallContact<Real, Dimension> contact_of(const Plane& wall, const Vector3& outward,
                                        double contact_angle, double min_sine) {
    WallContact<Real, Dimension> contact;
    const double length = std::sqrt(dot(outward, outward));
    const double upward = dot(outward, wall.normal);
    const double lean = std::sqrt(larger(length * length - upward * upward, 0));
    if (!(lean > min_sine * length) || !(wall.distance * length < lean))
        return contact;
    for (std::size_t axis = 0; axis < Dimension; ++axis)
        contact.normal[axis] = static_cast<Real>(wall.normal[axis]);
    contact.distance = static_cast<Real>(wall.distance);
    if (contact_angle != 90) {
        const auto [along, aside] = cosine_and_sine_of_turn(contact_angle / 360);
        contact.cosine = static_cast<Real>(along);
        contact.sine = static_cast<Real>(aside);
    }
    return contact;
}

/// Where the surface goes at the wall: the normal that the contact angle prescribes, and the way
/// into the wall along the surface.
struct Continuation {
    Vector3 normal, into_wall;
};

template <class Real, int Dimension>
Continuation continuation(const WallContact<Real, Dimension>& contact, const Vector3& outward) {
    Vector3 up = {0, 0, 0};
    for (std::size_t axis = 0; axis < Dimension; ++axis)
        up[axis] = static_cast<double>(contact.normal[axis]);
    const Vector3 lean = difference(outward, scaled(dot(outward, up), up));
    const Vector3 dry = scaled(1 / std::sqrt(dot(lean, lean)), lean);
    const auto cosine = static_cast<double>(contact.cosine);
    const auto sine = static_cast<double>(contact.sine);
    return {sum(scaled(sine, dry), scaled(cosine, up)),
            difference(scaled(cosine, dry), scaled(sine, up))};
}

} // namespace wall_contact

/// Calls visit(step) with the fluid particles that the view has of particle i, in radii.
template <class Real, int Dimension, class View, class Radii, class Visit>
void visit_fluid(const View& view, const Radii& radii, std::size_t i, const Visit& visit) {
    view(i, [&](std::size_t j, const auto& displacement, Real /*mass*/) {
        const auto inverse = static_cast<double>(radii.inverse_of_pair(i, j));
        Vector3 step = {0, 0, 0};
        for (std::size_t axis = 0; axis < Dimension; ++axis)
            step[axis] = static_cast<double>(displacement[axis]) * inverse;
        visit(step);
    });
}

/// Calls visit(step), in radii, for what covers surface particle i at a wall: the fluid, its images
/// in the wall, and the boundary particles that lie well below the surface.
template <class Real, int Dimension, class View, class Boundary, class Radii, class Visit>
void visit_covering_at_wall(const View& view, const Boundary& boundary, const Radii& radii,
                            std::size_t i, const WallContact<Real, Dimension>& contact,
                            const Vector3& outward, double spacing, const Visit& visit) {
    const wall_contact::Continuation surface = wall_contact::continuation(contact, outward);
    const double per_distance = 2 / static_cast<double>(contact.sine);
    const auto visit_image = [&](const Vector3& step, double distance) {
        if (distance > 0)
            visit(sum(step, scaled(per_distance * distance, surface.into_wall)));
    };
    visit_image({0, 0, 0}, static_cast<double>(contact.distance));
    visit_fluid<Real, Dimension>(view, radii, i, [&](const Vector3& step) {
        double distance = static_cast<double>(contact.distance);
        for (std::size_t axis = 0; axis < Dimension; ++axis)
            distance += step[axis] * static_cast<double>(contact.normal[axis]);
        visit(step);
        visit_image(step, distance);
    });
    wall_contact::visit_boundary<Dimension>(
        boundary, i, radii, [&](const Vector3& step, double /*squared*/, std::size_t /*b*/) {
            if (dot(step, surface.normal) < -spacing / 2)
                visit(step);
        });
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
