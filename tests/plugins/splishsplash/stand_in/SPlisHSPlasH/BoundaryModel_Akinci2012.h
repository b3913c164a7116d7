// Stand-in.
#pragma once

#include "Common.h"

#include <vector>

namespace SPH {

class BoundaryModel {
public:
    virtual ~BoundaryModel() {}
};

class BoundaryModel_Akinci2012 : public BoundaryModel {
public:
    Vector3r& getPosition(const unsigned int i) { return x[i]; }
    const Real& getVolume(const unsigned int i) const { return volumes[i]; }

    std::vector<Vector3r> x;
    std::vector<Real> volumes;
};

} // namespace SPH
