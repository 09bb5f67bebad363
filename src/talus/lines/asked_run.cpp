#include "talus/lines/asked_run.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "talus/archive/doubts.hpp"
#include "talus/lines/beyond_ends.hpp"
#include "talus/lines/ensemble_spread.hpp"

namespace talus {

using Json = nlohmann::ordered_json;

namespace {

void expect_rocks_of(const Model& model, const RockPaths& paths) {
  const bool has_more = !paths.rocks().empty() && paths.rocks().back() >= model.rocks();
  if (paths.planned() == model.rocks() && !has_more) return;
  throw BadInput(
      Problem{.what = "the trajectories are of another run",
              .why = fmt::format("they are of {} rocks, and the project has {}", paths.planned(), model.rocks())});
}

}  // namespace

AskedRun::AskedRun(const Model& model, std::unique_ptr<const RockPaths> paths, const std::optional<WaysSummary>& ways)
    : model_(model), paths_((expect_rocks_of(model, *paths), std::move(paths))), sources_(model, paths_->rocks()) {
  if (ways) doubt_ways(*ways, warnings_);
}

Json AskedRun::head() const { return {{"run", {{"rocks", paths_->simulated()}, {"stored", paths_->rocks().size()}}}}; }

RunAnswer AskedRun::line(const project::DesignBasis& basis, const AskedLine& line, const AnswerOptions& options) const {
  const LineAnswer answer = ask_lines(model_, basis, *paths_, std::span(&line, 1)).front();
  RunAnswer all{head(), {}, warnings_};
  const std::string where = line.of_model ? fmt::format("line \"{}\"", line.barrier.name) : "line";
  doubt_needed_height(where, answer.result.whole, all.warnings);
  if (options.kit) doubt_kit_height(where, options.kit->height, answer.result.whole, all.warnings);
  all.json.update(line_json(model_, line, answer, sources_, options));
  const auto beyond = rocks_beyond_ends(model_, basis, *paths_, line, answer);
  all.json["beyond_ends"] = beyond ? Json(*beyond) : Json();
  if (beyond) doubt_ends(where, *beyond, answer, all.warnings);
  all.json["ensembles"] = nullptr;
  if (!model_.ensembles.empty()) all.json["ensembles"] = spread_json(ensemble_spread(model_, paths_->rocks(), answer));
  for (const CrossingRock& crossing : answer.crossings) all.rocks.push_back(crossing.rock);
  return all;
}

Json AskedRun::lines(const project::DesignBasis& basis, std::span<const AskedLine> lines) const {
  const std::vector<LineAnswer> answers = ask_lines(model_, without_kits(basis), *paths_, lines);
  Json json = head();
  Json& list = json["lines"] = Json::array();
  for (std::size_t k = 0; k < lines.size(); ++k) list.push_back(short_line_json(model_, lines[k], answers[k]));
  return json;
}

RunAnswer AskedRun::area(const project::DesignBasis& basis, const AskedArea& area, const AnswerOptions& options) const {
  const AreaAnswer answer = ask_area(model_, basis, *paths_, area);
  RunAnswer all{head(), {}, warnings_};
  all.json.update(area_json(model_, area, answer, sources_, options));
  all.json["ensembles"] = nullptr;
  if (!model_.ensembles.empty()) all.json["ensembles"] = spread_json(ensemble_spread(model_, paths_->rocks(), answer));
  for (const RockInside& rock : answer.entering) all.rocks.push_back(rock.rock);
  return all;
}

RunAnswer AskedRun::ditch(const Ditch& ditch, double confidence) const {
  const DitchAnswer answer = ask_ditch(model_, *paths_, ditch);
  RunAnswer all{head(), {}, warnings_};
  all.json.update(ditch_json(model_, ditch, answer, confidence));
  for (const RockInDitch& rock : answer.arriving) all.rocks.push_back(rock.rock);
  return all;
}

double usual_section(const Barrier& line) {
  double length = 0;
  for (const Panel& panel : line.panels()) length = std::max(length, panel.station + panel.plan_length);
  if (!(length > 0)) return 1;
  const double about = length / 20, power = std::pow(10, std::floor(std::log10(about)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (about <= step * power) return step * power;
  }
  return 10 * power;
}

void add_kits_for_sliders(project::DesignBasis& basis) {
  basis.kits.clear();
  for (int step = 1; step <= 30; ++step) basis.design.heights_m.push_back(0.5 * step);
  for (const double energy : kit_class_energies) basis.design.energies_kJ.push_back(energy / 1000);
  for (const double energy : {6000.0, 8500.0, 10000.0}) basis.design.energies_kJ.push_back(energy);
}

}  // namespace talus
