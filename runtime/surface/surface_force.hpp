// The force of surface tension on the surface particles.
//
// Two forms. The paper's: -sigma kappa n (2020 paper, section 3), a force per area, here times the
// face of a particle, its volume to the power (D - 1) / D; sigma is then a parameter to be tuned,
// as it is in the paper. The calibrated one, in which sigma in N/m means what it says: the
// Young-Laplace law puts the pressure (D - 1) sigma kappa on each piece of the surface, since the
// sum of the principal curvatures counts and kappa is their mean, and each particle carries the
// piece
//     A_i = e_i / sum_j e_j K(x_j - x_i)
// of the sheet through the outermost particles: K is a kernel on the sheet whose integral is 1, the
// sum runs over i itself and the surface particles on its side, and e is the exposure, so that
// pieces go to those who stand out: pushed in as much as the others, a particle that lies in a
// dimple stays there, and a droplet keeps its dents. The fluid's surface lies half a spacing
// outside of that sheet and is larger by (1 + kappa_sheet spacing / 2)^(D - 1). In two dimensions
// forces are per depth, N/m.
//
// Both forms may add the pressure of the air, p_0 = `ambient_pressure` (D - 1) sigma / h, on the
// same pieces. It changes nothing but the zero of the fluid's pressure, which is what it is for:
// below a hollow surface, and where fluid hangs higher than its level, pressure is lower than that
// of the air, and a solver that clips what is below zero lets such fluid fall.
#pragma once

#include "curvature_map.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

namespace surface_force {

/// The integral of W = 1 - r / h over the sheet, in units of h^(D - 1).
template <int Dimension>
constexpr double kernel_integral = Dimension == 2 ? 1.0 : pi / 3;

/// A length to the power D - 1.
template <int Dimension, class Real>
MENISCUS_HOST_DEVICE MENISCUS_INLINE Real to_area(Real length) {
    return Dimension == 2 ? length : length * length;
}

/// Part of the sheet that the particle in a slot carries, in units of h^(D - 1).
template <class Real, int Dimension>
MENISCUS_INLINE Real sheet_area(const SurfaceParticles<Real, Dimension>& list, std::size_t slot) {
    const Real own = list.exposure[slot];
    Real sum = own;
    const auto* pair = list.pairs.data() + list.pairs_begin[slot];
    for (const auto* last = pair + list.pairs_count[slot]; pair != last; ++pair) {
        const Real side = product<Real, Dimension>(list.normal[slot], list.normal[pair->slot]);
        // Whether it faces the same way is for no branch to guess, hence the product.
        sum += static_cast<Real>(side > 0) * (list.exposure[pair->slot] * pair->weight);
    }
    if (list.contact[slot].is_there())
        visit_wall_images(list, slot, list.normal, [&](const auto& image) {
            const Real side = product<Real, Dimension>(list.normal[slot], image.normal);
            if (image.slot != image.is_line && side > 0)
                sum += list.exposure[image.slot] * image.weight;
        });
    constexpr auto scale = static_cast<Real>(kernel_integral<Dimension>);
    return own > 0 ? scale * own / sum : 0;
}

/// Size of the paper's force on a particle of that curvature (1/m), spacing (m) and weight.
template <int Dimension, class Real>
MENISCUS_HOST_DEVICE MENISCUS_INLINE Real paper_size(Real sigma, Real curvature, Real spacing,
                                                     Real weight) {
    return sigma * curvature * to_area<Dimension>(spacing) * weight;
}

/// Size of the calibrated force: `area` is the part of the sheet that the particle carries, in
/// units of h^(D - 1), `turning` of the normals and `curvature` in 1/m.
template <int Dimension, class Real>
MENISCUS_HOST_DEVICE MENISCUS_INLINE Real calibrated_size(Real sigma, Real curvature, Real turning,
                                                          Real area, Real radius, Real spacing) {
    const Real stretch = 1 + turning * spacing / 2;
    return (Dimension - 1) * (sigma * curvature) * area * to_area<Dimension>(radius * stretch);
}

} // namespace surface_force

/// Sets the force on each surface particle from its normal and its curvature; 0 where covered.
template <class Real, int Dimension, class Radii, class Loop>
void find_force(const SurfaceTensionOptions& options, const Radii& radii, const Loop& loop,
                SurfaceParticles<Real, Dimension>& list) {
    using namespace surface_force;
    const auto sigma = static_cast<Real>(options.surface_tension);
    const auto to_spacing = static_cast<Real>(1 / options.spacing_ratio);
    const auto ambient = static_cast<Real>(options.ambient_pressure);
    loop(list.size(), [&](std::size_t begin, std::size_t end, int /*worker*/) {
        for (std::size_t slot = begin; slot < end; ++slot) {
            const Real radius = radii.of(list.particle[slot]);
            const Real spacing = radius * to_spacing;
            const Real curvature = list.curvature[slot];
            const Real air = ambient / radius; // a curvature with that pressure
            const Real size =
                options.force == ForceForm::calibrated
                    ? calibrated_size<Dimension>(sigma, curvature + air, list.turning[slot],
                                                 sheet_area(list, slot), radius, spacing)
                    : paper_size<Dimension>(sigma, curvature + (Dimension - 1) * air, spacing,
                                            list.weight[slot]);
            for (std::size_t axis = 0; axis < Dimension; ++axis)
                list.force[slot][axis] = -size * list.normal[slot][axis];
        }
    });
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
