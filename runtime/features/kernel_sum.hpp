// What SPH calls the density, without its unit: the sum of the cubic spline over neighbors and the
// particle itself. Over the particles in a volume h^D, it is their density over that of the fluid.
#pragma once

#include "../math/cubic_spline.hpp"
#include "feature_neighbor.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

struct KernelSum {
    static constexpr const char* name = "kernel_sum";
    static constexpr const char* meaning =
        "h^D sum_j W_ij, the particle itself among j, W the cubic spline";
    static constexpr double float_error = 1e-4;
    static constexpr bool is_fraction = false;
    static constexpr bool is_over_kernel = true;
    static constexpr bool is_eigenvalue = false;
    template <int Dimension>
    static constexpr int terms = 1;

    template <class Real, class Number, int Dimension>
    MENISCUS_HOST_DEVICE MENISCUS_INLINE static void
    add(const FeatureNeighbor<Number, Dimension>& neighbor, Number* sums) {
        constexpr auto scale = static_cast<Real>(cubic_spline_scale<Dimension>);
        const CubicSplinePieces<Real, Number> pieces(neighbor.distance());
        sums[0] += neighbor.count * pieces.value(scale);
    }
    template <int Dimension, class Real>
    MENISCUS_HOST_DEVICE static Real value(const Real* sums) {
        constexpr auto scale = static_cast<Real>(cubic_spline_scale<Dimension>);
        return sums[0] + CubicSplinePieces<Real, Real>(0).value(scale);
    }
};

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
