#include "talus/archive/run_summary.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "talus/files/json_file.hpp"

namespace talus {

namespace {

constexpr const char* folder_hint = "Name a folder that `talus run` has written";
constexpr const char* damaged_hint = "The file was cut short or damaged; run the project again to write it anew";

/// The outermost object; its barriers are passed to `take` as soon as each is read.
JsonValue parse_summary(const std::filesystem::path& file, const std::function<void(const JsonValue&)>& take) {
  const std::string text = text_of_json_file(file, folder_hint, most_json_bytes);
  const auto refuse = [&](std::string what, std::string why, int line = 0) {
    throw BadInput(Problem{
        .file = file.string(), .line = line, .what = std::move(what), .why = std::move(why), .hint = damaged_hint});
  };
  JsonValue json;
  try {
    json = parse_without_list<JsonValue>(text, "barriers", take, true);
  } catch (const JsonValue::parse_error& error) {
    const auto before = std::min(error.byte, text.size());
    const bool at_end = text.find_first_not_of(" \t\r\n", before) == std::string::npos;
    const auto line_ends = std::ranges::count(std::string_view(text).substr(0, before), '\n');
    refuse(at_end ? "the JSON ends too early" : "is not JSON",
           at_end ? fmt::format("after {} bytes", text.size()) : fmt::format("at byte {}", error.byte),
           1 + static_cast<int>(line_ends));
  } catch (const JsonValue::out_of_range&) {
    refuse("has a number that is too large", "expected numbers that 64 bits can hold");
  }
  return json;
}

}  // namespace

void ToldWarnings::add(const Problem& problem, std::string text) {
  if (problem.kind != ProblemKind::other)
    kinds.push_back({texts.size(), std::string(word(problem.kind)), problem.where});
  texts.push_back(std::move(text));
}

std::optional<FieldFault> HistogramCounts::fault() const {
  if (width > 0) return std::nullopt;
  return FieldFault{"is not a histogram", "expected a width above 0"};
}

std::optional<FieldFault> Relief::fault() const {
  // (Two numbers whose product is one need not fit into 64 bits.)
  const bool is_grid = cell_m > 0 && columns > 0 && z_m.size() % columns == 0 && z_m.size() / columns == rows;
  if (is_grid || (columns == 0 && z_m.empty())) return std::nullopt;
  return FieldFault{
      "is not a grid",
      fmt::format("expected a cell_m above 0 and columns times rows heights z_m, {} x {}", columns, rows)};
}

std::optional<FieldFault> TerrainSummary::fault() const {
  if (section.size() != 1) return std::nullopt;
  return FieldFault{"has a section that is not a line", "expected two or more vertices [x, z]"};
}

std::optional<FieldFault> SeederReleases::fault() const {
  const bool is_in_order = std::ranges::is_sorted(sources, {}, [](const auto& run) { return run[0]; });
  if (places > 0 && rocks_at_once > 0 && !sources.empty() && sources.front()[0] == 0 && is_in_order)
    return std::nullopt;
  return FieldFault{"is not an order of releases",
                    "expected places and rocks_at_once above 0, and sources in the order of their places, from 0"};
}

std::uint64_t SeederReleases::source_of(std::uint64_t rock) const {
  const auto after = std::ranges::upper_bound(sources, place_of(rock), {}, [](const auto& run) { return run[0]; });
  return (*std::prev(after))[1];
}

std::optional<FieldFault> ReportInputs::fault() const {
  if (logo.empty() || logo.starts_with("data:image/png;base64,") || logo.starts_with("data:image/jpeg;base64,"))
    return std::nullopt;
  return FieldFault{"has a logo that is no picture", "expected a PNG or JPEG picture as a data: address"};
}

Statistics BarrierSummary::statistics_of(std::string_view quantity) const {
  const Statistics* const known = find_named(statistics, quantity);
  return known == nullptr ? Statistics{} : *known;
}

void refuse_summary(const std::filesystem::path& file, const BadField& bad) {
  refuse_json_file(file, bad.where, bad.what, bad.why, folder_hint);
}

namespace {

/// Checks that the seeders share the rocks, one after the other, and that their sources are there.
void check_releases(const RunSummary& summary) {
  std::uint64_t next = 0;
  for (std::size_t k = 0; k < summary.releases.size(); ++k) {
    const SeederReleases& of = summary.releases[k];
    if (of.first_rock != next || of.rocks > summary.rocks.planned - next)
      throw BadField{fmt::format("releases/{}", k), fmt::format("has rocks {} from {}", of.rocks, of.first_rock),
                     fmt::format("expected rocks from {}, of {}", next, summary.rocks.planned)};
    next += of.rocks;
    for (const auto& [place, source] : of.sources) {
      if (source >= summary.sources.size())
        throw BadField{fmt::format("releases/{}/sources", k), fmt::format("names source {}", source),
                       fmt::format("expected a number below {}", summary.sources.size())};
    }
  }
}

}  // namespace

RunSummary read_run_summary(const std::filesystem::path& file, const std::function<void(BarrierSummary)>& take) {
  RunSummary summary;
  std::vector<BarrierSummary> barriers;
  std::size_t number = 0;
  try {
    const JsonPlace whole, list(whole, "barriers");
    const JsonValue json = parse_summary(file, [&](const JsonValue& given) {
      BarrierSummary barrier;
      read_json(given, JsonPlace(list, number++), barrier);
      if (take) {
        take(std::move(barrier));
      } else {
        barriers.push_back(std::move(barrier));
      }
    });
    read_json(json, whole, summary);
    check_releases(summary);
  } catch (const BadField& bad) {
    refuse_summary(file, bad);
  }
  summary.barriers = std::move(barriers);
  return summary;
}

RunIdentity read_run_identity(const std::filesystem::path& file) {
  constexpr std::array<std::string_view, 7> keys{"talus",       "fingerprint", "rocks",  "shard",
                                                 "interrupted", "ways",        "project"};
  RunSummary summary;
  try {
    const JsonValue json = parse_summary(file, [](const JsonValue&) {});
    read_fields(json, {}, summary, [&](std::string_view key) { return std::ranges::find(keys, key) != keys.end(); });
  } catch (const BadField& bad) {
    refuse_summary(file, bad);
  }
  return static_cast<RunIdentity&&>(summary);
}

}  // namespace talus
