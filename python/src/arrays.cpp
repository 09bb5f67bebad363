#include "arrays.hpp"

#include <memory>

namespace talus::python {

namespace {

template <class Value>
py::capsule keeper_of(std::unique_ptr<Value> value) {
  return py::capsule(value.release(), [](void* kept) { delete static_cast<Value*>(kept); });
}

py::dtype dtype_of(const RowLayout& layout) {
  py::list names, formats, offsets;
  for (const RowLayout::Field& field : layout.fields) {
    names.append(py::str(field.name));
    formats.append(py::str(field.format));
    offsets.append(py::int_(field.offset));
  }
  return {names, formats, offsets, static_cast<py::ssize_t>(layout.size)};
}

}  // namespace

py::array array_of(const PackedRows& rows, const py::object& owner) {
  const auto count = static_cast<py::ssize_t>(rows.count()), size = static_cast<py::ssize_t>(rows.layout.size);
  py::array array(dtype_of(rows.layout), {count}, {size}, rows.bytes.data(), owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

py::array array_of(PackedRows&& rows) {
  auto kept = std::make_unique<PackedRows>(std::move(rows));
  const PackedRows& here = *kept;
  return array_of(here, keeper_of(std::move(kept)));
}

py::array array_of(std::vector<float>&& values, py::ssize_t rows, py::ssize_t columns) {
  auto kept = std::make_unique<std::vector<float>>(std::move(values));
  const float* const data = kept->data();
  return py::array_t<float>({rows, columns}, data, keeper_of(std::move(kept)));
}

}  // namespace talus::python
