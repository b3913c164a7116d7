// What a step found in one value a particle of the host, where it stands in slots of candidates
// (surface_particles.hpp): for output, and for hosts that add up accelerations.
//     scatter(tension.surface(), tension.surface().curvature, curvature_of_particles);
//     scatter(tension.surface(), tension.surface().normal, normals_of_particles, 3);
//     add_accelerations(tension.surface(), masses, accelerations, 3);
#pragma once

#include "surface_particles.hpp"

#include <algorithm>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// Sets all[i] for each particle i of the step: to the value of its slot (one of the vectors of
/// `list`), to 0 where it has none.
template <class Real, int Dimension, class Value>
void scatter(const SurfaceParticles<Real, Dimension>& list, const std::vector<Value>& of_slots,
             Value* all) {
    std::fill_n(all, list.slot_of.size(), Value{});
    for (std::size_t slot = 0; slot < list.size(); ++slot)
        all[list.particle[slot]] = of_slots[slot];
}

/// The same for vectors, `stride` values a particle (at least Dimension), of which the first are
/// set.
template <class Real, int Dimension>
void scatter(const SurfaceParticles<Real, Dimension>& list,
             const std::vector<std::array<Real, axis_count<Dimension>>>& of_slots, Real* all,
             std::size_t stride = axis_count<Dimension>) {
    for (std::size_t i = 0; i < list.slot_of.size(); ++i)
        std::fill_n(all + i * stride, Dimension, Real(0));
    for (std::size_t slot = 0; slot < list.size(); ++slot)
        std::copy_n(of_slots[slot].data(), Dimension, all + list.particle[slot] * stride);
}

/// Adds force over mass (m/s^2) to the accelerations, `stride` values a particle (at least
/// Dimension), of which the first change. `mass_of(i)` is the mass of particle i in kg, positive.
template <class Real, int Dimension, class MassOf>
void add_accelerations_by(const SurfaceParticles<Real, Dimension>& list, const MassOf& mass_of,
                          Real* accelerations, std::size_t stride = axis_count<Dimension>) {
    for (std::size_t slot = 0; slot < list.size(); ++slot) {
        const std::size_t i = list.particle[slot];
        for (std::size_t axis = 0; axis < Dimension; ++axis)
            accelerations[i * stride + axis] += list.force[slot][axis] / mass_of(i);
    }
}

/// The same with one mass a particle, and with one for all.
template <class Real, int Dimension>
void add_accelerations(const SurfaceParticles<Real, Dimension>& list, const Real* masses,
                       Real* accelerations, std::size_t stride = axis_count<Dimension>) {
    add_accelerations_by(
        list, [&](std::size_t i) { return masses[i]; }, accelerations, stride);
}
template <class Real, int Dimension>
void add_accelerations(const SurfaceParticles<Real, Dimension>& list, Real mass,
                       Real* accelerations, std::size_t stride = axis_count<Dimension>) {
    add_accelerations_by(
        list, [&](std::size_t /*i*/) { return mass; }, accelerations, stride);
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
