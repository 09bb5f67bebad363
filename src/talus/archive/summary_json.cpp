#include "talus/archive/summary_json.hpp"

#include <memory>

#include "talus/archive/design_json.hpp"

namespace talus {

namespace {

using Json = nlohmann::ordered_json;

std::optional<HistogramCounts> histogram_of(const Tally& tally) {
  const auto histogram = tally.histogram(40);
  if (!histogram) return std::nullopt;
  const BinEdges& edges = histogram->edges();
  return HistogramCounts{edges.edge(0),
                         (edges.edge(edges.bins) - edges.edge(0)) / static_cast<double>(edges.bins),
                         {histogram->counts().begin(), histogram->counts().end()}};
}

/// A barrier of the model with its results.
BarrierSummary barrier_summary(BarrierPlace place, const BarrierTally& tally) {
  const auto count = [&](BarrierOutcome outcome) { return tally.outcomes[static_cast<std::size_t>(outcome)]; };
  BarrierSummary barrier{std::move(place)};
  barrier.hits = tally.translational_energy.count();
  barrier.rocks_hit = tally.rocks_hit;
  barrier.passed_above = tally.rocks_passed_above;
  barrier.outcomes = {.stopped = count(BarrierOutcome::stopped),
                      .rebounded = count(BarrierOutcome::rebounded),
                      .broke_through = count(BarrierOutcome::broke_through),
                      .passed = count(BarrierOutcome::passed)};
  barrier.least_clearance_m = tally.least_clearance;
  if (barrier.hits == 0) return barrier;
  barrier.statistics = {{"ke_translational_J", statistics_of(tally.translational_energy)},
                        {"ke_total_J", statistics_of(tally.total_energy)},
                        {"impact_height_m", statistics_of(tally.height)},
                        {"velocity_m_s", statistics_of(tally.velocity)}};
  barrier.histograms = {{"ke_translational_J", histogram_of(tally.translational_energy)},
                        {"impact_height_m", histogram_of(tally.height)}};
  return barrier;
}

/// Like dump(1), at a depth of `depth` levels; JSON strings contain no line ends.
std::string text_of(const Json& value, std::size_t depth) {
  // Warnings may contain file names that are not UTF-8.
  const std::string text = value.dump(1, ' ', false, Json::error_handler_t::replace);
  std::string indented;
  indented.reserve(text.size() + text.size() / 8);
  for (const char c : text) {
    indented += c;
    if (c == '\n') indented.append(depth, ' ');
  }
  return indented;
}

void write_barriers(TextSink& out, const Json& barriers, const Summary& sums) {
  out.write("[");
  for (std::size_t b = 0; b < sums.barriers.size(); ++b) {
    out.write(b == 0 ? "\n  " : ",\n  ");
    auto place = part_of<BarrierPlace>(barriers.at(b), "barriers");
    out.write(text_of(json_of(barrier_summary(std::move(place), sums.barriers[b])), 2));
  }
  out.write(sums.barriers.empty() ? "]" : "\n ]");
}

/// The number of rocks in the tables, of those done.
void add_rocks_in_tables(const RunDescription& description, const RunCourse& course, RunSummary::Rocks& counts) {
  const TableRocks rocks = rocks_in_tables(description);
  const auto add = [&](std::uint64_t first, std::uint64_t last) {
    counts.with_endpoint += rocks.endpoints_before(last) - rocks.endpoints_before(first);
    counts.with_path += rocks.paths_before(last) - rocks.paths_before(first);
  };
  // The rocks done are all before the first missing one, and those between the missing ranges.
  std::uint64_t next = course.range.first;
  for (const RockRange& missing : course.missing) {
    add(next, missing.first);
    next = missing.last;
  }
  add(next, course.missing.empty() ? next + counts.done : course.range.last);
}

/// The summary without its barriers.
RunSummary run_summary(const RunDescription& description, const Summary& sums, const RunCourse& course) {
  const Json& model = description.model;
  RunSummary summary;
  summary.talus = {TALUS_VERSION, description.paths_revision};
  summary.name = description.name;
  summary.fingerprint = description.fingerprint;
  summary.seed = part_of<std::uint64_t>(model.at("seed"), "seed");
  summary.rocks = {.planned = sums.planned, .done = sums.done, .lifted = sums.lifted};
  add_rocks_in_tables(description, course, summary.rocks);
  if (course.shard) {
    summary.shard = {.number = course.shard->number,
                     .of = course.shard->of,
                     .first_rock = course.range.first,
                     .rocks = course.range.count()};
  }
  summary.interrupted = course.interrupted;
  for (const RockRange& range : course.missing) summary.missing_rocks.push_back({range.first, range.count()});
  for (int k = 0; k < end_reason_count; ++k) {
    const auto reason = static_cast<EndReason>(k);
    if (sums.ended(reason) > 0) summary.end_reasons.emplace_back(name(reason), sums.ended(reason));
  }
  summary.events = static_cast<std::uint64_t>(sums.events);
  summary.ways = ways_of(sums);
  summary.statistics = {{"end_x_m", statistics_of(sums.end_x)},
                        {"runout_xy_m", statistics_of(sums.runout_plan)},
                        {"runout_total_m", statistics_of(sums.runout_total)},
                        {"max_ke_J", statistics_of(sums.max_kinetic_energy)},
                        {"max_bounce_m", statistics_of(sums.max_bounce)}};
  summary.histograms = {{"end_x_m", histogram_of(sums.end_x)}, {"runout_xy_m", histogram_of(sums.runout_plan)}};
  summary.trajectories = course.trajectories;
  summary.sources = part_of<std::vector<SourceRocks>>(model.at("sources"), "sources");
  summary.releases = part_of<std::vector<SeederReleases>>(model.at("releases"), "releases");
  if (model.contains("parameter_sets"))
    summary.parameter_sets = part_of<std::uint64_t>(model.at("parameter_sets"), "parameter_sets");
  summary.notes = notes_of(sums);
  summary.energy_datum_m = part_of<double>(model.at("energy_datum_m"), "energy_datum_m");
  summary.origin_m = part_of<std::array<double, 3>>(model.at("origin_m"), "origin_m");
  summary.terrain = part_of<TerrainSummary>(model.at("terrain"), "terrain");
  // The description outlives the summary.
  summary.project = SharedJson(std::shared_ptr<const Json>(), &description.project);
  summary.inputs = description.inputs;
  summary.timings = {.seconds = course.seconds,
                     .rocks_per_second = course.seconds > 0 ? static_cast<double>(sums.done) / course.seconds : 0,
                     .threads = static_cast<std::uint64_t>(course.threads)};
  return summary;
}

}  // namespace

WaysSummary ways_of(const Summary& sums) { return {sums.flown.value(), sums.on_ground.value()}; }

Statistics statistics_of(const Tally& tally) {
  const Descriptive d = tally.describe();
  const auto quantile = [&](double p) { return tally.sketch().quantile(p); };
  return {.mean = d.mean,
          .standard_error = d.standard_error,
          .median = d.median,
          .standard_deviation = d.standard_deviation,
          .sample_variance = d.sample_variance,
          .kurtosis = d.kurtosis,
          .skewness = d.skewness,
          .range = d.range,
          .minimum = d.minimum,
          .maximum = d.maximum,
          .sum = d.sum,
          .count = d.count,
          .confidence_level_95 = d.confidence_half_width_95,
          .quartiles = {quantile(0.25), quantile(0.5), quantile(0.75)},
          .percentiles = {quantile(0.95), quantile(0.99)}};
}

void write_summary(TextSink& out, const RunDescription& description, const ToldWarnings& warnings, const Summary& sums,
                   const RunCourse& course, const DesignResult* design) {
  RunSummary summary = run_summary(description, sums, course);
  summary.warnings = warnings.texts;
  summary.warning_kinds = warnings.kinds;
  if (description.design && design != nullptr)
    summary.design = std::make_shared<const Json>(design_json(*description.design, *design));
  bool is_first = true;
  for_fields<RunSummary>([&](const auto& field) {
    if (!is_there(summary, field)) return;
    const auto& value = summary.*field.member;
    out.write(is_first ? "{\n " : ",\n ");
    out.write(text_of(field.key, 1) + ": ");
    is_first = false;
    using Value = std::remove_cvref_t<decltype(value)>;
    if constexpr (std::is_same_v<Value, std::vector<BarrierSummary>>) {
      write_barriers(out, description.model.at("barriers"), sums);
    } else if constexpr (std::is_same_v<Value, SharedJson>) {
      out.write(text_of(*value, 1));
    } else {
      out.write(text_of(json_of(value), 1));
    }
  });
  out.write("\n}\n");
}

}  // namespace talus
