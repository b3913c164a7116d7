// Surface tension by meniscus as a non-pressure force of SPlisHSPlasH: sigma in N/m, a contact
// angle at Akinci's boundary particles, and what was found as fields of the fluid. This header is
// C++11, as the program is; what it stands for is C++17 and stays in the .cpp.
// docs/splishsplash.md says how it gets into a checkout.
#ifndef __SurfaceTension_Meniscus_h__
#define __SurfaceTension_Meniscus_h__

#include <SPlisHSPlasH/Common.h>
#include <SPlisHSPlasH/FluidModel.h>
#include <SPlisHSPlasH/NonPressureForceBase.h>
// The base class of surface tension where a version has one.
#if __has_include(<SPlisHSPlasH/SurfaceTension/SurfaceTensionBase.h>)
#include <SPlisHSPlasH/SurfaceTension/SurfaceTensionBase.h>
#endif

#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace SPH {
/// What a fluid model keeps its surface-tension method as: NonPressureForceBase, and
/// SurfaceTensionBase in older versions.
typedef std::remove_pointer<decltype(std::declval<FluidModel&>().getSurfaceTensionBase())>::type
    SurfaceTensionMethodBase;

class SurfaceTension_Meniscus : public SurfaceTensionMethodBase {
protected:
    Real m_sigma;           ///< N/m
    Real m_contactAngle;    ///< of the boundary, degrees in the fluid, 10 to 170
    unsigned int m_samples; ///< of a candidate's sphere, 4 to 16384
    bool m_balanceMomentum; ///< no net force and torque on fluid that touches no boundary

    // What the last step found, one entry a particle; 0 for those inside.
    std::vector<Real> m_class; ///< 1: candidate, but covered; 2: surface
    std::vector<Real> m_uncovered;
    std::vector<Real> m_curvature; ///< 1/m
    std::vector<Vector3r> m_normals;

    /// The memory of the method, for 2 or 3 dimensions.
    struct Tension;
    std::unique_ptr<Tension> m_tension;

    virtual void initParameters();
    void clear();

public:
    static std::string METHOD_NAME;
    static int SURFACE_TENSION_COEFFICIENT;
    static int CONTACT_ANGLE;
    static int SAMPLES;
    static int BALANCE_MOMENTUM;

    SurfaceTension_Meniscus(FluidModel* model);
    virtual ~SurfaceTension_Meniscus(void);

    static NonPressureForceBase* creator(FluidModel* model) {
        return new SurfaceTension_Meniscus(model);
    }
    virtual std::string getMethodName() { return METHOD_NAME; }

    /// Adds force over mass to the accelerations of the active particles. Throws
    /// std::invalid_argument where a parameter was set past its range.
    virtual void step();
    virtual void reset();
    virtual void performNeighborhoodSearchSort();
};
} // namespace SPH

#endif
