#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <array>

#include "arrays.hpp"
#include "away.hpp"
#include "bindings.hpp"
#include "folder_tables.hpp"
#include "memory_run.hpp"
#include "tables.hpp"
#include "talus/maps/map_files.hpp"
#include "vectors.hpp"
#ifdef TALUS_HAS_GDAL
#include "talus/gdal/raster_crs.hpp"
#endif

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

/// Values, corner, cell, unit, meaning, whether it is a count, and the limits of its classes.
py::object map_in_python(std::optional<MapArray> map) {
  if (!map) return py::none();
  return py::make_tuple(array_of(std::move(map->values), map->rows, map->columns), map->corner, map->cell, map->unit,
                        map->meaning, map->is_count, map->limits);
}

py::object map_of_run(const Run& run, const std::string& name) {
  std::optional<MapArray> map;
  do_away_or_throw([&](const std::atomic<bool>&) { map = run->map(name); });
  return map_in_python(std::move(map));
}

py::object map_of_folder(const std::filesystem::path& folder, const std::string& name) {
  std::optional<MapArray> map;
  do_away_or_throw([&](const std::atomic<bool>&) { map = read_map_of_folder(folder, name); });
  return map_in_python(std::move(map));
}

/// Of a map: its name, unit, meaning and class limits; values as an array from the north, NaN where no rock was.
void write_one_map(const std::filesystem::path& file, const std::string& name, const std::string& unit,
                   const std::string& meaning, bool is_count, const ClassLimits& limits, const Numbers& values,
                   const std::array<double, 2>& corner, const std::array<double, 2>& cell, const std::string& crs_wkt) {
  const std::vector<MapKind> kinds = map_kinds({.percentiles = {}, .bands = banded_map_subjects});
  const auto known = std::ranges::find(kinds, name.substr(name.rfind('/') + 1), &MapKind::name);
  const MapKind kind{.name = name,
                     .meaning = meaning,
                     .unit = unit,
                     .limits = limits,
                     .is_count = is_count,
                     .overview = known != kinds.end() ? known->overview : MapOverview::maximum};
  MapPicture picture{static_cast<int>(values.shape(1)), static_cast<int>(values.shape(0)), corner, cell, {}};
  picture.values.assign(values.data(), values.data() + values.size());
  do_away_or_throw([&](const std::atomic<bool>&) { write_map(kind, picture, crs_wkt, file); });
}

/// "EPSG:25832", or the text itself if it has no such name.
std::string crs_name(const std::string& wkt) {
#ifdef TALUS_HAS_GDAL
  if (const auto crs = crs_for_file(wkt)) {
    if (std::string name = name_of(*crs); name.starts_with("EPSG:")) return name;
  }
#endif
  return wkt;
}

/// From, to and colour of each class.
py::list classes_of(const ClassLimits& limits) {
  py::list classes;
  for (const MapClass& each : map_classes(limits)) classes.append(py::make_tuple(each.from, each.to, each.colour));
  return classes;
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
  module.def("write_map", &write_one_map, py::arg("file"), py::arg("name"), py::arg("unit"), py::arg("meaning"),
             py::arg("is_count"), py::arg("limits"), py::arg("values"), py::arg("corner"), py::arg("cell"),
             py::arg("crs_wkt"));
  module.def("crs_name", &crs_name, py::arg("wkt"));
  module.def("map_classes", &classes_of, py::arg("limits"));
  module.def("map_of_folder", &map_of_folder, py::arg("folder"), py::arg("name"));
}

}  // namespace talus::python
