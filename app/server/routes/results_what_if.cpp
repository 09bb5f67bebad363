#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "routes/numbers.hpp"
#include "routes/results.hpp"
#include "what_if_jobs.hpp"

namespace talus::server {

namespace {

constexpr std::size_t most_asked_corners = 10'000;
constexpr std::uint64_t pictured_rocks = 40;  // of each rock model
constexpr double usual_seconds = 40, most_seconds = 600;

/// A number of the body above 0, up to `most`; nullopt if it is not given.
std::optional<double> limited(const Call& call, const char* key, double most) {
  const auto found = call.body.find(key);
  if (found == call.body.end() || found->is_null()) return std::nullopt;
  const double number = call.number(key);
  if (!(number > 0 && number <= most))
    throw Refusal(400, key, "is not valid", fmt::format("expected a number above 0, up to {:g}", most));
  return number;
}

bool wants_models(const Call& call) {
  const auto models = call.body.find("models");
  if (models == call.body.end()) return false;
  if (!models->is_boolean()) throw Refusal(400, "models", "is not true or false");
  return models->get<bool>();
}

/// What is asked of the run, and which factors.
std::unique_ptr<what_if::WhatIf> asked_of(const Call& call, const OpenRun& open, Problems& warnings) {
  const project::Project& project = open.built->project;
  const Model& model = open.built->model;
  std::vector<const char*> given;
  for (const char* key : {"line", "barrier", "polygon"})
    if (call.body.contains(key)) given.push_back(key);
  if (given.size() != 1)
    throw Refusal(400, given.empty() ? "line" : given.back(),
                  given.empty() ? "is missing" : "cannot be given with others",
                  "expected one of line, barrier, polygon");
  what_if::FactorChoice choice{.material = call.text("material", ""), .models = wants_models(call)};
  if (const auto steps = call.body.find("steps"); steps != call.body.end() && !steps->is_null()) {
    if (!steps->is_object())
      throw Refusal(400, "steps", "is not valid", "expected factors with their steps in percent");
    if (!steps->empty() || choice.models) choice.steps.emplace();
    for (const auto& [key, percent] : steps->items()) {
      if (!percent.is_number()) throw Refusal(400, "steps", fmt::format("{} is not a number", key));
      choice.steps->push_back({key, percent.get<double>() / 100});
    }
  }
  const std::string key = given.front();
  const auto place = [&]() -> what_if::AskedPlace {
    if (key == "barrier") return line_of_barrier(model, call.text("barrier"), key);
    const auto places = number_lists<2>(call, given.front(), 0, most_asked_corners);
    if (key == "polygon") return drawn_area(model, places, key, warnings);
    return drawn_line(model, places, asked_height, key, warnings);
  };
  return std::make_unique<what_if::WhatIf>(project, model, project::design_basis(project), place(), choice, "steps",
                                           warnings);
}

/// What can be varied of the run's project, with a material of this alone.
Json choices_of(const project::Project& project, const std::string& material) {
  Json materials = Json::array(), factors = Json::array();
  for (const project::Material& each : project.materials) materials.push_back(each.name);
  for (const std::size_t kind : what_if::kinds_of(project, material, "material")) {
    const what_if::FactorKind& factor = what_if::factor_kinds[kind];
    factors.push_back({{"factor", factor.key}, {"title", factor.title}, {"usual_percent", 100 * factor.usual_step}});
  }
  return {{"materials", std::move(materials)}, {"factors", std::move(factors)}};
}

}  // namespace

void add_what_if_routes(Router& router, RunStore& runs, AskedRuns& asked, WhatIfJobs& jobs) {
  const std::string path = one_run + "/what_if";
  router.post(path, [&](const Call& call) {
    call.only({"line", "barrier", "polygon", "steps", "material", "models", "seconds", "rocks"});
    const Run run = runs.find(call.part(1));
    WhatIfOrder order;
    order.options.seconds = limited(call, "seconds", most_seconds).value_or(usual_seconds);
    order.options.rocks = static_cast<std::uint64_t>(
        std::max(1.0, limited(call, "rocks", static_cast<double>(what_if::most_rocks)).value_or(what_if::most_rocks)));
    if (wants_models(call)) order.options.pictured = pictured_rocks;
    order.run = asked.open(run);
    order.question = call.body;
    const auto or_null = [](const auto& value) { return value ? Json(*value) : Json(); };
    order.overrides = {{"rocks", or_null(run.asked_rocks)}, {"seed", or_null(run.asked_seed)}};
    order.what_if = asked_of(call, *order.run, order.warnings);
    return json_answer(jobs.begin(std::move(order)), 202);
  });
  router.get(path, [&](const Call& call) { return json_answer(jobs.state_of(runs.find(call.part(1)).id)); });
  router.get(path + "/choices", [&](const Call& call) {
    return json_answer(choices_of(asked.open(runs.find(call.part(1)))->built->project, call.query("material")));
  });
  router.post(path + "/stop", [&](const Call& call) {
    call.only({});
    return json_answer(jobs.stop(runs.find(call.part(1)).id));
  });
}

}  // namespace talus::server
