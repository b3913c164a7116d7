// How well the neighbors resolve a gradient in the direction that they resolve worst: the smallest
// eigenvalue of the renormalization matrix (Marrone et al. 2010). Over the particles in a volume
// h^D it is 1 inside and falls towards the surface.
#pragma once

#include "../math/cubic_spline.hpp"
#include "feature_neighbor.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

struct GradientEigenvalue {
    static constexpr const char* name = "gradient_eigenvalue";
    static constexpr const char* meaning =
        "smallest eigenvalue of -h^D sum_j grad W_ij (x_j - x_i)^T, W the cubic spline";
    static constexpr double float_error = 5e-4;
    static constexpr bool is_fraction = false;
    static constexpr bool is_over_kernel = true;
    static constexpr bool is_eigenvalue = true;
    template <int Dimension>
    static constexpr int terms = matrix_terms<Dimension>;

    template <class Real, class Number, int Dimension>
    MENISCUS_HOST_DEVICE MENISCUS_INLINE static void
    add(const FeatureNeighbor<Number, Dimension>& neighbor, Number* sums) {
        constexpr auto scale = static_cast<Real>(cubic_spline_scale<Dimension>);
        const Number q = neighbor.distance();
        const Number slope = -CubicSplinePieces<Real, Number>(q).slope(scale) / q;
        add_to_matrix<Number, Dimension>(neighbor, neighbor.count * slope, sums);
    }
    template <int Dimension, class Real>
    MENISCUS_HOST_DEVICE static Real value(const Real* sums) {
        return min_eigenvalue<Dimension>(sums);
    }
};

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
