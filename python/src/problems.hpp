#pragma once
// Problems of bad input as Python objects.

#include <pybind11/pybind11.h>

#include "talus/core/problems.hpp"

namespace talus::python {

namespace py = pybind11;

/// A list of talus.Problem.
[[nodiscard]] py::list as_python(const Problems& problems);

}  // namespace talus::python
