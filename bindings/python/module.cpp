// The module itself, and the errors of C++ as exceptions of Python.
#include "module.hpp"

#include <meniscus/data/text/errors.hpp>
#include <meniscus/runtime/version.hpp>
#include <meniscus/sph/step/divergence.hpp>

#include <exception>
#include <stdexcept>

namespace py = pybind11;

namespace meniscus {
namespace {

py::object new_error(py::module_& module, const char* name, const char* meaning,
                     const py::tuple& bases) {
    const std::string full_name = std::string("meniscus.") + name;
    auto error = py::reinterpret_steal<py::object>(
        PyErr_NewExceptionWithDoc(full_name.c_str(), meaning, bases.ptr(), nullptr));
    if (!error)
        throw py::error_already_set();
    module.attr(name) = error;
    return error;
}

// Never freed: the interpreter may end before translators are gone.
PyObject* input_error = nullptr;
PyObject* failure_error = nullptr;

void translate(std::exception_ptr thrown) { // NOLINT: by value, as pybind11 has it
    try {
        if (thrown)
            std::rethrow_exception(thrown);
    } catch (const py::cast_error&) {
        PyErr_SetString(PyExc_TypeError, "an argument is of another type than its hint says");
    } catch (const InputError& error) {
        PyErr_SetString(input_error, error.what());
    } catch (const std::invalid_argument& error) { // of the runtime
        PyErr_SetString(input_error, error.what());
    } catch (const FailureError& error) {
        PyErr_SetString(failure_error, error.what());
    } catch (const Divergence& error) {
        PyErr_SetString(failure_error, error.what());
    }
}

void add_errors(py::module_& module) {
    const auto builtin = [](PyObject* type) { return py::reinterpret_borrow<py::object>(type); };
    const py::object base =
        new_error(module, "Error",
                  "What meniscus cannot do, in the words of the command: which file, particle or "
                  "option, what was expected, and what to do.",
                  py::make_tuple(builtin(PyExc_Exception)));
    input_error = new_error(module, "InputError", "The input or an option is wrong.",
                            py::make_tuple(base, builtin(PyExc_ValueError)))
                      .release()
                      .ptr();
    failure_error =
        new_error(module, "FailureError",
                  "The input is fine, but the work could not be finished: a disk that is full, a "
                  "simulation that diverged.",
                  py::make_tuple(base, builtin(PyExc_RuntimeError)))
            .release()
            .ptr();
    py::register_exception_translator(translate);
}

} // namespace
} // namespace meniscus

PYBIND11_MODULE(_meniscus, module) {
    module.doc() = "The compiled part of meniscus; use the package over it.";
    module.attr("version") = meniscus::program_version;
    meniscus::add_errors(module);
    meniscus::add_snapshots(module);
    meniscus::add_labels(module);
    meniscus::add_lines(module);
    meniscus::add_surface_tension(module);
    meniscus::add_simulation(module);
}
