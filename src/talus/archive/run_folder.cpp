#include "talus/archive/run_folder.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>

#include "talus/archive/envelope_table.hpp"
#include "talus/archive/path_reader.hpp"
#include "talus/archive/spread_sample.hpp"
#include "talus/archive/table_columns.hpp"
#include "talus/core/problems.hpp"
#include "talus/files/csv_reader.hpp"
#include "talus/files/json_file.hpp"
#include "talus/files/json_text.hpp"
#include "talus/files/ordinary_file.hpp"

namespace talus::io {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_impacts = 100;  // for which losses are kept by number

[[noreturn]] void refuse(const std::filesystem::path& file, std::string where, std::string what, std::string why,
                         std::string hint = {}, int line = 0) {
  throw BadInput(Problem{.file = file.string(),
                         .line = line,
                         .where = std::move(where),
                         .what = std::move(what),
                         .why = std::move(why),
                         .hint = std::move(hint)});
}

constexpr std::size_t most_barriers = 100;  // that a report shows one by one

constexpr auto cut_short = "The file was cut short or damaged; run the project again to get it whole";
constexpr auto name_a_run = "Name a folder that `talus run` has written";

std::string date_of(const std::filesystem::path& file) {
  const auto written = std::chrono::file_clock::to_sys(std::filesystem::last_write_time(file));
  const auto seconds = std::chrono::time_point_cast<std::chrono::seconds>(written);
  return fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(std::chrono::system_clock::to_time_t(seconds)));
}

// ---- summary.json

// The shape of what the page reads: a wrong type is refused here, once, and what is missing is left to the page.
// `within`: where in the summary the part stands, if it is not the whole.
void expect_kind(const Json& part, const std::string& pointer, Json::value_t kind, const std::string& file,
                 const std::string& within = "") {
  const Json::json_pointer place(pointer);
  if (!part.contains(place)) return;
  const Json& value = part.at(place);
  const bool fits = kind == Json::value_t::number_float ? value.is_number() : value.type() == kind;
  if (fits) return;
  const Json example(kind);  // for the kind's name
  refuse(file, within + (within.empty() ? pointer.substr(1) : pointer),
         fmt::format("the value is of type {}", value.type_name()), fmt::format("expected {}", example.type_name()));
}

void check_sketch(const Json& node, const std::string& where, const std::string& file) {
  for (const auto& item : node.items()) {
    const Json& histogram = item.value();
    const auto number = [&](const char* key) { return histogram.contains(key) && histogram.at(key).is_number(); };
    const bool has_counts = histogram.is_object() && histogram.contains("counts") &&
                            histogram.at("counts").is_array() &&
                            std::ranges::all_of(histogram.at("counts"), [](const auto& n) { return n.is_number(); });
    if (histogram.is_null() || (has_counts && number("low") && number("width") && histogram.at("width") > 0)) continue;
    refuse(file, fmt::format("{}/{}", where, item.key()), "is not a histogram",
           "expected the numbers low and width (more than 0) and the list of numbers counts");
  }
}

void check_terrain(const Json& terrain, const std::string& file) {
  if (terrain.contains("section")) {
    const auto& section = terrain.at("section");
    const auto is_vertex = [](const auto& v) {
      return v.is_array() && v.size() == 2 && v[0].is_number() && v[1].is_number();
    };
    if (!section.is_array() || section.size() < 2 || !std::ranges::all_of(section, is_vertex)) {
      refuse(file, "terrain/section", "is not a line", "expected two or more vertices [x, z]");
    }
  }
  if (terrain.contains("relief") && !terrain.at("relief").is_null()) {
    const auto& relief = terrain.at("relief");
    for (const char* key : {"x0", "y0", "cell_m", "columns", "rows"}) {
      if (!relief.contains(key) || !relief.at(key).is_number()) {
        refuse(file, "terrain/relief", "is not a grid", fmt::format("expected the number {}", key));
      }
    }
    const auto cells = relief.at("columns").get<double>() * relief.at("rows").get<double>();
    if (!relief.contains("z_m") || !relief.at("z_m").is_array() ||
        static_cast<double>(relief.at("z_m").size()) != cells || !(relief.at("cell_m") > 0)) {
      refuse(file, "terrain/relief", "is not a grid",
             fmt::format("expected a cell_m above 0 and columns times rows, {}, heights z_m", cells));
    }
  }
}

