// What surface-tension models have in common: each adds accelerations to the fluid, from neighbors
// and densities as the step found them, before pressure is solved for. Coefficients come in SI
// units and results are in those of the step (fluid.hpp): lengths in support radii.
#pragma once

#include "fluid.hpp"
#include "simulation.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

template <class Real, int Dimension>
class SurfaceTensionModel {
public:
    using FluidType = Fluid<Real, Dimension>;

    explicit SurfaceTensionModel(const TensionOptions& model_options) : options(model_options) {}
    virtual ~SurfaceTensionModel() = default;

    /// Adds to fluid.acceleration of each particle.
    virtual void add_accelerations(FluidType& fluid) = 0;

    /// What the last call found of each particle, for snapshots; empty where the model knows no
    /// surface.
    [[nodiscard]] virtual SurfaceResults results(const FluidType& /*fluid*/) const { return {}; }

    [[nodiscard]] virtual std::size_t surface_particles() const { return 0; }

protected:
    TensionOptions options;
};

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
