// Cones in front of a particle. A free-surface detector that has a vector pointing out of the fluid
// looks along it: a neighbor in the cone covers the particle. The cones differ from paper to paper.
#pragma once

#include <Eigen/Core>

namespace meniscus {

template <class Real, int Dimension>
using Vector = Eigen::Matrix<Real, Dimension, 1>;

/// Marrone et al. 2010: a cone of 45 degrees to each side that ends in a ball.
template <class Real>
struct Umbrella {
    Real length; ///< smoothing length in m

    template <int Dimension>
    bool operator()(const Vector<Real, Dimension>& step,
                    const Vector<Real, Dimension>& normal) const {
        const Real squared = step.squaredNorm();
        const Real height = step.dot(normal);
        if (height <= 0)
            return false;
        // In the cone, or beyond it in the ball around the point one length in front:
        // |step - length normal| < length.
        return squared < 2 * length * length ? 2 * height * height > squared
                                             : squared < 2 * length * height;
    }
};

/// DualSPHysics' umbrella in the plane. Up to sqrt(2) lengths Marrone et al. have the distances
/// along the normal and across it, where the program multiplies axis by axis. For a normal along an
/// axis it is the same cone; for one between them, a disc.
template <class Real>
struct AxiswiseUmbrella {
    Real length; ///< smoothing length in m

    bool operator()(const Vector<Real, 2>& step, const Vector<Real, 2>& normal) const {
        const Vector<Real, 2> off = step - length * normal;
        if (step.squaredNorm() > 2 * length * length)
            return off.squaredNorm() < length * length;
        const Vector<Real, 2> across(normal[1], normal[0]);
        return off.cwiseProduct(normal).norm() + off.cwiseProduct(across).norm() < length;
    }
};

} // namespace meniscus