// A model may hold millions of triangles in its own file; on paper only their number is of use.
void shorten_long_lists(Json& node) {
  constexpr std::size_t most = 400;
  if (node.is_array() && node.size() > most) {
    node = fmt::format("{} entries", node.size());
  } else if (node.is_structured()) {
    for (auto& child : node) shorten_long_lists(child);
  }
}

/// Of all barriers those that a report shows: the ones with the most hits.
class BarriersWithMostHits {
 public:
  void add(Json barrier) {
    const bool is_known = barrier.is_object() && barrier.contains("hits") && barrier.at("hits").is_number_unsigned();
    kept_.push_back({is_known ? barrier.at("hits").get<std::uint64_t>() : std::numeric_limits<std::uint64_t>::max(),
                     total_++, std::move(barrier)});
    if (kept_.size() == 2 * most_barriers) leave_out();
  }
  [[nodiscard]] std::size_t total() const { return total_; }
  struct Kept {
    std::uint64_t hits;
    std::size_t number;  // in the summary, from 0
    Json barrier;
  };
  /// In the order of the summary.
  [[nodiscard]] std::vector<Kept> take() {
    leave_out();
    std::ranges::sort(kept_, {}, &Kept::number);
    return std::move(kept_);
  }

 private:
  void leave_out() {
    if (kept_.size() <= most_barriers) return;
    std::ranges::stable_sort(kept_, std::ranges::greater(), &Kept::hits);
    kept_.resize(most_barriers);
  }

  std::vector<Kept> kept_;
  std::size_t total_ = 0;
};

