// Surface tension as a cohesion that turns into repulsion between close particles, and a force that
// evens out the normals (Akinci et al. 2013; Huber et al. 2015, eqs. 4 to 9):
//     a_i = -gamma sum_j K_ij (m_j C(|x_ij|) x_ij / |x_ij| + n_i - n_j)
//     K_ij = 2 rho_0 / (rho_i + rho_j)
//     n_i = h sum_j m_j / rho_j grad W_ij
//     C(r) = c / (pi h^(6 + D)) ((h - r)^3 r^3               where 2 r > h
//                                2 (h - r)^3 r^3 - h^6 / 64  elsewhere; 0 at 0 and beyond h)
// K belongs to the pair and stands in the sum. h is a factor in n alone. Gamma is one number for
// two terms of different units: m/s^2 beside the normals, m^4/(kg s^2) beside the cohesion. c is 32
// in 3D. The papers have no 2D: there c = 75840 / 1881, with which the integral of C over the disk
// is what it is over the ball in 3D, 237 / 1008. Walls attract by an adhesion of their own, with a
// coefficient beta of its own (Akinci et al. 2013, eqs. 6 and 7; h^(D + 1/4) for their h^3.25):
//     a_i = -beta sum_b psi_b A(|x_ib|) x_ib / |x_ib|
//     A(r) = 0.007 / h^3.25 (-4 r^2 / h + 6 r - 2 h)^(1/4)  where h / 2 < r < h, else 0
#pragma once

#include "tension_model.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// C(q) / q of eq. 5, in support radii; 0 at 1 and beyond.
template <class Real, int Dimension>
MENISCUS_INLINE Lanes<Real> akinci_cohesion(Lanes<Real> distance_squared) {
    constexpr Real factor = static_cast<Real>((Dimension == 2 ? 75840.0 / 1881 : 32.0) / pi);
    const Lanes<Real> one = all_lanes<Lanes<Real>>(1);
    const Lanes<Real> distance = square_root(distance_squared);
    const Lanes<Real> q = distance < one ? distance : one;
    const Lanes<Real> product = (one - q) * q;
    const Lanes<Real> cube = product * product * product;
    const Lanes<Real> spline = q > Real(0.5) ? cube : 2 * cube - Real(1.0 / 64);
    return factor * spline / larger(q, all_lanes<Lanes<Real>>(static_cast<Real>(min_distance)));
}

/// A(q) / q, in support radii.
template <class Real>
MENISCUS_INLINE Lanes<Real> akinci_adhesion(Lanes<Real> distance_squared) {
    const Lanes<Real> q = square_root(distance_squared);
    const Lanes<Real> inside = (4 * q - 2) * (1 - q); // -4 q^2 + 6 q - 2
    const Lanes<Real> root = square_root(square_root(larger(inside, Lanes<Real>{})));
    return Real(0.007) * root / larger(q, all_lanes<Lanes<Real>>(static_cast<Real>(min_distance)));
}

template <class Real, int Dimension>
class AkinciTension : public SurfaceTensionModel<Real, Dimension> {
public:
    using FluidType = Fluid<Real, Dimension>;
    using SurfaceTensionModel<Real, Dimension>::SurfaceTensionModel;

    static TensionModelRow row() {
        return {"akinci_2013", {"adhesion"}, read_adhesion, false, false};
    }

    void add_accelerations(FluidType& fluid) override {
        find_normals(fluid);
        const double gamma = this->options.coefficient;
        // Masses are in rho_0 h^D and C in 1 / h^D: rho_0 is what remains.
        const auto cohesion_factor = static_cast<Real>(fluid.units.rest_density) * fluid.mass;
        const auto factor = static_cast<Real>(-gamma / fluid.units.support_radius);
        fluid.loop.each(fluid.count, [&](std::size_t i) {
            const Row<Real> own = normal[i];
            VectorSum<Real, Dimension> sum;
            visit_neighbors(fluid, i, [&](const NeighborLanes<Real, Dimension>& lanes) {
                const RowLanes<Real> other = gather_rows(normal.data(), lanes.index);
                const Lanes<Real> zero{};
                // What fills the lanes up has a normal of zero, which is none.
                const Lanes<Real> correction =
                    lanes.distance_squared < Real(1) ? Real(2) / (own.w + other.w) : zero;
                const Lanes<Real> cohesion =
                    cohesion_factor * akinci_cohesion<Real, Dimension>(lanes.distance_squared);
                Lanes<Real> pull[Dimension];
                pull[0] = cohesion * lanes.step[0] + (own.x - other.x);
                pull[1] = cohesion * lanes.step[1] + (own.y - other.y);
                if constexpr (Dimension == 3)
                    pull[2] = cohesion * lanes.step[2] + (own.z - other.z);
                sum.add(correction, pull);
            });
            fluid.acceleration[i] = plus(fluid.acceleration[i], factor, sum.total());
        });
        if (this->options.adhesion > 0)
            add_adhesion(fluid);
    }

private:
    std::vector<Row<Real>> normal; ///< one more than particles; w: density

    void add_adhesion(FluidType& fluid) const {
        const auto factor = static_cast<Real>(-this->options.adhesion * fluid.units.rest_density /
                                              fluid.units.support_radius);
        fluid.loop.each(fluid.count, [&](std::size_t i) {
            VectorSum<Real, Dimension> sum;
            visit_walls(fluid, i, [&](const NeighborLanes<Real, Dimension>& lanes) {
                sum.add(lanes.w * akinci_adhesion<Real>(lanes.distance_squared), lanes.step);
            });
            fluid.acceleration[i] = plus(fluid.acceleration[i], factor, sum.total());
        });
    }

    void find_normals(FluidType& fluid) {
        normal.resize(fluid.count + 1);
        normal[fluid.count] = {0, 0, 0, 1};
        fluid.loop.each(fluid.count,
                        [&](std::size_t i) { fluid.place[i].w = fluid.mass / fluid.density[i]; });
        fluid.loop.each(fluid.count, [&](std::size_t i) {
            VectorSum<Real, Dimension> sum;
            visit_neighbors(fluid, i, [&](const NeighborLanes<Real, Dimension>& lanes) {
                sum.add(lanes.w * slopes_of(fluid, i, lanes), lanes.step);
            });
            normal[i] = sum.total();
            normal[i].w = fluid.density[i];
        });
    }
};

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
