// The divergence of position, which an SPH sum of gradients gives (Lee et al. 2008): the trace of
// the matrix of gradient_eigenvalue.hpp. Over the particles in a volume h^D it is the dimension
// inside.
#pragma once

#include "../math/cubic_spline.hpp"
#include "feature_neighbor.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

struct PositionDivergence {
    static constexpr const char* name = "position_divergence";
    static constexpr const char* meaning = "-h^D sum_j grad W_ij (x_j - x_i), W the cubic spline";
    static constexpr double float_error = 5e-4;
    static constexpr bool is_fraction = false;
    static constexpr bool is_over_kernel = true;
    static constexpr bool is_eigenvalue = false;
    template <int Dimension>
    static constexpr int terms = 1;

    template <class Real, class Number, int Dimension>
    MENISCUS_HOST_DEVICE MENISCUS_INLINE static void
    add(const FeatureNeighbor<Number, Dimension>& neighbor, Number* sums) {
        constexpr auto scale = static_cast<Real>(cubic_spline_scale<Dimension>);
        const Number q = neighbor.distance();
        const Number slope = -CubicSplinePieces<Real, Number>(q).slope(scale) / q;
        sums[0] += neighbor.count * slope * neighbor.squared;
    }
    template <int Dimension, class Real>
    MENISCUS_HOST_DEVICE static Real value(const Real* sums) {
        return sums[0];
    }
};

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
