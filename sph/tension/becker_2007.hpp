// Surface tension as cohesion between particles (Becker and Teschner 2007; Huber et al. 2015, eqs.
// 2 and 3): every pair pulls, by its distance times the kernel,
//     a_i = -phi / m_i sum_j m_j (x_i - x_j) W_ij
// so that phi is in m^3/s^2 (in 2D m^2/s^2). Particles are of one mass: each pair keeps its
// momentum.
#pragma once

#include "tension_model.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// -phi sum_j (x_i - x_j) W(max(|x_i - x_j|, least)) of each particle; `least` in support radii.
template <class Real, int Dimension>
void add_cohesion(double phi, Real min, Fluid<Real, Dimension>& fluid) {
    // x W h / h^D, and once more over h.
    const auto factor = static_cast<Real>(-phi / std::pow(fluid.units.support_radius, Dimension));
    const Lanes<Real> min_squared = all_lanes<Lanes<Real>>(min * min);
    with_kernel<Real, Dimension>(fluid.kernel, [&](auto kernel) {
        fluid.loop.each(fluid.count, [&](std::size_t i) {
            VectorSum<Real, Dimension> sum;
            visit_neighbors(fluid, i, [&](const NeighborLanes<Real, Dimension>& lanes) {
                sum.add(kernel.value(larger(lanes.distance_squared, min_squared)), lanes.step);
            });
            fluid.acceleration[i] = plus(fluid.acceleration[i], factor, sum.total());
        });
    });
}

template <class Real, int Dimension>
class BeckerTension : public SurfaceTensionModel<Real, Dimension> {
public:
    using SurfaceTensionModel<Real, Dimension>::SurfaceTensionModel;

    static TensionModelRow row() { return {"becker_2007", {}, nullptr, false, false}; }

    void add_accelerations(Fluid<Real, Dimension>& fluid) override {
        add_cohesion(this->options.coefficient, Real(0), fluid);
    }
};

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