/// `all_barriers`: how many the summary has.
Json read_summary(const std::filesystem::path& path, std::size_t& all_barriers) {
  const std::string file = path.string();
  if (const auto why = not_an_ordinary_file(path)) refuse(path, "", "cannot be opened", *why, name_a_run);
  std::error_code error_code;
  if (const auto bytes = std::filesystem::file_size(path, error_code); !error_code && bytes > most_json_bytes) {
    refuse(path, "", fmt::format("the file has {} MiB", bytes >> 20U),
           fmt::format("a summary has at most {} MiB", most_json_bytes >> 20U), cut_short);
  }
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    refuse(path, "", std::filesystem::exists(path, error_code) ? "cannot be opened" : "there is no such file",
           "a run's folder holds it once the run is done", name_a_run);
  }
  const std::string all{std::istreambuf_iterator<char>(stream), {}};
  if (const std::size_t depth = depth_of_json(all); depth > deepest_json) {
    refuse(path, "", fmt::format("holds lists within lists, {} deep", depth),
           fmt::format("a summary has at most {}", deepest_json), name_a_run);
  }
  Json summary;
  BarriersWithMostHits barriers;
  try {
    summary = parse_without_list<Json>(
        all, "barriers", [&](Json barrier) { barriers.add(std::move(barrier)); }, true);
  } catch (const Json::parse_error& error) {
    const auto before = std::min(error.byte, all.size());
    const bool at_end = all.find_first_not_of(" \t\r\n", before) == std::string::npos;
    const auto line_ends = std::ranges::count(std::string_view(all).substr(0, before), '\n');
    refuse(path, "", at_end ? "the JSON ends too early" : "is not JSON",
           at_end ? fmt::format("after {} bytes", all.size()) : fmt::format("at byte {}", error.byte), cut_short,
           1 + static_cast<int>(line_ends));
  } catch (const Json::out_of_range&) {
    refuse(path, "", "holds a number that is too large", "expected numbers that 64 bits can hold", cut_short);
  }
  using kind = Json::value_t;
  if (!summary.is_object()) {
    refuse(path, "", "does not hold a JSON object", "expected {\"talus\": ..., \"rocks\": ...}");
  }
  for (const char* key :
       {"/talus", "/project", "/rocks", "/end_reasons", "/terrain", "/statistics", "/histograms", "/timings"}) {
    expect_kind(summary, key, kind::object, file);
  }
  for (const char* key : {"/barriers", "/warnings"}) expect_kind(summary, key, kind::array, file);
  for (const char* key : {"/name", "/date", "/talus/version"}) expect_kind(summary, key, kind::string, file);
  for (const char* key : {"/rocks/planned", "/rocks/done", "/rocks/with_endpoint", "/rocks/with_path"})
    expect_kind(summary, key, kind::number_float, file);
  expect_kind(summary, "/interrupted", kind::boolean, file);
  if (summary.contains("terrain")) check_terrain(summary.at("terrain"), file);
  if (summary.contains("histograms")) check_sketch(summary.at("histograms"), "histograms", file);
  if (summary.contains("statistics")) {
    for (const auto& [name, node] : summary.at("statistics").items()) {
      // Not by a pointer: a name may hold what means something there.
      if (node.is_null() || node.is_object()) continue;
      refuse(path, "statistics/" + name, fmt::format("the value is of type {}", node.type_name()), "expected object");
    }
  }
  all_barriers = barriers.total();
  for (auto& [hits, number, barrier] : barriers.take()) {
    const std::string where = fmt::format("barriers/{}", number);
    expect_kind(barrier, "", kind::object, file, where);
    expect_kind(barrier, "/name", kind::string, file, where);
    for (const char* key : {"/outcomes", "/statistics", "/histograms"})
      expect_kind(barrier, key, kind::object, file, where);
    if (barrier.contains("histograms")) check_sketch(barrier.at("histograms"), where + "/histograms", file);
    summary["barriers"].push_back(std::move(barrier));
  }
  if (summary.contains("project")) shorten_long_lists(summary.at("project"));
  return summary;
}

// ---- the tables

std::array<double, 3> triple(const CsvReader& row, std::size_t first) {
  return {row.number(first), row.number(first + 1), row.number(first + 2)};
}

Kept<EndPoint> read_endpoints(const std::filesystem::path& file, std::size_t limit) {
  constexpr auto at = [](std::string_view name) { return place_of(endpoint_columns, name); };
  CsvReader row(file, endpoint_columns);
  SpreadSample<EndPoint> sample(limit, std::numeric_limits<std::size_t>::max());
  Kept<EndPoint> kept{.has_file = true};
  for (; row.next(); ++kept.total) {
    const auto rock = static_cast<std::uint64_t>(row.whole_number(at("rock")));
    if (!sample.wants(rock)) continue;
    sample.add(rock, 1,
               {.rock = rock,
                .seeder = std::string(row.text(at("seeder"))),
                .end_reason = std::string(row.text(at("end_reason"))),
                .position_m = triple(row, at("x_m")),
                .runout_xy_m = row.number(at("runout_xy_m")),
                .runout_total_m = row.number(at("runout_total_m")),
                .time_s = row.number(at("time_s")),
                .max_ke_J = row.number(at("max_ke_J")),
                .max_bounce_m = row.number(at("max_bounce_m"))});
  }
  kept.items = sample.take();
  return kept;
}

// Follows the rows of paths.csv, one rock after the other.
class PathTable {
 public:
  explicit PathTable(const Limits& limits) : sample_(limits.paths, limits.path_rows) {}

