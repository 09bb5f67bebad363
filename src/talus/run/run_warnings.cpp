#include "talus/run/run_warnings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

#include "talus/archive/design_json.hpp"
#include "talus/archive/doubts.hpp"
#include "talus/archive/run_summary.hpp"
#include "talus/archive/summary_json.hpp"

namespace talus::project {

namespace {

/// End reasons that are limits of the data or the computation, not of the slope.
struct Limit {
  EndReason reason;
  const char* what;
  const char* hint;
};
constexpr Limit limits[] = {
    {EndReason::no_data, "ended where the terrain has no data", "Use a terrain that has data where rocks go"},
    {EndReason::maximum_steps, "were ended after the maximum number of steps", "Raise analysis.max_steps"},
    {EndReason::maximum_time, "were ended at the maximum time", "Raise analysis.max_time_s"}};

void warn_of_limits(const Summary& summary, Problems& warnings) {
  std::uint64_t all = 0;
  for (const Limit& limit : limits) all += summary.ended(limit.reason);
  if (!summary.are_many(all)) return;
  for (const auto& [reason, what, hint] : limits) {
    if (summary.ended(reason) == 0) continue;
    warnings.add({.severity = Severity::warning,
                  .where = "rocks",
                  .what = fmt::format("{} of {} rocks {}", summary.ended(reason), summary.done, what),
                  .why = "runout, reach and end points are cut there",
                  .hint = hint});
  }
}

}  // namespace

void warn_of_rocks(const Summary& summary, Problems& warnings) {
  const auto warn = [&](std::string where, std::string what, std::string why, std::string hint) {
    warnings.add({Severity::warning, "", 0, std::move(where), std::move(what), std::move(why), std::move(hint)});
  };
  if (summary.lifted > 0) {
    warn("seeders", fmt::format("{} of {} rocks were to start in the ground", summary.lifted, summary.done),
         "they were lifted onto it or lowered from a ceiling; without room for either they stay there, at rest",
         "`talus check` says which seeders and rows");
  }
  warn_of_limits(summary, warnings);
  doubt_ways(ways_of(summary), warnings);
  if (const std::uint64_t lost = summary.ended(EndReason::lost); lost > 0) {
    warn("rocks", fmt::format("{} of {} rocks fell through the surface", lost, summary.done),
         "this is a defect of the program, not of your project",
         fmt::format("Please report it with the output of `talus replay --rock {}`", *summary.first_lost));
  }
}

void warn_of_sources(const RunDescription& description, std::uint64_t first_not_run, Problems& warnings) {
  const auto releases = part_of<std::vector<SeederReleases>>(description.model.at("releases"), "releases");
  const auto sources = part_of<std::vector<SourceRocks>>(description.model.at("sources"), "sources");
  std::vector<std::uint64_t> released(sources.size());
  for (const SeederReleases& of : releases) {
    const std::uint64_t done = std::min(of.rocks, first_not_run - std::min(of.first_rock, first_not_run));
    of.for_sources([&](std::uint64_t source, std::uint64_t begin, std::uint64_t end) {
      released.at(source) += of.rocks_from(begin, end, done);
    });
  }
  std::vector<std::string> none, some;
  for (std::size_t k = 0; k < sources.size(); ++k) {
    if (released[k] < sources[k].rocks)
      (released[k] == 0 ? none : some).push_back(fmt::format("\"{}\"", sources[k].name));
  }
  // The first rocks of one seeder are spread over all of its places.
  if (none.empty() && releases.size() < 2) return;
  constexpr std::size_t most = 5;
  const auto list = [&](std::vector<std::string> names) {
    const std::size_t more = names.size() - std::min(names.size(), most);
    names.resize(names.size() - more);
    return fmt::format("{}{}", fmt::join(names, ", "), more > 0 ? fmt::format(" and {} more", more) : "");
  };
  std::string why = releases.size() < 2 ? "few rocks were run" : "rocks are run seeder after seeder";
  if (!some.empty()) why += fmt::format("; of {} not all were", list(some));
  warnings.add({.severity = Severity::warning,
                .where = "rocks",
                .what = none.empty() ? "the run was stopped before all sources had released their rocks"
                                     : fmt::format("the run was stopped before {} released any rock", list(none)),
                .why = why,
                .hint = "Go on with --resume; what there is says nothing of the whole"});
}

void warn_of_collectors(const RunDescription& description, const Summary& summary, Problems& warnings) {
  for (std::size_t k = 0; k < summary.barriers.size(); ++k) {
    const auto& barrier = description.model.at("barriers").at(k);
    const std::uint64_t above = summary.barriers[k].rocks_passed_above, hit = summary.barriers[k].rocks_hit;
    if (barrier.at("kind") != "collector" || above <= (hit + above) / 100) continue;
    warnings.add({.severity = Severity::warning,
                  .where = fmt::format("collector \"{}\"", barrier.at("name").get<std::string>()),
                  .what = fmt::format("{} of {} rocks passed above it", above, hit + above),
                  .why = "its hits are those of the others only; a design, and a line that is asked, have all",
                  .hint = "Raise its height_m"});
  }
}

void warn_of_design(const DesignPlan& plan, const DesignResult& result, Problems& warnings) {
  const auto name_of = [&](std::size_t line) { return fmt::format("line \"{}\"", plan.lines[line].name); };
  const auto warn = [&](std::size_t line, std::string what, std::string why, std::string hint) {
    warnings.add({.severity = Severity::warning,
                  .where = name_of(line),
                  .what = std::move(what),
                  .why = std::move(why),
                  .hint = std::move(hint)});
  };
  for (std::size_t k = 0; k < result.lines.size(); ++k) {
    doubt_needed_height(name_of(k), result.lines[k].whole, warnings);
    if (result.lines[k].whole.rocks > 0) continue;
    warn(k, "no rock crosses it", "there is nothing to design a barrier for",
         "Check where the line lies; with few rocks, run more");
  }
  if (result.ranking.empty()) return;
  if (const KitChoice& best = result.ranking.front(); best.suffices) {
    doubt_kit_height(name_of(best.line), best.height, result.lines[best.line].whole, warnings);
    return;
  }
  std::vector<bool> has_kit(plan.lines.size());
  for (const KitChoice& kit : result.ranking) {
    if (kit.limit == KitLimit::none || result.lines[kit.line].whole.rocks == 0 || has_kit[kit.line]) continue;
    has_kit[kit.line] = true;
    warn(kit.line, fmt::format("no kit catches {:g} % of the rocks", 100 * plan.catch_share), limit_text(plan, kit),
         "");
  }
}

}  // namespace talus::project
