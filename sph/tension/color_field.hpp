// Surface tension by the curvature of a smoothed color field (Mueller et al. 2003, section 3.3):
//     c_i = sum_j m_j / rho_j W_ij,   n = grad c,   a_i = -sigma / rho_i lap c_i n_i / |n_i|
// where |n| is above a threshold, and 0 elsewhere. n points into the fluid and lap c / |n| is minus
// the sum of the principal curvatures. Sigma is in N/m. Momentum is not kept.
//
// Gradient and Laplacian are those of the kernel that smooths c, of the cubic spline or of poly6:
// Mueller et al. have the spiky kernel for pressure alone. The Laplacian of W(|x|) is
// W'' + (D - 1) W' / q; in support radii
//     poly6   W' / q = -6 p (1 - q^2)^2,  lap W = -6 p (1 - q^2) (D - (D + 4) q^2)
//     cubic   W' / q = s (18 q - 12) below 1/2, -6 s (1 - q)^2 / q from there to 1
//             W'' = s (36 q - 12) below 1/2, 12 s (1 - q) from there to 1
// and i itself counts, with lap W(0) = -6 D p or -12 D s.
#pragma once

#include "tension_model.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// The least |grad c| of a surface, times h; at a flat one it is 1.2 to 1.4. The papers leave it
/// open.
inline constexpr double min_color_gradient = 0.1;

/// Gradient (W' / q) and Laplacian of a kernel's value().
template <class Real>
struct ColorDerivatives {
    Lanes<Real> gradient;
    Lanes<Real> laplacian;
};

template <class Real, int Dimension>
MENISCUS_INLINE ColorDerivatives<Real>
color_derivatives(const MuellerKernels<Real, Dimension>& kernel, Lanes<Real> distance_squared) {
    const Lanes<Real> inside = larger(Real(1) - distance_squared, Lanes<Real>{});
    const Lanes<Real> scaled = (-6 * kernel.poly6) * inside;
    return {scaled * inside, scaled * (Real(Dimension) - Real(Dimension + 4) * distance_squared)};
}

template <class Real, int Dimension>
MENISCUS_INLINE ColorDerivatives<Real> color_derivatives(const CubicSpline<Real, Dimension>& kernel,
                                                         Lanes<Real> distance_squared) {
    const Lanes<Real> q = square_root(distance_squared);
    const Lanes<Real> half = all_lanes<Lanes<Real>>(Real(0.5));
    const Lanes<Real> outer = larger(Real(1) - q, Lanes<Real>{});
    const Lanes<Real> slope = q < half ? 18 * q - Real(12) : -6 * (outer * outer) / larger(q, half);
    const Lanes<Real> bend = q < half ? 36 * q - Real(12) : 12 * outer;
    return {kernel.sigma * slope, kernel.sigma * (bend + Real(Dimension - 1) * slope)};
}

/// The color field around a particle.
template <class Real>
struct ColorField {
    Row<Real> gradient; ///< times h; points into the fluid
    Real laplacian;     ///< times h^2
};

/// Of particle i; places must hold the volumes m / rho beside them.
template <class Real, int Dimension, class Kernel>
MENISCUS_INLINE ColorField<Real> color_field_at(const Fluid<Real, Dimension>& fluid, std::size_t i,
                                                const Kernel& kernel) {
    const Lanes<Real> first{1, 0, 0, 0, 0, 0, 0, 0};
    VectorSum<Real, Dimension> gradient;
    Lanes<Real> laplacian =
        first * fluid.place[i].w * color_derivatives(kernel, Lanes<Real>{}).laplacian;
    visit_neighbors(fluid, i, [&](const NeighborLanes<Real, Dimension>& lanes) {
        const auto derivatives = color_derivatives(kernel, lanes.distance_squared);
        gradient.add(lanes.w * derivatives.gradient, lanes.step);
        laplacian += lanes.w * derivatives.laplacian;
    });
    return {gradient.total(), sum_of_lanes(laplacian)};
}

template <class Real, int Dimension>
class ColorFieldTension : public SurfaceTensionModel<Real, Dimension> {
public:
    using FluidType = Fluid<Real, Dimension>;
    using SurfaceTensionModel<Real, Dimension>::SurfaceTensionModel;

    static TensionModelRow row() { return {"color_field", {}, nullptr, true, false}; }

    void add_accelerations(FluidType& fluid) override {
        fluid.loop.each(fluid.count,
                        [&](std::size_t i) { fluid.place[i].w = fluid.mass / fluid.density[i]; });
        const double h = fluid.units.support_radius;
        const auto sigma =
            static_cast<Real>(this->options.coefficient / (fluid.units.rest_density * h * h * h));
        with_kernel<Real, Dimension>(fluid.kernel, [&](auto kernel) {
            fluid.loop.each(fluid.count, [&](std::size_t i) {
                const auto [normal, laplacian] = color_field_at(fluid, i, kernel);
                const Real length = std::sqrt(dot_rows(normal, normal));
                if (length > static_cast<Real>(min_color_gradient))
                    fluid.acceleration[i] =
                        plus(fluid.acceleration[i],
                             -sigma * laplacian / (fluid.density[i] * length), normal);
            });
        });
    }
};

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
