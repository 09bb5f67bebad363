#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "asked_runs.hpp"
#include "http/arrays.hpp"
#include "results/end_points.hpp"
#include "results/run_summary.hpp"
#include "routes/numbers.hpp"
#include "routes/results.hpp"
#include "talus/project/document.hpp"
#include "talus/project/read.hpp"

namespace talus::server {

namespace {

constexpr std::size_t most_corners = 10'000;       // of a line or a polygon
constexpr std::size_t most_lines = 2'000;          // of one request
constexpr std::size_t max_rocks_listed = 100'000;  // rocks in an answer

/// A number of the body that is above 0; nullopt if it is not given. Refuses (400) others.
std::optional<double> positive(const Call& call, const char* key) {
  const auto found = call.body.find(key);
  if (found == call.body.end() || found->is_null()) return std::nullopt;
  const double number = call.number(key);
  if (!(number > 0) || !std::isfinite(number)) throw Refusal(400, key, "is not valid", "expected a number above 0");
  return number;
}

/// Places on plan.
std::vector<PlanPlace> places(const Call& call, const char* key) { return number_lists<2>(call, key, 0, most_corners); }

/// [design] of the run with the keys of the request. Throws BadInput if a value is refused.
project::DesignBasis basis_of(const Call& call, const Run& run, const RunStore& runs, const OpenRun& open) {
  const auto given = call.body.find("design");
  if (given == call.body.end() || given->is_null()) return project::design_basis(open.built->project);
  if (!given->is_object()) throw Refusal(400, "design", "is not valid", "expected keys of [design] with their values");
  project::Overrides overrides = overrides_of(run);
  overrides.asks_a_line = true;
  for (const auto& [key, value] : given->items())
    overrides.settings.push_back(fmt::format("design.{}={}", key, value.dump()));
  const auto reading = project::read_project_text(project::text_of_file(run.folder / run_project_name),
                                                  runs.project_file(run), overrides);
  return project::design_basis(reading.project);
}

AnswerOptions options_of(const Call& call) {
  AnswerOptions options;
  const auto height = positive(call, "height_m"), energy = positive(call, "energy_kJ");
  if (height.has_value() != energy.has_value())
    throw Refusal(400, height ? "energy_kJ" : "height_m", "is missing", "a kit has a height and an energy");
  if (height) options.kit = KitSize{*height, *energy * 1000};
  if (const auto precision = positive(call, "precision")) options.precision = *precision;
  const auto sources = call.body.find("sources");
  if (sources != call.body.end()) {
    if (!sources->is_boolean()) throw Refusal(400, "sources", "is not true or false");
    options.wants_sources = sources->get<bool>();
  }
  return options;
}

/// Which of the keys says what is asked. Refuses (400) none and several.
std::string question_of(const Call& call) {
  std::string asked;
  for (const char* key : {"line", "lines", "barrier", "polygon"}) {
    if (!call.body.contains(key)) continue;
    if (!asked.empty()) throw Refusal(400, key, "cannot be given with " + asked, "one thing is asked at a time");
    asked = key;
  }
  if (asked.empty()) throw Refusal(400, "line", "is missing", "expected line, lines, barrier or polygon");
  return asked;
}

/// Refuses (409) a request that a later one of the same drag has overtaken.
class DragOrder {
 public:
  DragOrder(const Call& call, AskedRuns& runs) : runs_(runs) {
    const auto drag = call.body.find("drag");
    if (drag == call.body.end() || drag->is_null()) return;
    const bool is_good = drag->is_object() && drag->size() == 2 && drag->contains("id") && drag->contains("number") &&
                         drag->at("id").is_string() && drag->at("number").is_number_unsigned();
    if (!is_good) throw Refusal(400, "drag", "is not valid", "expected id, a text, and number, a whole number");
    id_ = drag->at("id").get<std::string>();
    number_ = drag->at("number").get<std::uint64_t>();
    check();
  }
  void check() const {
    if (id_.empty() || runs_.is_latest(id_, number_)) return;
    throw Refusal(409, "drag", "a later request of this drag has arrived");
  }

