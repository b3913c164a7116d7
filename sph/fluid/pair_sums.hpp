// The three sums that pressure solvers are made of: density, the acceleration of a pressure field,
// and the compression that a velocity field causes. Walls at rest enter the last two by one vector
// a particle that does not change during a step (Fluid::wall_gradient), so that iterations cost
// nothing for them.
#pragma once

#include "wall_layer.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// Density of particle i over the rest density by fluid particles, itself included, m sum_j W_ij;
/// sets the slopes of its list, and lowers `nearest` to the squared distances of its neighbors.
template <class Real, int Dimension, class Kernel>
MENISCUS_INLINE Real fluid_density(const Fluid<Real, Dimension>& fluid, std::size_t i,
                                   const Kernel& kernel, Real* slopes, Lanes<Real>& nearest) {
    Lanes<Real> sum = kernel.value(Lanes<Real>{}) * Lanes<Real>{1, 0, 0, 0, 0, 0, 0, 0};
    visit_neighbors(fluid, i, [&](const NeighborLanes<Real, Dimension>& lanes) {
        sum += kernel.value(lanes.distance_squared);
        nearest = lanes.distance_squared < nearest ? lanes.distance_squared : nearest;
        store(kernel.gradient(lanes.distance_squared), slopes + lanes.at);
    });
    return fluid.mass * sum_of_lanes(sum);
}

/// What the walls around particle i add to its density, were it at `place` (Akinci et al. 2012,
/// eqs. 6 and 9, by the shares of wall_layer.hpp): the gradient, and in w the density itself.
template <class Real, int Dimension, class Kernel>
MENISCUS_INLINE Row<Real> wall_sums(const Fluid<Real, Dimension>& fluid, std::size_t i,
                                    const Row<Real>& place, const Kernel& kernel) {
    Lanes<Real> density{};
    VectorSum<Real, Dimension> gradient;
    visit_lists<Real, Dimension>(fluid.wall_place.data(), place, fluid.wall_neighbors, i,
                                 [&](const NeighborLanes<Real, Dimension>& lanes) {
                                     const WallLanes<Real> walls = wall_lanes(fluid, kernel, lanes);
                                     density += walls.density;
                                     gradient.add(walls.along_step, lanes.step);
                                     gradient.sum[0] += walls.along_normal * walls.normal.x;
                                     gradient.sum[1] += walls.along_normal * walls.normal.y;
                                     if constexpr (Dimension == 3)
                                         gradient.sum[2] += walls.along_normal * walls.normal.z;
                                 });
    Row<Real> sums = gradient.total();
    sums.w = sum_of_lanes(density);
    return sums;
}

/// The same where walls count wholly.
template <class Real, int Dimension, class Kernel>
MENISCUS_INLINE Row<Real> whole_wall_sums(const Fluid<Real, Dimension>& fluid, std::size_t i,
                                          const Kernel& kernel) {
    Lanes<Real> density{};
    VectorSum<Real, Dimension> gradient;
    visit_walls(fluid, i, [&](const NeighborLanes<Real, Dimension>& lanes) {
        density += lanes.w * kernel.value(lanes.distance_squared);
        gradient.add(lanes.w * kernel.gradient(lanes.distance_squared), lanes.step);
    });
    Row<Real> sums = gradient.total();
    sums.w = sum_of_lanes(density);
    return sums;
}

/// Sets densities (also beside the velocities), what walls contribute, and slopes. Returns whether
/// two particles lie in one place.
template <class Real, int Dimension>
bool find_densities(Fluid<Real, Dimension>& fluid) {
    std::vector<std::uint8_t> has_coincident(fluid.count / ParticleLoop::part_size + 1, 0);
    fluid.slopes.resize(fluid.count);
    fluid.slope_buffers.resize(fluid.count / ParticleLoop::part_size + 1);
    with_kernel<Real, Dimension>(fluid.kernel, [&](auto kernel) {
        fluid.loop.each_part(fluid.count, [&](std::size_t part, std::size_t begin,
                                              std::size_t end) {
            std::size_t pairs = 0;
            for (std::size_t i = begin; i < end; ++i)
                pairs += fluid.neighbors.padded_count(i);
            std::vector<Real>& buffer = fluid.slope_buffers[part];
            buffer.resize(std::max(buffer.size(), pairs));
            Real* slopes = buffer.data();
            Lanes<Real> nearest = all_lanes<Lanes<Real>>(1);
            for (std::size_t i = begin; i < end; ++i) {
                fluid.slopes[i] = slopes;
                fluid.wall_gradient[i] = wall_sums(fluid, i, fluid.place[i], kernel);
                fluid.wall_density[i] = fluid.wall_gradient[i].w;
                fluid.wall_ahead[i] = whole_wall_sums(fluid, i, kernel);
                fluid.density[i] =
                    fluid_density(fluid, i, kernel, slopes, nearest) + fluid.wall_density[i];
                fluid.velocity[i].w = fluid.density[i];
                slopes += fluid.neighbors.padded_count(i);
            }
            has_coincident[part] =
                bits_below(nearest, all_lanes<Lanes<Real>>(std::numeric_limits<Real>::min())) != 0;
        });
    });
    return std::any_of(has_coincident.begin(), has_coincident.end(),
                       [](std::uint8_t one) { return one != 0; });
}

/// -m sum_j (s_i + s_j) grad W_ij, s being the w of the particles' places, and the walls' part:
/// with s = p / rho^2 the acceleration by pressure p that keeps momentum (Akinci et al. 2012, eq.
/// 10 for the walls).
template <class Real, int Dimension>
MENISCUS_INLINE Row<Real> pressure_acceleration(const Fluid<Real, Dimension>& fluid,
                                                std::size_t i) {
    const Real own = fluid.place[i].w;
    VectorSum<Real, Dimension> sum;
    visit_neighbors(fluid, i, [&](const NeighborLanes<Real, Dimension>& lanes) {
        sum.add((own + lanes.w) * slopes_of(fluid, i, lanes), lanes.step);
    });
    const Row<Real> pairs = sum.total();
    const Row<Real>& wall = fluid.wall_gradient[i];
    return {-(fluid.mass * pairs.x + own * wall.x), -(fluid.mass * pairs.y + own * wall.y),
            -(fluid.mass * pairs.z + own * wall.z), 0};
}

/// m sum_j (u_i - u_j) . grad W_ij and the walls' part, walls being at rest: how fast the
/// velocities u (one more row than particles) raise the density of particle i, over the rest
/// density, in 1/s.
template <class Real, int Dimension>
MENISCUS_INLINE Real compression_rate(const Fluid<Real, Dimension>& fluid,
                                      const std::vector<Row<Real>>& u, std::size_t i) {
    const Row<Real> own = u[i];
    Lanes<Real> sum{};
    visit_neighbors(fluid, i, [&](const NeighborLanes<Real, Dimension>& lanes) {
        const RowLanes<Real> other = gather_rows(u.data(), lanes.index);
        Lanes<Real> approach =
            (own.x - other.x) * lanes.step[0] + (own.y - other.y) * lanes.step[1];
        if constexpr (Dimension == 3)
            approach += (own.z - other.z) * lanes.step[2];
        sum += approach * slopes_of(fluid, i, lanes);
    });
    return fluid.mass * sum_of_lanes(sum) + dot_rows(own, fluid.wall_gradient[i]);
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
