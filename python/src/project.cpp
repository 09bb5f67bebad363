#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "away.hpp"
#include "bindings.hpp"
#include "given_project.hpp"
#include "problems.hpp"
#include "tables.hpp"
#include "talus/archive/envelope_table.hpp"
#include "talus/project/differences.hpp"
#include "talus/project/document.hpp"
#include "talus/project/echo.hpp"
#include "talus/project/schema.hpp"
#include "talus/project/starter.hpp"

namespace talus::python {

GivenProject::GivenProject(std::string given, std::filesystem::path from, project::Overrides with)
    : text(std::move(given)),
      file(std::move(from)),
      overrides(std::move(with)),
      reading(project::read_project_text(text, file, overrides)) {}

project::Overrides GivenProject::with(const project::Overrides& more) const {
  project::Overrides all = overrides;
  all.settings.insert(all.settings.end(), more.settings.begin(), more.settings.end());
  if (more.rocks) all.rocks = more.rocks;
  if (more.seed) all.seed = more.seed;
  return all;
}

namespace {

using Settings = std::vector<std::string>;
using Given = std::shared_ptr<GivenProject>;

Given read_text(std::string text, std::filesystem::path file, project::Overrides overrides) {
  Given given;
  do_away_or_throw([&](const std::atomic<bool>&) {
    given = std::make_shared<GivenProject>(std::move(text), std::move(file), std::move(overrides));
  });
  return given;
}

Given read_file(const std::filesystem::path& file, const Settings& settings, std::optional<std::int64_t> rocks,
                std::optional<std::uint64_t> seed) {
  std::string text;
  do_away_or_throw([&](const std::atomic<bool>&) { text = project::text_of_file(file); });
  return read_text(std::move(text), file, {settings, rocks, seed});
}

template <class Row>
py::list columns_of() {
  py::list list;
  for (const ColumnText& column : column_texts<Row>())
    list.append(py::make_tuple(column.name, column.unit, column.meaning));
  return list;
}

py::object columns(const std::string& table) {
  if (table == "envelopes") return columns_of<EnvelopeRow>();
  py::object list = py::none();
  for_table(table, [&]<class Row>(const Row*) { list = columns_of<Row>(); });
  return list;
}

}  // namespace

void bind_project(py::module_& module) {
  py::class_<GivenProject, Given>(module, "Project")
      .def_static("read", &read_file, py::arg("file"), py::arg("settings"), py::arg("rocks"), py::arg("seed"))
      .def_static(
          "from_text",
          [](std::string text, std::filesystem::path file, Settings settings, std::optional<std::int64_t> rocks,
             std::optional<std::uint64_t> seed) {
            return read_text(std::move(text), std::move(file), {std::move(settings), rocks, seed});
          },
          py::arg("text"), py::arg("file"), py::arg("settings"), py::arg("rocks"), py::arg("seed"))
      .def("changed",
           [](const GivenProject& self, Settings settings, std::optional<std::int64_t> rocks,
              std::optional<std::uint64_t> seed) {
             return read_text(self.text, self.file, self.with({std::move(settings), rocks, seed}));
           })
      .def_readonly("text", &GivenProject::text)
      .def_readonly("file", &GivenProject::file)
      .def_property_readonly("is_changed",
                             [](const GivenProject& self) {
                               return !self.overrides.settings.empty() || self.overrides.rocks || self.overrides.seed;
                             })
      .def_property_readonly("name", [](const GivenProject& self) { return self.reading.project.name; })
      .def_property_readonly("is_2d", [](const GivenProject& self) { return self.reading.project.is_2d(); })
      .def_property_readonly("warnings", [](const GivenProject& self) { return as_python(self.reading.warnings); })
      .def("echo_text", [](const GivenProject& self) {
        return project::echo(self.reading.project).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
      });
  // Of two echoed projects: a list of key, here and there.
  module.def(
      "differences",
      [](const std::string& here, const std::string& there) {
        using Json = nlohmann::ordered_json;
        Json list = Json::array();
        for (const project::Difference& each : project::differences(Json::parse(here), Json::parse(there)))
          list.push_back({{"key", each.key}, {"here", each.here}, {"there", each.there}});
        return list.dump();
      },
      py::arg("here"), py::arg("there"));
  module.def("schema_text", [] { return project::schema().dump(); });
  module.def("starter_text", &project::starter);
  module.def("columns", &columns, py::arg("table"));
}

}  // namespace talus::python
