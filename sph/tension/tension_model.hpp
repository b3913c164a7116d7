// What surface-tension models have in common: each adds accelerations to the fluid, from neighbors
// and densities as the step found them, before pressure is solved for. Coefficients come in SI
// units and results are in those of the step (fluid.hpp): lengths in support radii.
#pragma once

#include "surface_results.hpp"
#include <meniscus/sph/fluid/fluid.hpp>
#include <meniscus/sph/scene/methods.hpp>

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

/// Each has, for the list (tension_models.hpp), a constructor as this one's and a
/// `static TensionModelRow row()`.
template <class Real, int Dimension>
class SurfaceTensionModel {
public:
    using FluidType = Fluid<Real, Dimension>;

    /// `spacing`: of the particles at rest, in support radii.
    SurfaceTensionModel(const TensionOptions& model_options, const StepUnits& /*units*/,
                        double spacing)
        : options(model_options), rest_spacing(spacing) {}
    virtual ~SurfaceTensionModel() = default;

    /// The length of the last step, s, before the forces of the next.
    virtual void take_time_step(double /*seconds*/) {}

    /// Adds to fluid.acceleration of each particle.
    virtual void add_accelerations(FluidType& fluid) = 0;

    /// What the last call found of each particle, for snapshots; empty where the model knows no
    /// surface.
    [[nodiscard]] virtual SurfaceResults results(const FluidType& /*fluid*/) const { return {}; }

    [[nodiscard]] virtual std::size_t surface_particles() const { return 0; }

    /// Of the air, part of the forces: pressures of the fluid are higher by it.
    [[nodiscard]] virtual double ambient_pressure() const { return 0; }

protected:
    TensionOptions options;
    double rest_spacing;
};

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
