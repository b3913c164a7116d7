// Ripples are capillary waves as short as the spacing of particles: single particles that move in
// and out of the surface around them. Normals and curvature are means over more particles than such
// a wave has, so its force is not what the surface would have, and in a fluid as thin as water it
// gains energy from step to step until particles fly. Nothing real is lost with ripples: particles
// do not resolve them. So surface particles have friction against motion along their normals that
// those around them do not share. It takes energy, keeps momentum, and leaves a body that turns as
// it is. Longer waves feel little of it: it falls with the fourth power of their length.
#pragma once

#include <meniscus/runtime/math/cubic_spline.hpp>
#include <meniscus/runtime/surface/normals.hpp>
#include <meniscus/sph/fluid/fluid.hpp>

#include <cmath>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// What the weights of pairs add up to around a particle of a flat surface on a lattice, itself
/// left out; `spacing` in support radii.
template <int Dimension>
double sheet_weight(double spacing) {
    const int reach = static_cast<int>(1 / spacing) + 1;
    const int reach_aside = Dimension == 3 ? reach : 0;
    double sum = -1;
    for (int x = -reach; x <= reach; ++x)
        for (int y = -reach_aside; y <= reach_aside; ++y)
            sum += cubic_spline(spacing * std::sqrt(static_cast<double>(x * x + y * y)));
    return sum;
}

/// Calls visit(slot of the neighbor, weight) for the surface particles around the one in `slot`;
/// weights are the same from both sides.
template <class Real, int Dimension, class Visit>
void visit_sheet(const SurfaceParticles<Real, Dimension>& surface, std::size_t slot,
                 const Visit& visit) {
    const auto* pair = surface.pairs.data() + surface.pairs_begin[slot];
    for (const auto* last = pair + surface.pairs_count[slot]; pair != last; ++pair) {
        const Real facing =
            product<Real, Dimension>(surface.normal[slot], surface.normal[pair->slot]);
        const Real weight = surface.weight[slot] * surface.weight[pair->slot];
        if (!(facing > 0 && weight > 0))
            continue; // the two sides of a film, and what is covered
        const Real distance = std::sqrt(product<Real, Dimension>(pair->step, pair->step));
        visit(pair->slot, weight * cubic_spline(distance));
    }
}

/// Slows ripples down: the speed of each surface particle along its normal over the mean of those
/// around, taken twice, as the bending of a plate is. `damping` is the friction over
/// sqrt(sigma rho spacing), N s/m^2 (in 2D N s/m); up to 0.5 is stable within the step of capillary
/// waves, sqrt(rho spacing^3 / (2 pi sigma)). `surface_tension` in the step's units, `spacing` in
/// support radii; `speeds` is memory.
template <class Real, int Dimension>
void damp_ripples(const SurfaceParticles<Real, Dimension>& surface, double damping,
                  double surface_tension, double spacing, Fluid<Real, Dimension>& fluid,
                  std::vector<Real>& speeds) {
    const double around = sheet_weight<Dimension>(spacing);
    if (damping == 0 || !(around > 0))
        return;
    const auto rate = static_cast<Real>(
        damping * std::sqrt(surface_tension / (spacing * spacing * spacing)) / (around * around));
    speeds.resize(surface.size());
    fluid.loop.each(surface.size(), [&](std::size_t slot) {
        const Row<Real>& own = fluid.velocity[surface.particle[slot]];
        Row<Real> sum{};
        visit_sheet(surface, slot, [&](std::uint32_t other, Real weight) {
            const Row<Real>& velocity = fluid.velocity[surface.particle[other]];
            sum = plus(sum, weight, plus(own, Real(-1), velocity));
        });
        const auto& normal = surface.normal[slot];
        speeds[slot] = normal[0] * sum.x + normal[1] * sum.y;
        if constexpr (Dimension == 3)
            speeds[slot] += normal[2] * sum.z;
    });
    fluid.loop.each(surface.size(), [&](std::size_t slot) {
        Coordinates<Real, Dimension> sum = {};
        visit_sheet(surface, slot, [&](std::uint32_t other, Real weight) {
            for (std::size_t axis = 0; axis < Dimension; ++axis)
                sum[axis] += weight * (speeds[slot] * surface.normal[slot][axis] -
                                       speeds[other] * surface.normal[other][axis]);
        });
        const Row<Real> row{sum[0], sum[1], Dimension == 3 ? sum[Dimension - 1] : Real(0), 0};
        Row<Real>& acceleration = fluid.acceleration[surface.particle[slot]];
        acceleration = plus(acceleration, -rate, row);
    });
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
