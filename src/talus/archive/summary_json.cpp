#include "talus/archive/summary_json.hpp"

#include <cmath>

#include "talus/archive/design_json.hpp"

namespace talus {

namespace {

using Json = nlohmann::ordered_json;

Json number(std::optional<double> x) { return x && std::isfinite(*x) ? Json(*x) : Json(nullptr); }

Json histogram_json(const Tally& tally) {
  const auto histogram = tally.histogram(40);
  if (!histogram) return nullptr;
  const BinEdges& edges = histogram->edges();
  return {{"low", edges.edge(0)},
          {"width", (edges.edge(edges.bins) - edges.edge(0)) / static_cast<double>(edges.bins)},
          {"counts", histogram->counts()}};
}

/// What the model says of a barrier, and what rocks did there.
Json barrier_json(const Json& barrier, const BarrierTally& tally) {
  Json outcomes = Json::object();
  for (int k = 0; k < barrier_outcome_count; ++k) {
    const auto kind = static_cast<BarrierOutcome>(k);
    outcomes[name(kind)] = tally.outcomes[static_cast<std::size_t>(k)];
  }
  Json json = barrier;
  json["hits"] = tally.translational_energy.count();
  json["rocks_hit"] = tally.rocks_hit;
  json["passed_above"] = tally.rocks_passed_above;
  json["outcomes"] = std::move(outcomes);
  json["least_clearance_m"] = number(tally.least_clearance);
  if (tally.translational_energy.count() == 0) return json;
  json["statistics"] = {{"ke_translational_J", statistics_json(tally.translational_energy)},
                        {"ke_total_J", statistics_json(tally.total_energy)},
                        {"impact_height_m", statistics_json(tally.height)},
                        {"velocity_m_s", statistics_json(tally.velocity)}};
  json["histograms"] = {{"ke_translational_J", histogram_json(tally.translational_energy)},
                        {"impact_height_m", histogram_json(tally.height)}};
  return json;
}

/// As dump(1) has it so many levels deep; a text within it has no line ends.
std::string text_of(const Json& value, std::size_t depth) {
  // Names of files, of which there may be some in the warnings, need not be UTF-8.
  const std::string text = value.dump(1, ' ', false, Json::error_handler_t::replace);
  std::string indented;
  indented.reserve(text.size() + text.size() / 8);
  for (const char c : text) {
    indented += c;
    if (c == '\n') indented.append(depth, ' ');
  }
  return indented;
}

void write_barriers(TextSink& out, const Json& barriers, const Summary& summary) {
  out.write("[");
  for (std::size_t b = 0; b < summary.barriers.size(); ++b) {
    out.write(b == 0 ? "\n  " : ",\n  ");
    out.write(text_of(barrier_json(barriers.at(b), summary.barriers[b]), 2));
  }
  out.write(summary.barriers.empty() ? "]" : "\n ]");
}

}  // namespace

Json statistics_json(const Tally& tally) {
  const Descriptive d = tally.describe();
  const auto quantile = [&](double p) { return number(tally.sketch().quantile(p)); };
  return {{"mean", number(d.mean)},
          {"standard_error", number(d.standard_error)},
          {"median", number(d.median)},
          {"standard_deviation", number(d.standard_deviation)},
          {"sample_variance", number(d.sample_variance)},
          {"kurtosis", number(d.kurtosis)},
          {"skewness", number(d.skewness)},
          {"range", number(d.range)},
          {"minimum", number(d.minimum)},
          {"maximum", number(d.maximum)},
          {"sum", number(d.sum)},
          {"count", d.count},
          {"confidence_level_95", number(d.confidence_half_width_95)},
          {"quartiles", {quantile(0.25), quantile(0.5), quantile(0.75)}},
          {"percentiles", {{"95", quantile(0.95)}, {"99", quantile(0.99)}}}};
}

namespace {

/// How many rocks the tables hold one by one, of those done.
void add_rocks_in_tables(const io::RunDescription& description, const RunCourse& course, std::uint64_t done,
                         Json& json) {
  const io::TableRocks rocks = io::rocks_in_tables(description);
  std::uint64_t endpoints = 0, paths = 0;
  const auto add = [&](std::uint64_t first, std::uint64_t last) {
    endpoints += rocks.endpoints_before(last) - rocks.endpoints_before(first);
    paths += rocks.paths_before(last) - rocks.paths_before(first);
  };
  // The rocks done are all up to the first that was not, or those between the missing ones.
  std::uint64_t next = course.range.first;
  for (const RockRange& missing : course.missing) {
    add(next, missing.first);
    next = missing.last;
  }
  add(next, course.missing.empty() ? next + done : course.range.last);
  json["with_endpoint"] = endpoints;
  json["with_path"] = paths;
}

Json timings_json(const Summary& summary, const RunCourse& course) {
  return {{"seconds", course.seconds},
          {"rocks_per_second", course.seconds > 0 ? static_cast<double>(summary.done) / course.seconds : 0},
          {"threads", course.threads}};
}

}  // namespace

void write_summary(TextSink& out, const io::RunDescription& description, const std::vector<std::string>& warnings,
                   const Summary& summary, const RunCourse& course, const DesignResult* design) {
  Json ends = Json::object();
  for (int k = 0; k < end_reason_count; ++k) {
    const std::uint64_t count = summary.ended(static_cast<EndReason>(k));
    if (count > 0) ends[name(static_cast<EndReason>(k))] = count;
  }
  const Json& model = description.model;
  bool is_first = true;
  const auto begin = [&](const std::string& key) {
    out.write(is_first ? "{\n " : ",\n ");
    out.write(text_of(key, 1) + ": ");
    is_first = false;
  };
  const auto write = [&](const Json& entries) {
    for (const auto& [key, value] : entries.items()) {
      begin(key);
      out.write(text_of(value, 1));
    }
  };
  Json json;
  json["talus"] = {{"version", TALUS_VERSION}};
  json["name"] = description.name;
  json["fingerprint"] = description.fingerprint;
  json["seed"] = model.at("seed");
  json["rocks"] = {{"planned", summary.planned}, {"done", summary.done}, {"lifted", summary.lifted}};
  add_rocks_in_tables(description, course, summary.done, json["rocks"]);
  if (course.shard) {
    json["shard"] = {{"number", course.shard->number},
                     {"of", course.shard->of},
                     {"first_rock", course.range.first},
                     {"rocks", course.range.count()}};
  }
  json["interrupted"] = course.interrupted;
  if (!course.missing.empty()) {
    Json& missing = json["missing_rocks"] = Json::array();
    for (const RockRange& range : course.missing) missing.push_back({range.first, range.count()});
  }
  json["end_reasons"] = ends;
  json["events"] = summary.events;
  json["statistics"] = {{"end_x_m", statistics_json(summary.end_x)},
                        {"runout_xy_m", statistics_json(summary.runout_plan)},
                        {"runout_total_m", statistics_json(summary.runout_total)},
                        {"max_ke_J", statistics_json(summary.max_kinetic_energy)},
                        {"max_bounce_m", statistics_json(summary.max_bounce)}};
  json["histograms"] = {{"end_x_m", histogram_json(summary.end_x)},
                        {"runout_xy_m", histogram_json(summary.runout_plan)}};
  write(json);
  begin("barriers");
  write_barriers(out, model.at("barriers"), summary);
  json = Json::object();
  if (description.design && design != nullptr) json["design"] = io::design_json(*description.design, *design);
  json["sources"] = model.at("sources");
  json["warnings"] = warnings;
  json["notes"] = notes_of(summary);
  json["energy_datum_m"] = model.at("energy_datum_m");
  json["origin_m"] = model.at("origin_m");
  write(json);
  begin("terrain");
  out.write(text_of(model.at("terrain"), 1));
  begin("project");
  out.write(text_of(description.project, 1));
  write({{"timings", timings_json(summary, course)}});
  out.write("\n}\n");
}

}  // namespace talus
