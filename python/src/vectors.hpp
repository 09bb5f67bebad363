#pragma once
// Lists of vectors as arrays of shape (n, 3), and of numbers as arrays of shape (n,). The Python code of the package
// makes the shapes.

#include <pybind11/numpy.h>

#include "talus/core/vec.hpp"

namespace talus::python {

namespace py = pybind11;

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Reads vectors without the interpreter's lock. Throws std::invalid_argument if the array has another shape.
class VectorsIn {
 public:
  VectorsIn(const Numbers& array, py::ssize_t count) : data_(array.data()) {
    if (array.ndim() != 2 || array.shape(0) != count || array.shape(1) != 3)
      throw std::invalid_argument("expected an array of shape (n, 3)");
  }
  [[nodiscard]] Vec3 operator[](py::ssize_t k) const { return {data_[3 * k], data_[3 * k + 1], data_[3 * k + 2]}; }

 private:
  const double* data_;
};

class NumbersIn {
 public:
  NumbersIn(const Numbers& array, py::ssize_t count) : data_(array.data()) {
    if (array.ndim() != 1 || array.shape(0) != count) throw std::invalid_argument("expected an array of shape (n,)");
  }
  [[nodiscard]] double operator[](py::ssize_t k) const { return data_[k]; }

 private:
  const double* data_;
};

/// An array to be filled.
class VectorsOut {
 public:
  explicit VectorsOut(py::ssize_t count) : array_({count, py::ssize_t{3}}), data_(array_.mutable_data()) {}
  void set(py::ssize_t k, const Vec3& v) {
    for (int i = 0; i < 3; ++i) data_[3 * k + i] = v[i];
  }
  [[nodiscard]] const py::array_t<double>& array() const { return array_; }

 private:
  py::array_t<double> array_;
  double* data_;
};

class NumbersOut {
 public:
  explicit NumbersOut(py::ssize_t count) : array_(count), data_(array_.mutable_data()) {}
  void set(py::ssize_t k, double value) { data_[k] = value; }
  [[nodiscard]] const py::array_t<double>& array() const { return array_; }

 private:
  py::array_t<double> array_;
  double* data_;
};

}  // namespace talus::python
