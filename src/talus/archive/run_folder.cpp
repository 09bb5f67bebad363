#include "talus/archive/run_folder.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <optional>

#include "talus/archive/envelope_table.hpp"
#include "talus/archive/figure_counts.hpp"
#include "talus/archive/path_reader.hpp"
#include "talus/archive/spread_sample.hpp"
#include "talus/core/problems.hpp"

namespace talus {
namespace {

constexpr std::size_t most_impacts = 100;  // whose losses are kept by number

[[noreturn]] void refuse(const std::filesystem::path& file, std::string where, std::string what, std::string why,
                         std::string hint = {}, int line = 0) {
  throw BadInput(Problem{.file = file.string(),
                         .line = line,
                         .where = std::move(where),
                         .what = std::move(what),
                         .why = std::move(why),
                         .hint = std::move(hint)});
}

constexpr std::size_t most_barriers = 100;  // shown one by one in a report

constexpr auto name_a_run = "Name a folder that `talus run` has written";

std::string date_of(const std::filesystem::path& file) {
  const auto written = std::chrono::file_clock::to_sys(std::filesystem::last_write_time(file));
  const auto seconds = std::chrono::time_point_cast<std::chrono::seconds>(written);
  return fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(std::chrono::system_clock::to_time_t(seconds)));
}

// ---- the summary

// The project may contain millions of triangles; only their number is useful on paper.
void shorten_long_lists(JsonValue& node) {
  constexpr std::size_t most = 400;
  if (node.is_array() && node.size() > most) {
    node = fmt::format("{} entries", node.size());
  } else if (node.is_structured()) {
    for (auto& child : node) shorten_long_lists(child);
  }
}

/// Selects the barriers that a report shows: those with the most hits.
class BarriersWithMostHits {
 public:
  void add(BarrierSummary barrier) {
    kept_.push_back({total_++, std::move(barrier)});
    if (kept_.size() == 2 * most_barriers) drop_others();
  }
  [[nodiscard]] std::size_t total() const { return total_; }
  /// Returns them in the order of the summary.
  [[nodiscard]] std::vector<BarrierSummary> take() {
    drop_others();
    std::ranges::sort(kept_, {}, &Numbered::number);
    std::vector<BarrierSummary> barriers;
    for (Numbered& kept : kept_) barriers.push_back(std::move(kept.barrier));
    return barriers;
  }

 private:
  struct Numbered {
    std::size_t number;  // zero-based place in the summary
    BarrierSummary barrier;
  };

  void drop_others() {
    if (kept_.size() <= most_barriers) return;
    std::ranges::stable_sort(kept_, std::ranges::greater(), [](const Numbered& kept) { return kept.barrier.hits; });
    kept_.resize(most_barriers);
  }

  std::vector<Numbered> kept_;
  std::size_t total_ = 0;
};

void read_summary(const std::filesystem::path& file, RunFolder& run) {
  BarriersWithMostHits barriers;
  run.summary = read_run_summary(file, [&](BarrierSummary barrier) { barriers.add(std::move(barrier)); });
  run.summary.barriers = barriers.take();
  JsonValue project = *run.summary.project;
  shorten_long_lists(project);
  run.summary.project = std::make_shared<const JsonValue>(std::move(project));
  run.date = date_of(file);
  if (barriers.total() > most_barriers) {
    run.notes.push_back(
        fmt::format("Of {} barriers and collectors the {} with the most hits are shown one by one; "
                    "summary.json has all of them.",
                    barriers.total(), most_barriers));
  }
}

// ---- the tables

Kept<EndpointRow> read_endpoints(const std::filesystem::path& file, std::size_t limit, FigureCounts& figures) {
  using R = EndpointRow;
  TableReader<R> row(file);
  SpreadSample<R> sample(limit, std::numeric_limits<std::size_t>::max());
  Kept<R> kept{.has_file = true};
  for (; row.next(); ++kept.total) {
    const std::uint64_t rock = row.get<&R::rock>();
    figures.add(row);
    if (!sample.wants(rock)) continue;
    sample.add(rock, 1,
               row.part<&R::rock, &R::seeder, &R::end_reason, &R::position_m, &R::runout_xy_m, &R::runout_total_m,
                        &R::time_s, &R::max_ke_J, &R::max_bounce_m, &R::a_m, &R::b_m, &R::c_m, &R::short_axis_share>());
  }
  kept.items = sample.take();
  return kept;
}

// Reads the rows of paths.csv, rock by rock.
class PathTable {
 public:
  explicit PathTable(const Limits& limits) : sample_(limits.paths, limits.path_rows) {}

