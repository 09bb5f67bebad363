#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "results/run_summary.hpp"
#include "routes/results.hpp"
#include "talus/archive/column_statistics.hpp"
#include "talus/archive/summary_json.hpp"
#include "talus/statistics/box_plot.hpp"

namespace talus::server {

namespace {

constexpr std::uint64_t histogram_bins = 40;  // approximately; as in summary.json
constexpr std::uint64_t compared_bins = 50;   // at most, in comparisons of two runs
constexpr std::size_t cumulative_points = 400;

/// All values of a parameter. Refuses (400) values that are not in `known`.
std::vector<std::string> names_in(const Call& call, const std::string& key, const std::vector<std::string>& known) {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < call.request.get_param_value_count(key); ++k) {
    names.push_back(call.request.get_param_value(key, k));
    if (std::find(known.begin(), known.end(), names.back()) == known.end())
      throw Refusal(400, key, fmt::format("this run has no \"{}\"", names.back()),
                    fmt::format("expected one of {}", fmt::join(known, ", ")));
  }
  return names;
}

std::optional<double> energy_in(const Call& call, const std::string& key) {
  const std::string text = call.query(key);
  if (text.empty()) return std::nullopt;
  double energy = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), energy);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(energy))
    throw Refusal(400, key, fmt::format("\"{}\" is not an energy", text), "expected a number");
  return energy * 1000;
}

/// The filter of a request about one run, or about two: then a name of either run is accepted.
RockFilter filter_in(const Call& call, std::initializer_list<const RunFacts*> runs) {
  std::vector<std::string> reasons, seeders, sources, barriers;
  for (int k = 0; k < end_reason_count; ++k) reasons.emplace_back(name(static_cast<EndReason>(k)));
  const auto append = [](std::vector<std::string>& known, const std::vector<std::string>& more) {
    known.insert(known.end(), more.begin(), more.end());
  };
  for (const RunFacts* facts : runs) {
    append(seeders, seeders_of(*facts));
    append(sources, sources_of(*facts));
    append(barriers, barriers_of(*facts));
  }
  return {.end_reasons = names_in(call, "reason", reasons),
          .seeders = names_in(call, "seeder", seeders),
          .sources = names_in(call, "source", sources),
          .barriers = names_in(call, "barrier", barriers),
          .least_energy_J = energy_in(call, "min_energy_kJ"),
          .most_energy_J = energy_in(call, "max_energy_kJ")};
}

const NumberColumn& column_in(const Call& call, const std::vector<NumberColumn>& known) {
  const std::string wanted = call.query("of");
  const auto found = std::ranges::find(known, wanted, &NumberColumn::name);
  if (found != known.end()) return *found;
  std::vector<std::string_view> names;
  for (const NumberColumn& column : known) names.push_back(column.name);
  throw Refusal(400, "of", fmt::format("\"{}\" is not a column of numbers", wanted),
                fmt::format("expected one of {}", fmt::join(names, ", ")));
}

/// How many of the finished rocks are in endpoints.csv, where the filter chooses; null: all.
Json sample_json(const RunFacts& facts) {
  const std::uint64_t done = facts.summary.rocks.done, in_table = facts.in_tables.endpoints_before(done);
  return in_table == done ? Json() : Json{{"rocks", in_table}, {"of", done}};
}

Json statistics_answer(const Tally& tally, const NumberColumn& column, const std::optional<Histogram>& histogram,
                       Json sample = {}) {
  Json edges = Json::array(), counts = Json::array(), cumulative = Json::array(), box;
  if (histogram) {
    const BinEdges& bins = histogram->edges();
    for (std::uint64_t k = 0; k <= bins.bins; ++k) edges.push_back(bins.edge(k));
    counts = histogram->counts();
  }
  for (const auto& [value, share] : talus::cumulative(tally, cumulative_points)) cumulative.push_back({value, share});
  if (const auto plot = box_plot(tally.sketch())) {
    const Descriptive all = tally.describe();
    box = {{"least", *all.minimum},  {"whisker_low", plot->lower_whisker}, {"q1", plot->lower_quartile},
           {"median", plot->median}, {"q3", plot->upper_quartile},         {"whisker_high", plot->upper_whisker},
           {"most", *all.maximum}};
  }
  return {{"of", column.name},
          {"unit", column.unit},
          {"count", tally.count()},
          {"sample", std::move(sample)},
          {"statistics", json_of(statistics_of(tally))},
          {"histogram", {{"edges", std::move(edges)}, {"counts", std::move(counts)}}},
          {"cumulative", std::move(cumulative)},
          {"box", std::move(box)}};
}

/// Statistics of two runs, with the same histogram bins.
Json compared_answer(const Tally& here, const Tally& there, const NumberColumn& column) {
  auto a = here.histogram(histogram_bins), b = there.histogram(histogram_bins);
  if (a && b) {
    const BinEdges edges = common_bins(a->edges(), b->edges(), compared_bins);
    a = a->regrouped(edges);
    b = b->regrouped(edges);
  }
  return {{"runs", Json::array({statistics_answer(here, column, a), statistics_answer(there, column, b)})}};
}