  void add(const CsvReader& row) {
    constexpr auto at = [](std::string_view name) { return place_of(path_columns, name); };
    const auto rock = static_cast<std::uint64_t>(row.whole_number(at("rock")));
    const PathState state = state_in(row, at("state"));
    if (!in_path_) {
      begin(rock);
    } else if (rock != path_.rock) {
      row.refuse("", fmt::format("rock {} begins before rock {} has ended", rock, path_.rock),
                 "a path's last row has the state ended", "The file was cut or joined by hand; run the project again");
    }
    const double energy_J =
        row.number(at("ke_translational_J")) + row.number(at("ke_rotational_J")) + row.number(at("pe_J"));
    if (arrived_with_J_) count_loss(*arrived_with_J_ - energy_J);
    arrived_with_J_.reset();
    if (state == PathState::impact) arrived_with_J_ = energy_J;
    if (wanted_) {
      path_.rows.push_back({.event = static_cast<std::uint64_t>(row.whole_number(at("event"))),
                            .state = state,
                            .time_s = row.number(at("time_s")),
                            .position_m = triple(row, at("x_m")),
                            .velocity_m_s = triple(row, at("vx_m_s")),
                            .ke_translational_J = row.number(at("ke_translational_J")),
                            .ke_rotational_J = row.number(at("ke_rotational_J")),
                            .pe_J = row.number(at("pe_J"))});
    }
    if (state == PathState::ended) end();
  }

  /// The rock whose path has not ended, after the last row.
  [[nodiscard]] std::optional<std::uint64_t> unfinished() const {
    return in_path_ ? std::optional(path_.rock) : std::nullopt;
  }
  [[nodiscard]] Kept<Path> take() { return {.has_file = true, .total = rocks_, .items = sample_.take()}; }
  [[nodiscard]] std::vector<ImpactLoss> losses() { return std::move(losses_); }

 private:
  void begin(std::uint64_t rock) {
    path_ = {.rock = rock};
    in_path_ = true;
    wanted_ = sample_.wants(rock);
    impacts_ = 0;
    ++rocks_;
  }

  void end() {
    in_path_ = false;
    const std::size_t weight = path_.rows.size();
    if (wanted_) sample_.add(path_.rock, weight, std::move(path_));
  }

  void count_loss(double lost_J) {
    if (impacts_ == most_impacts) return;
    if (losses_.size() == impacts_) losses_.push_back({.least_J = lost_J, .most_J = lost_J});
    ImpactLoss& loss = losses_[impacts_++];
    ++loss.count;
    loss.sum_J += lost_J;
    loss.least_J = std::min(loss.least_J, lost_J);
    loss.most_J = std::max(loss.most_J, lost_J);
  }

  SpreadSample<Path> sample_;
  std::vector<ImpactLoss> losses_;
  std::uint64_t rocks_ = 0;
  Path path_;
  bool in_path_ = false, wanted_ = false;
  std::size_t impacts_ = 0;
  std::optional<double> arrived_with_J_;
};

void read_paths(const std::filesystem::path& file, const Limits& limits, RunFolder& run) {
  CsvReader row(file, path_columns);
  PathTable table(limits);
  while (row.next()) table.add(row);
  if (const auto rock = table.unfinished()) {
    refuse(file, "", fmt::format("the path of rock {} does not end", *rock), "a path's last row has the state ended",
           cut_short);
  }
  run.paths = table.take();
  run.impact_losses = table.losses();
}

Kept<BarrierHit> read_hits(const std::filesystem::path& file, std::size_t limit) {
  constexpr auto at = [](std::string_view name) { return place_of(barrier_columns, name); };
  CsvReader row(file, barrier_columns);
  SpreadSample<BarrierHit> sample(std::numeric_limits<std::size_t>::max(), limit);
  Kept<BarrierHit> kept{.has_file = true};
  for (; row.next(); ++kept.total) {
    const auto rock = static_cast<std::uint64_t>(row.whole_number(at("rock")));
    if (!sample.wants(rock)) continue;
    sample.add(rock, 1,
               {.barrier = std::string(row.text(at("barrier"))),
                .outcome = std::string(row.text(at("outcome"))),
                .rock = rock,
                .time_s = row.number(at("time_s")),
                .position_m = triple(row, at("x_m")),
                .impact_height_m = row.number(at("impact_height_m")),
                .angle_deg = row.number(at("angle_deg")),
                .ke_translational_J = row.number(at("ke_translational_J")),
                .ke_total_J = row.number(at("ke_total_J"))});
  }
  kept.items = sample.take();
  return kept;
}

