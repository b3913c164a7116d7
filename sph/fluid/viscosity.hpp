// Viscosity by the standard SPH form (Morris et al. 1997; Monaghan 2005, eq. 8.12)
//     a_i = 2 (D + 2) nu sum_j m / rho_ij (v_ij . x_ij) / (|x_ij|^2 + 0.01 h^2) grad W_ij
// with rho_ij the mean of the two densities, so that each pair keeps its momentum; where asked,
// times K_ij = 2 rho_0 / (rho_i + rho_j) (Huber et al. 2015, eq. 9). And XSPH, which moves each
// velocity towards those around it: v_i + c sum_j m / rho_ij (v_j - v_i) W_ij.
#pragma once

#include "fluid.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// Adds to the accelerations.
template <class Real, int Dimension>
void add_viscosity(const ViscosityOptions& options, Fluid<Real, Dimension>& fluid) {
    if (options.kinematic == 0)
        return;
    const double h = fluid.units.support_radius;
    const auto factor =
        static_cast<Real>(2 * (Dimension + 2) * options.kinematic / (h * h)) * fluid.mass;
    fluid.loop.each(fluid.count, [&](std::size_t i) {
        const Row<Real> own = fluid.velocity[i];
        VectorSum<Real, Dimension> sum;
        visit_neighbors(fluid, i, [&](const NeighborLanes<Real, Dimension>& lanes) {
            const RowLanes<Real> other = gather_rows(fluid.velocity.data(), lanes.index);
            Lanes<Real> approach =
                (own.x - other.x) * lanes.step[0] + (own.y - other.y) * lanes.step[1];
            if constexpr (Dimension == 3)
                approach += (own.z - other.z) * lanes.step[2];
            const Lanes<Real> correction =
                Real(2) / (fluid.density[i] + other.w); // 1 / rho_ij, and K_ij
            Lanes<Real> size = approach * correction / (lanes.distance_squared + Real(0.01));
            if (options.density_correction)
                size *= correction;
            sum.add(size * slopes_of(fluid, i, lanes), lanes.step);
        });
        fluid.acceleration[i] = plus(fluid.acceleration[i], factor, sum.total());
    });
}

/// Fills `smoothed` with the velocities after XSPH; the last row stays that of the fluid.
template <class Real, int Dimension>
void smooth_velocities(Real share, const Fluid<Real, Dimension>& fluid,
                       std::vector<Row<Real>>& smoothed) {
    smoothed.resize(fluid.count + 1);
    smoothed[fluid.count] = fluid.velocity[fluid.count];
    with_kernel<Real, Dimension>(fluid.kernel, [&](auto kernel) {
        fluid.loop.each(fluid.count, [&](std::size_t i) {
            const Row<Real> own = fluid.velocity[i];
            VectorSum<Real, Dimension> sum;
            visit_neighbors(fluid, i, [&](const NeighborLanes<Real, Dimension>& lanes) {
                const RowLanes<Real> other = gather_rows(fluid.velocity.data(), lanes.index);
                const Lanes<Real> weight =
                    Real(2) / (fluid.density[i] + other.w) * kernel.value(lanes.distance_squared);
                Lanes<Real> difference[Dimension];
                difference[0] = other.x - own.x;
                difference[1] = other.y - own.y;
                if constexpr (Dimension == 3)
                    difference[2] = other.z - own.z;
                sum.add(weight, difference);
            });
            smoothed[i] = plus(own, share * fluid.mass, sum.total());
        });
    });
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
