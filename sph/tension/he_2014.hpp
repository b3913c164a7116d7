// Surface tension by the energy kappa / 2 |grad c|^2 of a smoothed color field, 1 in the fluid and
// 0 outside (He et al. 2014; Huber et al. 2015, eqs. 10 to 12, the sum of eq. 12 being over j):
//     a_i = kappa / (2 m_i) sum_j V_i V_j (|grad c_i|^2 + |grad c_j|^2) / 2 grad W_ij
//     grad c_i = sum_j V_j grad W_ij / sum_j V_j W_ij,   V_j = m_j / rho_j
// with i itself in the sum below the line. Kappa is in N. Each pair keeps its momentum.
#pragma once

#include "tension_model.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

template <class Real, int Dimension>
class HeTension : public SurfaceTensionModel<Real, Dimension> {
public:
    using FluidType = Fluid<Real, Dimension>;
    using SurfaceTensionModel<Real, Dimension>::SurfaceTensionModel;

    static TensionModelRow row() { return {"he_2014", {}, nullptr, false, false}; }

    void add_accelerations(FluidType& fluid) override {
        find_energies(fluid);
        // V V / m |grad c|^2 grad W is h^(2 D - D - 2 - D - 1) / rho_0, and once more over h.
        const double h = fluid.units.support_radius;
        const double mass = static_cast<double>(fluid.mass);
        const auto factor = static_cast<Real>(
            this->options.coefficient / (4 * fluid.units.rest_density * h * h * h * h * mass));
        fluid.loop.each(fluid.count, [&](std::size_t i) {
            VectorSum<Real, Dimension> sum;
            visit_neighbors(fluid, i, [&](const NeighborLanes<Real, Dimension>& lanes) {
                const Lanes<Real> volumes = fluid.place[i].w * lanes.w;
                const Lanes<Real> energies =
                    energy[i] + gather<Lanes<Real>>(energy.data(), lanes.index);
                sum.add(volumes * energies * slopes_of(fluid, i, lanes), lanes.step);
            });
            fluid.acceleration[i] = plus(fluid.acceleration[i], factor, sum.total());
        });
    }

private:
    std::vector<Real> energy; ///< |grad c|^2; one more than particles

    /// And leaves the volumes beside the places.
    void find_energies(FluidType& fluid) {
        energy.resize(fluid.count + 1);
        energy[fluid.count] = 0;
        fluid.loop.each(fluid.count,
                        [&](std::size_t i) { fluid.place[i].w = fluid.mass / fluid.density[i]; });
        with_kernel<Real, Dimension>(fluid.kernel, [&](auto kernel) {
            fluid.loop.each(fluid.count, [&](std::size_t i) {
                Lanes<Real> share = fluid.place[i].w * kernel.value(Lanes<Real>{}) *
                                    Lanes<Real>{1, 0, 0, 0, 0, 0, 0, 0};
                VectorSum<Real, Dimension> sum;
                visit_neighbors(fluid, i, [&](const NeighborLanes<Real, Dimension>& lanes) {
                    share += lanes.w * kernel.value(lanes.distance_squared);
                    sum.add(lanes.w * slopes_of(fluid, i, lanes), lanes.step);
                });
                const Row<Real> gradient = sum.total();
                const Real all = sum_of_lanes(share);
                energy[i] = dot_rows(gradient, gradient) / (all * all);
            });
        });
    }
};

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