 private:
  AskedRuns& runs_;
  std::string id_;
  std::uint64_t number_ = 0;
};

/// Adds what filters need.
Json with_selection(RunAnswer answer, Problems warnings, const Run& run, AskedRuns& asked) {
  Json listed = Json::array();
  for (const std::uint64_t rock : answer.rocks) {
    if (listed.size() == max_rocks_listed) break;
    listed.push_back(rock);
  }
  answer.json["crossing_rocks"] = std::move(listed);
  answer.json["selection"] = asked.remember(run.id, std::move(answer.rocks));
  warnings.append(answer.warnings);
  answer.json["problems"] = as_json(warnings);
  return std::move(answer.json);
}

/// Short answers. Those of lines that are refused have only the reasons: stations along a path may be off the terrain.
Json answer_to_lines(const OpenRun& open, const project::DesignBasis& basis, const Json& given, double height) {
  std::vector<AskedLine> lines;
  std::vector<std::size_t> places;  // of these lines in the request
  std::vector<Problems> problems(given.size());
  for (std::size_t k = 0; k < given.size(); ++k) {
    const std::string where = fmt::format("lines[{}]", k);
    const auto corners = number_lists<2>(given[k], where, 0, most_corners);
    try {
      lines.push_back(drawn_line(open.built->model, corners, height, where, problems[k]));
      places.push_back(k);
    } catch (const BadInput& bad) {
      problems[k].append(bad.problems());
    }
  }
  Json answered = open.asked->lines(basis, lines);
  Json list = Json::array();
  std::size_t next = 0;
  for (std::size_t k = 0; k < given.size(); ++k) {
    const bool has_answer = next < places.size() && places[next] == k;
    Json one = has_answer ? std::move(answered["lines"][next++])
                          : Json{{"length_m", nullptr}, {"foot", nullptr}, {"whole", nullptr}};
    one["problems"] = as_json(problems[k]);
    list.push_back(std::move(one));
  }
  answered["lines"] = std::move(list);
  return answered;
}

Json answer_to(const Call& call, const Run& run, const RunStore& runs, AskedRuns& asked) {
  call.only({"line", "lines", "barrier", "polygon", "section_m", "height_m", "energy_kJ", "design", "precision",
             "sources", "drag"});
  const std::string question = question_of(call);
  const AnswerOptions options = options_of(call);
  const auto section = positive(call, "section_m");
  const DragOrder order(call, asked);
  const std::shared_ptr<OpenRun> open = asked.open(run);
  const Model& model = open->built->model;
  project::DesignBasis basis = basis_of(call, run, runs, *open);
  const bool has_design = open->built->project.design.has_value();
  add_kits_for_sliders(basis);
  if (section) basis.design.section_m = *section;
  Problems warnings;

  const std::lock_guard one_at_a_time(open->asking);
  order.check();
  if (question == "polygon") {
    const AskedArea area = drawn_area(model, places(call, "polygon"), "polygon", warnings);
    return with_selection(open->asked->area(basis, area, options), warnings, run, asked);
  }
  const double height = options.kit ? options.kit->height : asked_height;
  if (question == "lines") {
    const Json& given = call.body.at("lines");
    if (!given.is_array() || given.empty() || given.size() > most_lines)
      throw Refusal(400, "lines", "is not valid", fmt::format("expected a list of 1 to {} lines", most_lines));
    return answer_to_lines(*open, basis, given, height);
  }
  const AskedLine line = question == "barrier" ? line_of_barrier(model, call.text("barrier"), "barrier")
                                               : drawn_line(model, places(call, "line"), height, "line", warnings);
  if (!section && !has_design) basis.design.section_m = usual_section(line.barrier);
  return with_selection(open->asked->line(basis, line, options), warnings, run, asked);
}

Json answer_to_ditch(const Call& call, const Run& run, AskedRuns& asked) {
  call.only({"toe_m", "far_m"});
  const double toe = call.number("toe_m"), far_edge = call.number("far_m");
  const std::shared_ptr<OpenRun> open = asked.open(run);
  const std::lock_guard one_at_a_time(open->asking);
  const Ditch ditch = ditch_between(open->built->model, toe, far_edge, "ditch");
  const double confidence = project::design_basis(open->built->project).design.confidence;
  return with_selection(open->asked->ditch(ditch, confidence), {}, run, asked);
}

/// The places of release, in arrays.
Answer releases_of(const OpenRun& open) {
  const Model& model = open.built->model;
  const StoredSources& sources = open.asked->sources();
  const auto& spots = sources.spots.list();
  const Vec3 origin = spots.empty() ? Vec3{} : origin_near(model.frame.global_from_local(spots.front().place));
  std::vector<std::uint32_t> rocks, stored;
  std::vector<float> positions, sizes;
  std::vector<std::uint16_t> seeders, names;
  for (std::size_t k = 0; k < spots.size(); ++k) {
    const ReleaseSpot& spot = spots[k];
    rocks.push_back(static_cast<std::uint32_t>(spot.rocks));
    stored.push_back(static_cast<std::uint32_t>(sources.stored[k]));
    const Vec3 place = model.frame.global_from_local(spot.place) - origin;
    for (int i = 0; i < 3; ++i) positions.push_back(static_cast<float>(place[i]));
    for (int i = 0; i < 2; ++i) sizes.push_back(static_cast<float>(spot.size[i]));
    seeders.push_back(static_cast<std::uint16_t>(spot.seeder.index));
    names.push_back(static_cast<std::uint16_t>(spot.source.index));
  }
  Json seeder_names = Json::array();
  for (const Seeder& seeder : model.seeders) seeder_names.push_back(seeder.name);
  Arrays arrays({{"origin", {origin.x(), origin.y(), origin.z()}},
                 {"seeders", std::move(seeder_names)},
                 {"sources", model.sources},
                 {"places", spots.size()}});
  arrays.add("rocks", std::span<const std::uint32_t>(rocks));
  arrays.add("stored", std::span<const std::uint32_t>(stored));
  arrays.add("positions", std::span<const float>(positions));
  arrays.add("sizes", std::span<const float>(sizes));
  arrays.add("seeders", std::span<const std::uint16_t>(seeders));
  arrays.add("sources", std::span<const std::uint16_t>(names));
  return arrays.answer();
}

}  // namespace

void add_line_routes(Router& router, RunStore& runs, AskedRuns& asked) {
  router.post(one_run + "/line",
              [&](const Call& call) { return json_answer(answer_to(call, runs.find(call.part(1)), runs, asked)); });
  router.post(one_run + "/ditch",
              [&](const Call& call) { return json_answer(answer_to_ditch(call, runs.find(call.part(1)), asked)); });
  router.get(one_run + "/releases",
             [&](const Call& call) { return releases_of(*asked.open(runs.find(call.part(1)))); });
}

}  // namespace talus::server
