// What walls add to densities. A wall is one layer of particles that stands for the fluid that
// would be behind it: with volumes of Akinci et al. 2012 (eq. 4) a lattice at rest one spacing off
// a flat wall has the density that it has inside. When fluid comes closer by d, its mirror image
// would come closer by 2 d, so the density by the wall must grow twice as fast as that of a layer
// that stays where it is; else the pressure at walls is twice the weight above. So each wall
// particle counts by a share of W that is 1 at one spacing and falls with the height over the
// wall's plane, which makes up for the difference. The share depends on the height alone, so walls
// stay as smooth as W makes them, and those of a corner add up. Densities and gradients remain of
// one function, which makes no energy.
#pragma once

#include "fluid.hpp"

#include <meniscus/runtime/surface/normals.hpp>

#include <cmath>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// What a lattice plane (in 2D a row) `layer` spacings away adds up to.
struct LayerSums {
    double value = 0; ///< of W
    double slope = 0; ///< of -dW/dx across the plane, per support radius
};

/// `spacing` in support radii.
template <class Real, int Dimension, class Kernel>
LayerSums layer_sums(const Kernel& kernel, double spacing, double layer) {
    const int reach = static_cast<int>(1 / spacing) + 1;
    const int reach_aside = Dimension == 3 ? reach : 0;
    LayerSums sums;
    for (int x = -reach; x <= reach; ++x)
        for (int y = -reach_aside; y <= reach_aside; ++y) {
            const auto squared = all_lanes<Lanes<Real>>(
                static_cast<Real>(spacing * spacing * (x * x + y * y + layer * layer)));
            sums.value += static_cast<double>(kernel.value(squared)[0]);
            sums.slope -= spacing * layer * static_cast<double>(kernel.gradient(squared)[0]);
        }
    return sums;
}

/// A flat wall of particles on a lattice, and what its layer counts.
template <class Real>
struct FlatWall {
    Real volume = 0; ///< of a particle, in support radii to the power of Dimension
    Real weight = 0; ///< sum_b' W_bb' times that: what psi_b is over 1 / sum_b' W_bb'
    WallShare<Real> share;
};

/// The volume makes up for all layers behind the first. The share's slope gives the first layer of
/// fluid twice the slope of those layers, and its end gives the second their density.
template <class Real, int Dimension, class Kernel>
FlatWall<Real> flat_wall(const Kernel& kernel, double spacing) {
    const int reach = static_cast<int>(1 / spacing) + 1;
    LayerSums behind;
    for (int layer = 1; layer <= reach; ++layer) {
        const LayerSums sums = layer_sums<Real, Dimension>(kernel, spacing, layer);
        behind.value += sums.value;
        behind.slope += sums.slope;
    }
    const LayerSums first = layer_sums<Real, Dimension>(kernel, spacing, 1);
    const LayerSums second = layer_sums<Real, Dimension>(kernel, spacing, 2);
    const double over_lattice = behind.value / first.value;
    const double volume = over_lattice * std::pow(spacing, Dimension);

    FlatWall<Real> wall;
    wall.volume = static_cast<Real>(volume);
    wall.weight = static_cast<Real>(volume * layer_sums<Real, Dimension>(kernel, spacing, 0).value);
    wall.share.inverse_spacing = static_cast<Real>(1 / spacing);
    wall.share.steepness =
        static_cast<Real>(spacing * (2 * behind.slope / over_lattice - first.slope) / first.value);
    const double rest = over_lattice * second.value;
    wall.share.far =
        static_cast<Real>(rest > 1e-6 * behind.value ? (behind.value - first.value) / rest : 0);
    return wall;
}

/// The share of W of eight wall particles, and its slope over the height, per support radius.
template <class Real>
struct ShareLanes {
    Lanes<Real> value;
    Lanes<Real> slope;
};

/// `height` over the walls' planes, in support radii; `flat`: 1 for particles of a plane, 0 for
/// those of edges, corners and crumbs, which count wholly as they are.
template <class Real>
MENISCUS_INLINE ShareLanes<Real> share_of(const WallShare<Real>& share, Lanes<Real> height,
                                          Lanes<Real> flat) {
    // Between one spacing and this much more a cubic takes the share to its end.
    constexpr Real reach = Real(0.25);
    const Lanes<Real> zero{};
    const Lanes<Real> one = all_lanes<Lanes<Real>>(1);
    const Lanes<Real> beyond = share.inverse_spacing * height - one; // in spacings
    const auto is_closer = beyond < zero;

    // Closer: 2 - 1 / (1 + s), which no impact makes larger than 2.
    const Lanes<Real> inside = one / (one - share.steepness * (is_closer ? beyond : zero));

    // Farther: Hermite's cubic.
    const Lanes<Real> t = smaller((1 / reach) * beyond, one);
    const Real start = -share.steepness * reach;
    const Real fall = share.far - 1;
    const Real square = 3 * fall - 2 * start;
    const Real cube = start - 2 * fall;
    const Lanes<Real> outside = one + t * (start + t * (square + t * cube));
    const Lanes<Real> falls = (1 / reach) * (start + t * (2 * square + t * (3 * cube)));

    const Lanes<Real> whole = is_closer ? Real(2) - inside : outside;
    const Lanes<Real> slope = is_closer ? -share.steepness * (inside * inside) : falls;
    return {one + flat * (whole - one), flat * (share.inverse_spacing * slope)};
}

