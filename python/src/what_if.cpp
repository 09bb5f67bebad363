// What if: the same rocks with other values, at a line or in a polygon.

#include "talus/lines/what_if.hpp"

#include <pybind11/functional.h>
#include <pybind11/stl.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "asked.hpp"
#include "bindings.hpp"
#include "prepared_model.hpp"
#include "problems.hpp"
#include "progress.hpp"
#include "talus/lines/what_if_output.hpp"
#include "talus/model/design_plan.hpp"

namespace talus::python {

namespace {

struct WhatIfChoice {
  std::optional<std::vector<std::pair<std::string, double>>> steps;  // factors and shares; nullopt: the usual ones
  std::string material;                                              // empty: all
  bool models = false;                                               // also the other rock models
  std::uint64_t rocks = what_if::most_rocks;
  std::optional<double> seconds;
  int threads = 0;
};

what_if::AskedPlace place_in(const Model& model, const std::optional<GivenPlace>& place, Problems& warnings) {
  if (!place) return {};
  if (place->kind == PlaceKind::polygon) return area_given(model, *place, warnings);
  return line_given(model, *place, asked_height, warnings);
}

/// The answer as JSON and as the text of its table, the warnings, and the exception that stopped it or None.
py::tuple ask(const PreparedModel& prepared, const std::optional<GivenPlace>& place, const WhatIfChoice& choice,
              const Progress& progress) {
  const Site& site = *prepared.site();
  Problems warnings = site.warnings;
  std::optional<what_if::WhatIf> asked;
  std::optional<std::pair<std::string, std::string>> answer;
  Course course;
  const auto work = [&](const std::atomic<bool>&) {
    what_if::FactorChoice factors{.material = choice.material, .models = choice.models};
    if (choice.steps) {
      factors.steps.emplace();
      for (const auto& [key, share] : *choice.steps) factors.steps->push_back({key, share});
    }
    asked.emplace(site.project, site.model, project::design_basis(site.project), place_in(site.model, place, warnings),
                  factors, choice.material.empty() ? "steps" : "steps, material", warnings);
    const what_if::RunOptions options{.threads = choice.threads,
                                      .rocks = choice.rocks,
                                      .seconds = choice.seconds,
                                      .progress = [&](std::uint64_t rocks, std::uint64_t all) {
                                        course.planned = all;
                                        course.done = rocks;
                                      }};
    static_cast<void>(asked->run(options));
    const what_if::Answer found = asked->answer();
    answer.emplace(json_of(*asked, found).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace),
                   table_of(*asked, found));
  };
  const std::exception_ptr interruption = do_and_tell(work, course, progress);
  if (interruption && !answer) std::rethrow_exception(interruption);
  return py::make_tuple(answer->first, answer->second, as_python(warnings), interruption_object(interruption));
}

}  // namespace

void bind_what_if(py::module_& module) {
  module.def(
      "what_if",
      [](const PreparedModel& model, const std::optional<GivenPlace>& place,
         std::optional<std::vector<std::pair<std::string, double>>> steps, std::string material, bool models,
         std::optional<std::uint64_t> rocks, std::optional<double> seconds, int threads, const Progress& progress) {
        return ask(
            model, place,
            {std::move(steps), std::move(material), models, rocks.value_or(what_if::most_rocks), seconds, threads},
            progress);
      },
      py::arg("model"), py::arg("place"), py::arg("steps"), py::arg("material"), py::arg("models"), py::arg("rocks"),
      py::arg("seconds"), py::arg("threads"), py::arg("progress"));
}

}  // namespace talus::python
