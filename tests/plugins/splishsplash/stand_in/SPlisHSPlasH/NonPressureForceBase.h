// Stand-in.
#pragma once

#include "Common.h"
#include "FluidModel.h"
#include <ParameterObject.h>

namespace SPH {

class NonPressureForceBase : public GenParam::ParameterObject {
protected:
    FluidModel* m_model;

public:
    NonPressureForceBase(FluidModel* model) : m_model(model) {}
    NonPressureForceBase(const NonPressureForceBase&) = delete;
    virtual ~NonPressureForceBase(void) {}

#ifndef STAND_IN_OLDER
    virtual std::string getMethodName() = 0;
#endif
    virtual void step() = 0;
    virtual void reset() {}
    virtual void performNeighborhoodSearchSort() {}
    virtual void emittedParticles(const unsigned int /*startIndex*/) {}
    FluidModel* getModel() {
        return m_model;
    }
    virtual void init() {
        initParameters();
    }
};

} // namespace SPH