/// What eight wall particles add to the density of the particle that `lanes` belong to, and to its
/// gradient: along_step (x_i - x_b) + along_normal (normal of b).
template <class Real>
struct WallLanes {
    Lanes<Real> density;
    Lanes<Real> along_step;
    Lanes<Real> along_normal;
    RowLanes<Real> normal;
};

template <class Real, int Dimension, class Kernel>
MENISCUS_INLINE WallLanes<Real> wall_lanes(const Fluid<Real, Dimension>& fluid,
                                           const Kernel& kernel,
                                           const NeighborLanes<Real, Dimension>& lanes) {
    WallLanes<Real> walls;
    walls.normal = gather_rows(fluid.wall_normal.data(), lanes.index);
    Lanes<Real> height = walls.normal.x * lanes.step[0] + walls.normal.y * lanes.step[1];
    if constexpr (Dimension == 3)
        height += walls.normal.z * lanes.step[2];
    const Lanes<Real> zero{};
    const auto is_below = height < zero; // a layer has two sides
    const ShareLanes<Real> share =
        share_of(fluid.wall_share, is_below ? -height : height, walls.normal.w);
    const Lanes<Real> whole = lanes.w * kernel.value(lanes.distance_squared);
    walls.density = whole * share.value;
    walls.along_step = lanes.w * kernel.gradient(lanes.distance_squared) * share.value;
    walls.along_normal = whole * (is_below ? -share.slope : share.slope);
    return walls;
}

/// The normal of wall particle b, out of the spread of those around it (`lists` of wall particles),
/// to either side; w: how flat they lie.
template <class Real, int Dimension, class Kernel>
Row<Real> wall_normal(const Fluid<Real, Dimension>& fluid, const LaneLists& lists, std::size_t b,
                      const Kernel& kernel) {
    Coordinates<Coordinates<double, Dimension>, Dimension> spread = {};
    visit_lists<Real, Dimension>(
        fluid.wall_place.data(), fluid.wall_place[b], lists, b,
        [&](const NeighborLanes<Real, Dimension>& lanes) {
            const Lanes<Real> w = kernel.value(lanes.distance_squared);
            // Squared, so that the other wall of a corner hardly turns it.
            for (int lane = 0; lane < lane_count; ++lane)
                for (std::size_t row = 0; row < Dimension; ++row)
                    for (std::size_t column = 0; column < Dimension; ++column)
                        spread[row][column] += static_cast<double>(
                            w[lane] * w[lane] * lanes.step[row][lane] * lanes.step[column][lane]);
        });
    const Vector3 normal = normals::minor_eigenvector<Dimension>(spread);
    double across = 0;
    double all = 0;
    for (std::size_t row = 0; row < Dimension; ++row) {
        all += spread[row][row];
        for (std::size_t column = 0; column < Dimension; ++column)
            across += normal[row] * spread[row][column] * normal[column];
    }
    // Of a spread that is the same in all directions, a Dimension-th lies across.
    const double flat = all > 0 ? std::max(0.0, 1 - 3 * Dimension * across / all) : 0;
    return {static_cast<Real>(normal[0]), static_cast<Real>(normal[1]),
            static_cast<Real>(Dimension == 3 ? normal[2] : 0), static_cast<Real>(flat)};
}

/// Sets the volumes, normals and shares of the wall particles, whose places and neighbors among
/// each other (`lists`) are known. Returns the density that an edge, whose particles count wholly,
/// has half a spacing away.
template <class Real, int Dimension>
Real weigh_walls(Fluid<Real, Dimension>& fluid, const LaneLists& lists) {
    const double spacing = fluid.spacing;
    return with_kernel<Real, Dimension>(fluid.kernel, [&](auto kernel) {
        const FlatWall<Real> flat = flat_wall<Real, Dimension>(kernel, spacing);
        fluid.wall_volume_share = flat.weight;
        fluid.wall_share = flat.share;
        const std::size_t count = fluid.wall_place.size() - 1;
        fluid.wall_normal.assign(count + 1, {});
        std::vector<Real> volumes(count);
        fluid.loop.each(count, [&](std::size_t b) {
            fluid.wall_normal[b] = wall_normal(fluid, lists, b, kernel);
            Lanes<Real> sum = kernel.value(Lanes<Real>{}) * Lanes<Real>{1, 0, 0, 0, 0, 0, 0, 0};
            visit_lists<Real, Dimension>(fluid.wall_place.data(), fluid.wall_place[b], lists, b,
                                         [&](const NeighborLanes<Real, Dimension>& lanes) {
                                             sum += kernel.value(lanes.distance_squared);
                                         });
            volumes[b] = flat.weight / sum_of_lanes(sum);
        });
        for (std::size_t b = 0; b < count; ++b)
            fluid.wall_place[b].w = volumes[b];
        return flat.volume *
               static_cast<Real>(layer_sums<Real, Dimension>(kernel, spacing, 0.5).value);
    });
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
