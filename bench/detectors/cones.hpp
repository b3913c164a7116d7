// What lies in front of a particle, on the side that a vector points to: a particle that has a
// neighbor in a cone around that vector is covered, one that has none there is at the surface. The
// vector points outward; the cones differ from paper to paper.
#pragma once

#include "renormalization.hpp"

#include <meniscus/classifier/detectors/cones.hpp>

namespace meniscus {

/// Whether a neighbor of particle i lies in the cone around `outward`: where cone(step, normal),
/// step being x_j - x_i in m and normal of length 1, says so. A particle whose vector vanishes or
/// is not finite cannot be shown to be covered, nor is it by others in its place.
template <class Real, int Dimension, class Cone>
bool is_covered(const FluidState<Real>& state, std::size_t i,
                const Vector<Real, Dimension>& outward, const Cone& cone) {
    const Real norm = outward.norm();
    if (!(norm > 0))
        return false;
    const Vector<Real, Dimension> normal = outward / norm;
    using Place = Eigen::Map<const Vector<Real, Dimension>>;
    const Place own(state.positions.data() + Dimension * i);
    for (std::size_t n = state.lists.offsets[i]; n < state.lists.offsets[i + 1]; ++n) {
        const std::size_t j = state.lists.neighbors[n];
        const Vector<Real, Dimension> step = Place(state.positions.data() + Dimension * j) - own;
        if (step.squaredNorm() > 0 && cone(step, normal))
            return true;
    }
    return false;
}

/// The state's umbrella. A smoothing length is half the support radius, as for the kernels that
/// solvers use most (cubic spline, Wendland); it then reaches exactly as far as the neighbor lists.
template <class Real>
Umbrella<Real> umbrella(const FluidState<Real>& state) {
    return {state.support_radius / 2};
}

/// A plain cone as long as the lists reach.
template <class Real>
struct OpenCone {
    Real cosine; ///< of the angle between its axis and its side, at most 90 degrees

    template <int Dimension>
    bool operator()(const Vector<Real, Dimension>& step,
                    const Vector<Real, Dimension>& normal) const {
        return step.dot(normal) >= cosine * step.norm();
    }
};

} // namespace meniscus
