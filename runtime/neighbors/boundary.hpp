// Boundary (wall) particles as a host shows them: a view of their own beside that of the fluid.
// They cover, and where a classifier was trained so, they count in its features: a particle at a
// wall lacks neighbors there and is no surface for all that. One layer of boundary particles stands
// for the whole half-space behind it, so each counts as so many fluid particles as its volume
// holds,
//     w_b = V_b / V_0,   V_b = 1 / sum_b' W(x_b - x_b')
// (Akinci et al. 2012, eq. 4, over the boundary alone), V_0 = m / rho_0 being the volume of a fluid
// particle at rest. A host with Akinci's boundaries has it at hand: psi_b / m. A classifier says by
// which share of it they count, its boundary weight, since a layer is not the half-space; evidence
// is in docs/training.md.
#pragma once

#include "../simd/instruction_set.hpp"

#include <cstddef>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// A view without particles, for fluids without a boundary; costs nothing.
struct NoBoundary {
    static constexpr bool is_there = false;
    template <class Visit>
    void operator()(std::size_t /*i*/, Visit&& /*visit*/) const {}
};

/// A host's view of its boundary particles: view(i, visit) calls visit(b, x_b - x_i, w_b) for those
/// around fluid particle i. They are measured in the radius of i. A weight w_b that is not known
/// may be 1: more particles at walls are candidates then, and none is missed.
template <class View>
struct BoundaryView {
    static constexpr bool is_there = true;
    View view;
    /// The angle, in degrees from 10 to 170, at which a surface at rest meets the wall, by b;
    /// nullptr: that of the options for all.
    const float* contact_angles = nullptr;
    template <class Visit>
    void operator()(std::size_t i, Visit&& visit) const {
        view(i, visit);
    }
};

/// The contact angle at boundary particle b, in degrees; `usual` where the boundary has none of its
/// own.
template <class Boundary>
double contact_angle_at(const Boundary& /*boundary*/, std::size_t /*b*/, double usual) {
    return usual;
}
template <class View>
double contact_angle_at(const BoundaryView<View>& boundary, std::size_t b, double usual) {
    return boundary.contact_angles != nullptr ? static_cast<double>(boundary.contact_angles[b])
                                              : usual;
}

/// Another view of a boundary, whose particles count for a share of their volume: what a classifier
/// was trained with.
template <class Boundary, class Real>
struct WeightedBoundary {
    static constexpr bool is_there = true;
    const Boundary& boundary;
    Real share;
    template <class Visit>
    void operator()(std::size_t i, Visit&& visit) const {
        boundary(i, [&](std::size_t b, const auto& displacement, Real weight) {
            visit(b, displacement, share * weight);
        });
    }
};

template <class Boundary, class Real>
WeightedBoundary<Boundary, Real> times_weight(const Boundary& boundary, Real share) {
    return {boundary, share};
}
template <class Real>
NoBoundary times_weight(const NoBoundary& /*boundary*/, Real /*share*/) {
    return {};
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
