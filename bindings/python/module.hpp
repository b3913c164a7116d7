// The parts of the compiled module `_meniscus`, a file each. Functions hold the interpreter's lock
// while they read and make Python's objects, and let it go while they work. What users see, with
// its shapes and units, is the package over it (meniscus/__init__.py).
#pragma once

#include <pybind11/pybind11.h>

namespace meniscus {

void add_snapshots(pybind11::module_& module);
void add_labels(pybind11::module_& module);
void add_lines(pybind11::module_& module);
void add_surface_tension(pybind11::module_& module);
void add_simulation(pybind11::module_& module);

} // namespace meniscus
