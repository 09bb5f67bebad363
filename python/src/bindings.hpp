#pragma once
// The parts of the module talus._talus, one function each.

#include <pybind11/pybind11.h>

namespace talus::python {

namespace py = pybind11;

/// BadInput, memory and stopping as exceptions of Python. First.
void bind_problems(py::module_& module);
void bind_project(py::module_& module);
void bind_results(py::module_& module);
void bind_model(py::module_& module);
void bind_follow(py::module_& module);
void bind_surface(py::module_& module);
void bind_kernel(py::module_& module);
void bind_asked(py::module_& module);
void bind_what_if(py::module_& module);
void bind_studies(py::module_& module);

}  // namespace talus::python
