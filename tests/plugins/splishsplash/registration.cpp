// C++11, as the program that includes the plugin's header.
#include <SurfaceTension_Meniscus.h>

#include <SPlisHSPlasH/Simulation.h>

static_assert(__cplusplus < 201402L, "this file is compiled as the program is");

void SPH::Simulation::registerNonpressureForces() {
    addSurfaceTensionMethod("None", [](FluidModel*) -> NonPressureForceBase* { return nullptr; });
    addSurfaceTensionMethod(SurfaceTension_Meniscus::METHOD_NAME, SurfaceTension_Meniscus::creator);
}