/// The hits on the barrier of this name; an empty tally if the run has no such barrier.
Tally hits_in(const std::filesystem::path& folder, const RunFacts& facts, std::string_view barrier,
              std::string_view column, const RockFilter& filter) {
  if (std::ranges::find(facts.barriers, barrier, &BarrierFacts::name) == facts.barriers.end())
    return Tally(facts.planned_rocks());
  return barrier_statistics(folder, facts, barrier, column, filter);
}

/// A barrier in the summary, with its design if the project has one.
Json barrier_json(const BarrierFacts& barrier, const RunSummary& summary) {
  Json design;
  if (summary.design)
    for (const Json& line : summary.design->at("lines"))
      if (line.value("name", "") == barrier.name) design = line;
  return {{"name", barrier.name},
          {"kind", barrier.kind},
          {"height_m", barrier.height_m},
          {"capacity_kJ", barrier.capacity_kJ ? Json(*barrier.capacity_kJ) : Json()},
          {"hits", barrier.hits},
          {"rocks_hit", barrier.rocks_hit},
          {"stopped", barrier.outcomes.stopped},
          {"rebounded", barrier.outcomes.rebounded},
          {"passed_through", barrier.outcomes.broke_through + barrier.outcomes.passed},
          {"passed_above", barrier.passed_above},
          {"statistics", barrier.statistics.empty() ? Json() : json_of(barrier.statistics)},
          {"design", std::move(design)}};
}

}  // namespace

void add_statistics_routes(Router& router, RunStore& runs, AskedRuns& asked) {
  router.get(one_run + "/statistics", [&](const Call& call) {
    const Run run = runs.find(call.part(1));
    const auto folder = results_folder(run);
    const NumberColumn& column = column_in(call, endpoint_numbers());
    const RunFacts facts = read_facts(run);
    RockFilter filter = filter_in(call, {&facts});
    filter.passes = rocks_passing(call, run, asked);
    const Tally tally = endpoint_statistics(folder, facts, column.name, filter);
    return json_answer(statistics_answer(tally, column, tally.histogram(histogram_bins), sample_json(facts)));
  });
  router.get(one_run + "/compared/([A-Za-z0-9._-]+)/statistics", [&runs](const Call& call) {
    const Run here = runs.find(call.part(1)), there = runs.find(call.part(2));
    const auto folder = results_folder(here), other = results_folder(there);
    const RunFacts facts = read_facts(here), others = read_facts(there);
    const RockFilter filter = filter_in(call, {&facts, &others});
    if (const std::string barrier = call.query("hits_on"); !barrier.empty()) {
      const NumberColumn& column = column_in(call, barrier_numbers());
      return json_answer(compared_answer(hits_in(folder, facts, barrier, column.name, filter),
                                         hits_in(other, others, barrier, column.name, filter), column));
    }
    const NumberColumn& column = column_in(call, endpoint_numbers());
    return json_answer(compared_answer(endpoint_statistics(folder, facts, column.name, filter),
                                       endpoint_statistics(other, others, column.name, filter), column));
  });
  router.get(one_run + "/barriers", [&runs](const Call& call) {
    const Run run = runs.find(call.part(1));
    const RunFacts facts = read_facts(run);
    Json list = Json::array();
    for (const BarrierFacts& barrier : facts.barriers) list.push_back(barrier_json(barrier, facts.summary));
    return json_answer({{"barriers", std::move(list)}});
  });
  router.get(one_run + "/barriers/([0-9]{1,9})/statistics", [&](const Call& call) {
    const Run run = runs.find(call.part(1));
    const auto folder = results_folder(run);
    const RunFacts facts = read_facts(run);
    const std::size_t number = std::stoull(call.part(2));
    if (number >= facts.barriers.size())
      throw Refusal(404, call.part(2), "there is no such barrier",
                    fmt::format("this run has {}, numbered from 0", facts.barriers.size()));
    const NumberColumn& column = column_in(call, barrier_numbers());
    RockFilter filter = filter_in(call, {&facts});
    filter.passes = rocks_passing(call, run, asked);
    const Tally tally = barrier_statistics(folder, facts, facts.barriers[number].name, column.name, filter);
    Json answer = statistics_answer(tally, column, tally.histogram(histogram_bins),
                                    filter.is_empty() ? Json() : sample_json(facts));
    // The summary squares the magnitude of the velocity, the table adds up squares: energies differ in the last bit.
    const Statistics* const known = find_named(facts.barriers[number].statistics, column.name);
    if (filter.is_empty() && known != nullptr) answer["statistics"] = json_of(*known);
    return json_answer(answer);
  });
}

}  // namespace talus::server
