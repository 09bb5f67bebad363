#pragma once
// Rows as NumPy arrays.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include "row_keeper.hpp"

namespace talus::python {

namespace py = pybind11;

/// A structured array of these rows, which `owner` keeps alive: no copy. It cannot be written to.
[[nodiscard]] py::array array_of(const PackedRows& rows, const py::object& owner);
/// The same of rows that it keeps alive itself.
[[nodiscard]] py::array array_of(PackedRows&& rows);
/// Of values that it keeps alive itself.
[[nodiscard]] py::array array_of(std::vector<float>&& values, py::ssize_t rows, py::ssize_t columns);

}  // namespace talus::python