void check_count(const RunFolder& run, const std::filesystem::path& endpoints) {
  const Json::json_pointer with_endpoint("/rocks/with_endpoint"), done("/rocks/done");
  const Json::json_pointer& counted = run.summary.contains(with_endpoint) ? with_endpoint : done;
  if (!run.endpoints.has_file || !run.summary.contains(counted)) return;
  if (run.summary.at(counted) == run.endpoints.total) return;
  refuse(endpoints, "", fmt::format("holds {} {}", run.endpoints.total, run.endpoints.total == 1 ? "rock" : "rocks"),
         fmt::format("summary.json beside it counts {}", run.summary.at(counted).dump()),
         "The files are of different runs, or one was cut short; run the project again");
}

void note_what_is_missing(RunFolder& run) {
  std::vector<std::string> missing;
  for (const char* key : {"talus", "project", "name", "seed", "rocks", "end_reasons", "terrain", "statistics",
                          "histograms", "barriers", "warnings", "timings"}) {
    if (!run.summary.contains(key)) missing.emplace_back(key);
  }
  if (!missing.empty()) run.notes.push_back(fmt::format("summary.json does not say: {}.", fmt::join(missing, ", ")));
  const auto note = [&](bool has_file, const char* text) {
    if (!has_file) run.notes.emplace_back(text);
  };
  note(run.endpoints.has_file, "There is no endpoints.csv, so no single end points are shown.");
  note(run.paths.has_file, "There is no paths.csv, so no paths, energies along a path or losses at impacts are shown.");
  const bool has_barriers = run.summary.contains("barriers") && !run.summary.at("barriers").empty();
  note(run.hits.has_file || !has_barriers, "There is no barriers.csv, so no single hits on barriers are shown.");
}

}  // namespace

RunFolder read_run_folder(const std::filesystem::path& folder, const Limits& limits, const char* summary) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(folder, ignored)) {
    refuse(folder, "", std::filesystem::exists(folder, ignored) ? "is not a folder" : "there is no such folder",
           "expected the folder of a run", name_a_run);
  }
  RunFolder run{.folder = folder};
  Problems problems;
  const auto attempt = [&](const char* name, bool optional, auto&& read) {
    const std::filesystem::path file = folder / name;
    if (optional && !std::filesystem::exists(file, ignored)) return;
    try {
      read(file);
    } catch (const BadInput& bad) {
      problems.append(bad.problems());
    }
  };
  attempt(summary, false, [&](const auto& file) {
    std::size_t barriers = 0;
    run.summary = read_summary(file, barriers);
    if (barriers > most_barriers) {
      run.notes.push_back(
          fmt::format("Of {} barriers and collectors the {} with the most hits are shown one by one; "
                      "summary.json has all of them.",
                      barriers, most_barriers));
    }
    run.date = run.summary.value("date", date_of(file));
  });
  attempt("endpoints.csv", true, [&](const auto& file) {
    run.endpoints = read_endpoints(file, limits.endpoints);
    check_count(run, file);
  });
  attempt("paths.csv", true, [&](const auto& file) { read_paths(file, limits, run); });
  attempt("barriers.csv", true, [&](const auto& file) { run.hits = read_hits(file, limits.hits); });
  attempt("maps", true, [&](const auto&) { run.maps = read_report_maps(folder); });
  attempt(envelopes_name, true, [&](const auto& file) { run.envelopes = read_report_envelopes(file); });
  if (problems.has_errors()) throw BadInput(std::move(problems));
  note_what_is_missing(run);
  return run;
}

}  // namespace talus::io