  void add(const TableReader<PathEventRow>& row) {
    using R = PathEventRow;
    const std::uint64_t rock = row.get<&R::rock>();
    const PathState state = row.get<&R::state>();
    if (!in_path_) {
      begin(rock);
    } else if (rock != path_.rock) {
      refuse_other_rock(row, rock, path_.rock);
    }
    const double energy_J = row.part<&R::ke_translational_J, &R::ke_rotational_J, &R::pe_J>().total_J();
    if (arrived_with_J_) count_loss(*arrived_with_J_ - energy_J);
    arrived_with_J_.reset();
    if (state == PathState::impact) arrived_with_J_ = energy_J;
    if (wanted_) path_.rows.push_back(path_row(row));
    if (state == PathState::ended) end();
  }

  /// The rock whose path has not ended after the last row, if there is one.
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
  TableReader<PathEventRow> row(file);
  PathTable table(limits);
  while (row.next()) table.add(row);
  if (const auto rock = table.unfinished()) refuse_unfinished_path(file, *rock);
  run.paths = table.take();
  run.impact_losses = table.losses();
}

Kept<HitRow> read_hits(const std::filesystem::path& file, std::size_t limit, FigureCounts& figures) {
  using R = HitRow;
  TableReader<R> row(file);
  SpreadSample<R> sample(std::numeric_limits<std::size_t>::max(), limit);
  Kept<R> kept{.has_file = true};
  for (; row.next(); ++kept.total) {
    const std::uint64_t rock = row.get<&R::rock>();
    figures.add(row);
    if (!sample.wants(rock)) continue;
    sample.add(rock, 1,
               row.part<&R::barrier, &R::outcome, &R::rock, &R::time_s, &R::position_m, &R::impact_height_m,
                        &R::angle_deg, &R::ke_translational_J, &R::ke_total_J>());
  }
  kept.items = sample.take();
  return kept;
}

void check_count(const RunFolder& run, const std::filesystem::path& endpoints) {
  const std::uint64_t counted = run.summary.rocks.with_endpoint;
  if (counted == run.endpoints.total) return;
  refuse(endpoints, "", fmt::format("has {} {}", run.endpoints.total, run.endpoints.total == 1 ? "rock" : "rocks"),
         fmt::format("summary.json next to it counts {}", counted),
         "The files are of different runs, or one was cut short; run the project again");
}

void note_what_is_missing(RunFolder& run) {
  const auto note = [&](bool has_file, const char* text) {
    if (!has_file) run.notes.emplace_back(text);
  };
  note(run.endpoints.has_file, "There is no endpoints.csv, so no single end points are shown.");
  note(run.paths.has_file, "There is no paths.csv, so no paths, energies along a path or losses at impacts are shown.");
  note(run.hits.has_file || run.summary.barriers.empty(),
       "There is no barriers.csv, so no single hits on barriers are shown.");
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
  bool has_summary = false;
  attempt(summary, false, [&](const auto& file) {
    read_summary(file, run);
    has_summary = true;
  });
  FigureCounts figures = has_summary ? FigureCounts(run.summary) : FigureCounts();
  attempt(EndpointRow::file_name, true, [&](const auto& file) {
    run.endpoints = read_endpoints(file, limits.endpoints, figures);
    if (has_summary) check_count(run, file);
  });
  attempt(PathEventRow::file_name, true, [&](const auto& file) { read_paths(file, limits, run); });
  attempt(HitRow::file_name, true, [&](const auto& file) { run.hits = read_hits(file, limits.hits, figures); });
  attempt("maps", true, [&](const auto&) { run.maps = read_report_maps(folder); });
  attempt(EnvelopeRow::file_name, true, [&](const auto& file) { run.envelopes = read_report_envelopes(file); });
  if (problems.has_errors()) throw BadInput(std::move(problems));
  run.convergence = figures.convergence();
  run.uncertainty = figures.uncertainty();
  note_what_is_missing(run);
  return run;
}

}  // namespace talus
