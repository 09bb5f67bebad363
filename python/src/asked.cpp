#include "asked.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <utility>

#include "arrays.hpp"
#include "away.hpp"
#include "bindings.hpp"
#include "problems.hpp"
#include "talus/lines/line_input.hpp"
#include "talus/project/echo.hpp"
#include "vectors.hpp"

namespace talus::python {

namespace {

using Places = std::vector<PlanPlace>;

Places places_of(const Model& model, const GivenPlace& place, PlanShape shape, const char* where, Problems& warnings) {
  if (const auto* places = std::get_if<Places>(&place.given)) return *places;
  return places_given(std::get<std::string>(place.given), shape, model, where, warnings);
}

}  // namespace

AskedLine line_given(const Model& model, const GivenPlace& place, double height, Problems& warnings) {
  if (place.kind == PlaceKind::barrier) return line_of_barrier(model, std::get<std::string>(place.given), "barrier");
  return drawn_line(model, places_of(model, place, PlanShape::line, "line", warnings), height, "line", warnings);
}

AskedArea area_given(const Model& model, const GivenPlace& place, Problems& warnings) {
  return drawn_area(model, places_of(model, place, PlanShape::polygon, "polygon", warnings), "polygon", warnings);
}

const project::Project& Asked::project() const {
  if (const auto* run = std::get_if<std::shared_ptr<MemoryRun>>(&source_)) return (*run)->site().project;
  return std::get<std::shared_ptr<ReopenedRun>>(source_)->project();
}

const Model& Asked::model() const {
  if (const auto* run = std::get_if<std::shared_ptr<MemoryRun>>(&source_)) return (*run)->site().model;
  return std::get<std::shared_ptr<ReopenedRun>>(source_)->model();
}

const AskedRun& Asked::run() const {
  if (const auto* run = std::get_if<std::shared_ptr<MemoryRun>>(&source_)) return (*run)->asked();
  return std::get<std::shared_ptr<ReopenedRun>>(source_)->asked();
}

RunAnswer Asked::answer(const Question& question) const {
  const AskedRun& asked = run();
  const project::Project& own = project();
  const bool has_settings = !question.settings.empty();
  project::DesignBasis basis =
      project::design_basis(has_settings ? project_again(project::echo(own), own.file, question.settings) : own);
  AnswerOptions options;
  if (question.kit) options.kit = KitSize{(*question.kit)[0], (*question.kit)[1] * 1000};
  Problems warnings;
  const auto with_warnings = [&](RunAnswer answer) {
    warnings.append(answer.warnings);
    answer.warnings = warnings;
    return answer;
  };
  if (question.place.kind == PlaceKind::polygon) {
    const AskedArea area = area_given(model(), question.place, warnings);
    return with_warnings(asked.area(basis, area, options));
  }
  const AskedLine line =
      line_given(model(), question.place, options.kit ? options.kit->height : asked_height, warnings);
  if (question.section) {
    basis.design.section_m = *question.section;
  } else if (!own.design) {
    basis.design.section_m = usual_section(line.barrier);
  }
  add_kits_for_sliders(basis);
  return with_warnings(asked.line(basis, line, options));
}

RunAnswer Asked::ditch(double toe, double far_edge) const {
  const AskedRun& asked = run();
  return asked.ditch(ditch_between(model(), toe, far_edge, "ditch"),
                     project::design_basis(project()).design.confidence);
}

namespace {

using Pointer = std::shared_ptr<Asked>;

/// The answer as JSON, the numbers of its rocks and the warnings.
py::tuple answer_in_python(const RunAnswer& answer) {
  py::array_t<std::int64_t> rocks(static_cast<py::ssize_t>(answer.rocks.size()));
  std::copy(answer.rocks.begin(), answer.rocks.end(), rocks.mutable_data());
  return py::make_tuple(answer.json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace), rocks,
                        as_python(answer.warnings));
}

py::tuple ask(const Pointer& asked, const Question& question) {
  RunAnswer answer;
  do_away_or_throw([&](const std::atomic<bool>&) { answer = asked->answer(question); });
  return answer_in_python(answer);
}

py::tuple ask_ditch(const Pointer& asked, double toe, double far_edge) {
  RunAnswer answer;
  do_away_or_throw([&](const std::atomic<bool>&) { answer = asked->ditch(toe, far_edge); });
  return answer_in_python(answer);
}

Pointer asked_of_folder(const std::filesystem::path& folder, const std::filesystem::path& files) {
  Pointer asked;
  do_away_or_throw([&](const std::atomic<bool>&) { asked = std::make_shared<Asked>(folder, files); });
  return asked;
}

/// Of each place of release its source and where it is.
py::tuple sources(const Pointer& asked) {
  const Model& model = asked->model();
  const auto& spots = asked->sources().spots.list();
  py::list names;
  VectorsOut places(static_cast<py::ssize_t>(spots.size()));
  for (std::size_t k = 0; k < spots.size(); ++k) {
    const std::size_t source = spots[k].source.index;
    names.append(py::str(source < model.sources.size() ? model.sources[source] : std::string()));
    places.set(static_cast<py::ssize_t>(k), model.frame.global_from_local(spots[k].place));
  }
  return py::make_tuple(names, places.array());
}

}  // namespace

void bind_asked(py::module_& module) {
  py::enum_<PlaceKind>(module, "PlaceKind")
      .value("line", PlaceKind::line)
      .value("polygon", PlaceKind::polygon)
      .value("barrier", PlaceKind::barrier);
  py::class_<GivenPlace>(module, "GivenPlace")
      .def(py::init([](PlaceKind kind, std::variant<Places, std::string> given) {
             return GivenPlace{kind, std::move(given)};
           }),
           py::arg("kind"), py::arg("given"));
  py::class_<Asked, Pointer>(module, "Asked")
      .def(py::init<std::shared_ptr<MemoryRun>>(), py::arg("run").none(false))
      .def(py::init(&asked_of_folder), py::arg("folder"), py::arg("files"))
      .def(
          "ask",
          [](const Pointer& asked, GivenPlace place, std::optional<std::array<double, 2>> kit,
             std::optional<double> section, std::vector<std::string> settings) {
            return ask(asked, {std::move(place), kit, section, std::move(settings)});
          },
          py::arg("place"), py::arg("kit"), py::arg("section"), py::arg("settings"))
      .def("ditch", &ask_ditch, py::arg("toe"), py::arg("far_edge"))
      .def("sources", &sources);
}

}  // namespace talus::python
