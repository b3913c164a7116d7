// Stand-in for GenericParameters.
#pragma once

#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace GenParam {

class ParameterBase {
public:
    virtual ~ParameterBase() {}
    std::string name, group, description;
};

template <class T>
class Parameter : public ParameterBase {
public:
    explicit Parameter(T* at) : value(at) {}
    T getValue() { return *value; }
    virtual void setValue(const T v) { *value = v; }

protected:
    T* value;
};

template <class T>
class NumericParameter : public Parameter<T> {
public:
    using Parameter<T>::Parameter;
    void setMinValue(const T v) { min = v; }
    void setMaxValue(const T v) { max = v; }
    void setValue(const T v) override { *this->value = std::max(std::min(v, max), min); }

private:
    T min = std::numeric_limits<T>::lowest();
    T max = std::numeric_limits<T>::max();
};

using FloatParameter = NumericParameter<float>;
using DoubleParameter = NumericParameter<double>;

class ParameterObject {
public:
    virtual ~ParameterObject() {}
    virtual void initParameters() {}
    unsigned int numParameters() const { return static_cast<unsigned int>(parameters.size()); }
    ParameterBase* getParameter(const unsigned int index) { return parameters[index].get(); }

    template <class T>
    int createNumericParameter(const std::string& name, const std::string& label, T* value) {
        return add(new NumericParameter<T>(value), name, label);
    }
    int createBoolParameter(const std::string& name, const std::string& label, bool* value) {
        return add(new Parameter<bool>(value), name, label);
    }
    void setGroup(const unsigned int id, const std::string& v) { parameters[id]->group = v; }
    void setDescription(const unsigned int id, const std::string& v) {
        parameters[id]->description = v;
    }
    template <class T>
    void setValue(const unsigned int id, const T v) {
        static_cast<Parameter<T>*>(getParameter(id))->setValue(v);
    }
    template <class T>
    T getValue(const unsigned int id) {
        return static_cast<Parameter<T>*>(getParameter(id))->getValue();
    }

private:
    int add(ParameterBase* parameter, const std::string& name, const std::string& /*label*/) {
        parameter->name = name;
        parameters.emplace_back(parameter);
        return static_cast<int>(parameters.size()) - 1;
    }

    std::vector<std::unique_ptr<ParameterBase>> parameters;
};

} // namespace GenParam
