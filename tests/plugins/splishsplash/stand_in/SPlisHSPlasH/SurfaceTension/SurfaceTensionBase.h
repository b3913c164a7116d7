// Stand-in; the file is there in newer versions' checkouts or not, and nothing of it is used then.
#pragma once

#include <SPlisHSPlasH/NonPressureForceBase.h>

namespace SPH {

class SurfaceTensionBase : public NonPressureForceBase {
protected:
    Real m_surfaceTension = 0;
    Real m_surfaceTensionBoundary = 0;

public:
    using NonPressureForceBase::NonPressureForceBase;
};

} // namespace SPH
