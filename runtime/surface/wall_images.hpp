// The surface continued into a wall (wall_contact.hpp), for sums over the surface particles around
// one: what lies beyond a contact line is missing there, and sums over one side alone are off. The
// line itself, where the normal is prescribed, the particle's own image and those of its neighbors
// on the surface stand in.
#pragma once

#include "surface_particles.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// A point of the surface beyond a contact line, or on it.
template <class Real, int Dimension>
struct WallImage {
    static constexpr std::size_t is_line = ~std::size_t{0};

    std::size_t slot;                  ///< whose image it is, or is_line
    Real weight;                       ///< W = 1 - |step|
    Coordinates<Real, Dimension> step; ///< from the particle, in radii
    Coordinates<Real, Dimension> normal;
};

namespace wall_images {

/// A normal seen in the wall: at the angle 2 theta - phi to the wall's normal in the place of phi.
template <class Real, int Dimension>
MENISCUS_INLINE Coordinates<Real, Dimension> image_of(const Coordinates<Real, Dimension>& normal,
                                                      const WallContact<Real, Dimension>& contact) {
    Real upward = 0;
    for (std::size_t axis = 0; axis < Dimension; ++axis)
        upward += normal[axis] * contact.normal[axis];
    const Real cosine = contact.cosine * contact.cosine - contact.sine * contact.sine;
    const Real sine = 2 * contact.cosine * contact.sine;
    const Real lean = std::sqrt((std::max)(1 - upward * upward, Real(0)));
    const Real image_upward = cosine * upward + sine * lean;
    // Of the part along the wall: sin(2 theta - phi) / sin(phi).
    const Real stretch =
        lean > static_cast<Real>(wall_contact::min_lean) ? sine * upward / lean - cosine : -cosine;
    Coordinates<Real, Dimension> image;
    for (std::size_t axis = 0; axis < Dimension; ++axis) {
        const Real along_wall = normal[axis] - upward * contact.normal[axis];
        image[axis] = stretch * along_wall + image_upward * contact.normal[axis];
    }
    return image;
}

} // namespace wall_images

/// How much an image weighs in averages: as the particle whose it is; the line in full.
template <class Real, int Dimension>
MENISCUS_INLINE Real weight_of(const SurfaceParticles<Real, Dimension>& list,
                               const WallImage<Real, Dimension>& image) {
    return image.slot == image.is_line ? Real(1) : list.weight[image.slot];
}

/// Calls visit(WallImage) for the images around the particle in a slot, which has a contact, where
/// the surface reaches the wall. `normals`: one a slot, of which the particle's own says how the
/// surface goes on.
template <class Real, int Dimension, class Visit>
void visit_wall_images(const SurfaceParticles<Real, Dimension>& list, std::size_t slot,
                       const std::vector<Coordinates<Real, Dimension>>& normals,
                       const Visit& visit) {
    using Vector = Coordinates<Real, Dimension>;
    const WallContact<Real, Dimension>& contact = list.contact[slot];
    const Vector& normal = normals[slot];
    const auto product_of = [](const Vector& a, const Vector& b) {
        Real sum = 0;
        for (std::size_t axis = 0; axis < Dimension; ++axis)
            sum += a[axis] * b[axis];
        return sum;
    };
    const Real upward = product_of(normal, contact.normal);
    const Real lean = std::sqrt((std::max)(1 - upward * upward, Real(0)));
    if (!(lean > contact.distance))
        return;
    Vector into_wall, line_normal; // along the surface; what the contact angle prescribes
    for (std::size_t axis = 0; axis < Dimension; ++axis) {
        const Real dry = (normal[axis] - upward * contact.normal[axis]) / lean;
        into_wall[axis] = (upward * normal[axis] - contact.normal[axis]) / lean;
        line_normal[axis] = contact.sine * dry + contact.cosine * contact.normal[axis];
    }
    const auto visit_one = [&](std::size_t of_slot, const Vector& beside, Real length,
                               const Vector& its_normal) {
        WallImage<Real, Dimension> image{of_slot, 0, beside, its_normal};
        for (std::size_t axis = 0; axis < Dimension; ++axis)
            image.step[axis] += length * into_wall[axis];
        const Real squared = product_of(image.step, image.step);
        if (!(squared < 1))
            return;
        image.weight = 1 - std::sqrt(squared);
        visit(image);
    };
    const Real to_line = contact.distance / lean;
    visit_one(WallImage<Real, Dimension>::is_line, Vector{}, to_line, line_normal);
    visit_one(slot, Vector{}, 2 * to_line, wall_images::image_of(normal, contact));
    const auto* pair = list.pairs.data() + list.pairs_begin[slot];
    for (const auto* last = pair + list.pairs_count[slot]; pair != last; ++pair) {
        const Real distance = contact.distance + product_of(pair->step, contact.normal);
        if (!(distance > 0))
            continue;
        Vector beside = {};
        if constexpr (Dimension == 3) {
            const Real along = product_of(pair->step, into_wall);
            const Real out = product_of(pair->step, normal);
            for (std::size_t axis = 0; axis < Dimension; ++axis)
                beside[axis] = pair->step[axis] - along * into_wall[axis] - out * normal[axis];
        }
        visit_one(pair->slot, beside, (contact.distance + distance) / lean,
                  wall_images::image_of(normals[pair->slot], contact));
    }
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
