// The list of surface-tension models: a new one is its file, included here, and its place in the
// list.
#pragma once

#include "akinci_2013.hpp"
#include "becker_2007.hpp"
#include "color_field.hpp"
#include "he_2014.hpp"
#include "huber_2015.hpp"
#include "monte_carlo_tension.hpp"

namespace meniscus {
inline namespace MENISCUS_INSTRUCTION_SET {

template <class Real, int Dimension>
using TensionModels = MethodList<SurfaceTensionModel<Real, Dimension>, //
                                 MonteCarloTension<Real, Dimension>,   //
                                 BeckerTension<Real, Dimension>,       //
                                 HuberTension<Real, Dimension>,        //
                                 AkinciTension<Real, Dimension>,       //
                                 HeTension<Real, Dimension>,           //
                                 ColorFieldTension<Real, Dimension>>;

/// The model that the options name, or nullptr for none; `spacing` of the particles at rest, in
/// support radii. Throws InputError where there is none of that name.
template <class Real, int Dimension>
std::unique_ptr<SurfaceTensionModel<Real, Dimension>>
make_tension_model(const TensionOptions& options, const StepUnits& units, double spacing) {
    return TensionModels<Real, Dimension>::make(tension_model_place(options.model), options, units,
                                                spacing);
}

} // namespace MENISCUS_INSTRUCTION_SET
} // namespace meniscus
