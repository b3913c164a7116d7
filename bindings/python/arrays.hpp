// NumPy arrays and the project's vectors, one into the other. What the project has made becomes an
// array that owns it, without a copy; what it reads in place must lie as C has it.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <meniscus/data/text/errors.hpp>

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace meniscus {

namespace py = pybind11;

/// An array of `Value` over the memory of a vector of them, or of rows of them, which it keeps.
template <class Value, class Element>
py::array_t<Value> owning_array(std::vector<Element>&& values,
                                const std::vector<py::ssize_t>& shape) {
    static_assert(sizeof(Element) % sizeof(Value) == 0);
    auto kept = std::make_unique<std::vector<Element>>(std::move(values));
    const auto* data = reinterpret_cast<const Value*>(kept->data());
    const py::capsule owner(
        kept.get(), [](void* vector) { delete static_cast<std::vector<Element>*>(vector); });
    static_cast<void>(kept.release()); // the capsule has it
    return py::array_t<Value>(shape, data, owner);
}

/// One value a row, or `columns` of them.
template <class Value>
py::array_t<Value> array_of(std::vector<Value>&& values, std::size_t columns = 1) {
    const auto rows = static_cast<py::ssize_t>(values.size() / columns);
    if (columns == 1)
        return owning_array<Value>(std::move(values), {rows});
    return owning_array<Value>(std::move(values), {rows, static_cast<py::ssize_t>(columns)});
}

/// Three coordinates a row.
inline py::array_t<double> array_of(std::vector<std::array<double, 3>>&& places) {
    const auto rows = static_cast<py::ssize_t>(places.size());
    return owning_array<double>(std::move(places), {rows, 3});
}

/// "(3, 2)", as NumPy has it.
inline std::string shape_text(const py::array& array) {
    return py::str(py::object(array.attr("shape"))).cast<std::string>();
}

/// The array itself where it holds this type as C has it, else a copy that does. Throws InputError,
/// naming it, where it cannot be one.
template <class Value>
py::array_t<Value> contiguous(const py::handle& values, const char* name) {
    auto array = py::array_t<Value, py::array::c_style | py::array::forcecast>::ensure(values);
    if (!array)
        throw InputError(std::string(name) + " must be an array of numbers, found " +
                         py::str(py::type::of(values)).cast<std::string>());
    return array;
}

} // namespace meniscus
