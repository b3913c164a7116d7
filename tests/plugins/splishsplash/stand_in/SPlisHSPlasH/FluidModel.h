// Stand-in. STAND_IN_OLDER: as in older versions, where surface tension has a base class of its own
// and fields have no method's name.
#pragma once

#include "Common.h"
#include <ParameterObject.h>

#include <functional>
#include <string>
#include <vector>

namespace SPH {

class NonPressureForceBase;
class SurfaceTensionBase;

enum FieldType { Scalar = 0, Vector3, Vector6, Matrix3, Matrix6, UInt };

struct FieldDescription {
    std::string name;
    FieldType type;
    std::function<void*(const unsigned int)> getFct;

#ifdef STAND_IN_OLDER
    FieldDescription(const std::string& n, const FieldType& t,
                     const std::function<void*(const unsigned int)>& fct, const bool = false)
        : name(n), type(t), getFct(fct) {}
#else
    FieldDescription(const std::string& n, const std::string& s, const FieldType& t,
                     const std::function<void*(const unsigned int)>& fct, const bool = false)
        : name(n), type(t), getFct(fct), source(s) {}
    std::string source;
#endif
};

/// The fluid; what its tests set is public here.
class FluidModel : public GenParam::ParameterObject {
public:
#ifdef STAND_IN_OLDER
    using Method = SurfaceTensionBase;
#else
    using Method = NonPressureForceBase;
#endif
    FluidModel() {}
    FluidModel(const FluidModel&) = delete;

    Method* getSurfaceTensionBase() {
        return method;
    }
    unsigned int numActiveParticles() const {
        return static_cast<unsigned int>(x.size());
    }
    const unsigned int numParticles() const {
        return static_cast<unsigned int>(x.size());
    }
    unsigned int getPointSetIndex() const {
        return 0;
    }
    Vector3r& getPosition(const unsigned int i) {
        return x[i];
    }
    Vector3r& getAcceleration(const unsigned int i) {
        return a[i];
    }
    const Real getMass(const unsigned int) const {
        return mass;
    }
    const Real getVolume(const unsigned int) const {
        return volume;
    }
    unsigned int& getParticleId(const unsigned int i) {
        return ids[i];
    }
    void addField(const FieldDescription& field) {
        fields.push_back(field);
    }
    void removeFieldByName(const std::string& name) {
        for (std::size_t f = 0; f < fields.size(); ++f)
            if (fields[f].name == name)
                fields.erase(fields.begin() + static_cast<long>(f--));
    }

    Method* method = nullptr;
    std::vector<Vector3r> x, a;
    std::vector<unsigned int> ids;
    std::vector<FieldDescription> fields;
    Real mass = 0, volume = 0;
};

} // namespace SPH
