#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "arrays.hpp"
#include "away.hpp"
#include "bindings.hpp"
#include "folder_tables.hpp"
#include "memory_run.hpp"
#include "tables.hpp"

namespace talus::python {

namespace {

using Run = std::shared_ptr<MemoryRun>;

py::object table(const Run& run, const std::string& name) {
  py::object found = py::none();
  for_table(name, [&]<class Row>(const Row*) { found = array_of(run->rows<Row>(), py::cast(run)); });
  return found;
}

py::object table_of_folder(const std::filesystem::path& folder, const std::string& name) {
  py::object found = py::none();
  for_table(name, [&]<class Row>(const Row*) {
    PackedRows rows;
    do_away_or_throw([&](const std::atomic<bool>&) { rows = rows_of_folder<Row>(folder); });
    found = array_of(std::move(rows));
  });
  return found;
}

/// Values, corner, cell, unit, meaning and whether it is a count.
py::object as_python(std::optional<MapArray> map) {
  if (!map) return py::none();
  return py::make_tuple(array_of(std::move(map->values), map->rows, map->columns), map->corner, map->cell, map->unit,
                        map->meaning, map->is_count);
}

py::object map_of_run(const Run& run, const std::string& name) {
  std::optional<MapArray> map;
  do_away_or_throw([&](const std::atomic<bool>&) { map = run->map(name); });
  return as_python(std::move(map));
}

py::object map_of_folder(const std::filesystem::path& folder, const std::string& name) {
  std::optional<MapArray> map;
  do_away_or_throw([&](const std::atomic<bool>&) { map = read_map_of_folder(folder, name); });
  return as_python(std::move(map));
}

py::array envelopes(const Run& run) {
  PackedRows rows;
  do_away_or_throw([&](const std::atomic<bool>&) { rows = packed(run->envelopes()); });
  return array_of(std::move(rows));
}

std::string summary_text(const Run& run) {
  std::string text;
  do_away_or_throw([&](const std::atomic<bool>&) { text = run->summary_text(); });
  return text;
}

}  // namespace

void bind_results(py::module_& module) {
  py::class_<MemoryRun, Run>(module, "Run")
      .def("table", &table, py::arg("name"))
      .def("envelopes", &envelopes)
      .def("summary_text", &summary_text)
      .def("map_names",
           [](const Run& run) {
             std::vector<std::string> names;
             for (const MapKind& kind : run->map_kinds()) names.push_back(kind.name);
             return names;
           })
      .def("map", &map_of_run, py::arg("name"))
      .def(
          "save",
          [](const Run& run, const std::filesystem::path& folder) {
            do_away_or_throw([&](const std::atomic<bool>&) { run->save(folder); });
          },
          py::arg("folder"))
      .def_property_readonly("rocks", [](const Run& run) { return run->course().range.count(); })
      .def_property_readonly("done", [](const Run& run) { return run->rocks_done(); })
      .def_property_readonly("seconds", [](const Run& run) { return run->course().seconds; })
      .def_property_readonly("crs_wkt", [](const Run& run) { return run->site().model.crs_wkt; });
  module.def("table_of_folder", &table_of_folder, py::arg("folder"), py::arg("name"));
  module.def("envelopes_of_folder",
             [](const std::filesystem::path& folder) { return array_of(envelopes_of_folder(folder)); });
  module.def("maps_of_folder", &maps_of_folder, py::arg("folder"));
  module.def("map_of_folder", &map_of_folder, py::arg("folder"), py::arg("name"));
}

}  // namespace talus::python
