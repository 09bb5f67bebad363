#include "talus/report/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "talus/core/problems.hpp"
#include "talus/core/stop.hpp"
#include "talus/files/base64.hpp"
#include "talus/files/output_file.hpp"
#include "talus/report/html_page.hpp"
#include "talus/report/observed_comparison.hpp"
#include "talus/report/page/assets.hpp"
#include "talus/report/report_histograms.hpp"
#include "talus/report/uncertainty_json.hpp"

namespace talus {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_loss_points = 3'000;  // dots of single impacts; more would overlap

// Tenths of a millimetre, of a millimetre per second and of a joule are finer than any screen or printer, and halve the
// size of the page.
double drawn(double value) {
  const double rounded = std::round(value * 1e4) / 1e4;
  return std::isfinite(rounded) ? rounded : value;
}
double drawn_J(double value) { return std::round(value * 10) / 10; }

Json endpoints_of(const RunFolder& run) {
  auto rows = Json::array();
  const bool has_blocks = std::ranges::any_of(run.endpoints.items, &EndpointRow::is_block);
  for (const EndpointRow& end : run.endpoints.items) {
    Json& row = rows.emplace_back(Json{end.rock, end.seeder, drawn(end.position_m[0]), drawn(end.position_m[1]),
                                       drawn(end.position_m[2]), drawn(end.runout_xy_m), drawn(end.runout_total_m),
                                       drawn(end.time_s), name(end.end_reason), drawn_J(end.max_ke_J),
                                       drawn(end.max_bounce_m)});
    if (!has_blocks) continue;
    for (const std::optional<double>& value : {end.a_m, end.b_m, end.c_m, end.short_axis_share})
      row.push_back(value ? Json(drawn(*value)) : Json());
  }
  Json columns = {"rock",         "seeder", "x",          "y",      "z",         "runout_xy",
                  "runout_total", "time",   "end_reason", "max_ke", "max_bounce"};
  if (has_blocks) {
    for (const char* column : {"a", "b", "c", "share"}) columns.push_back(column);
  }
  return {{"has_file", run.endpoints.has_file},
          {"total", run.endpoints.total},
          {"columns", std::move(columns)},
          {"rows", std::move(rows)}};
}

Json paths_of(const RunFolder& run) {
  auto rocks = Json::array();
  for (const Path& path : run.paths.items) {
    stop_point();
    auto rows = Json::array();
    for (const PathEventRow& row : path.rows) {
      const auto& [x, y, z] = row.position_m;
      const auto& [vx, vy, vz] = row.velocity_m_s;
      rows.push_back({name(row.state), drawn(row.time_s), drawn(x), drawn(y), drawn(z), drawn(vx), drawn(vy), drawn(vz),
                      drawn_J(row.ke_translational_J), drawn_J(row.ke_rotational_J), drawn_J(row.pe_J)});
    }
    rocks.push_back({{"rock", path.rock}, {"rows", std::move(rows)}});
  }
  return {{"has_file", run.paths.has_file},
          {"total", run.paths.total},
          {"columns", {"state", "time", "x", "y", "z", "vx", "vy", "vz", "ke_translational", "ke_rotational", "pe"}},
          {"rocks", std::move(rocks)}};
}

Json hits_of(const RunFolder& run) {
  auto rows = Json::array();
  for (const HitRow& hit : run.hits.items) {
    rows.push_back({hit.barrier, hit.rock, drawn(hit.time_s), drawn(hit.position_m[0]), drawn(hit.position_m[1]),
                    drawn(hit.position_m[2]), drawn(hit.impact_height_m), drawn(hit.angle_deg),
                    drawn_J(hit.ke_translational_J), drawn_J(hit.ke_total_J), name(hit.outcome)});
  }
  return {{"has_file", run.hits.has_file},
          {"total", run.hits.total},
          {"columns",
           {"barrier", "rock", "time", "x", "y", "z", "height", "angle", "ke_translational", "ke_total", "outcome"}},
          {"rows", std::move(rows)}};
}

// Energy lost at each impact on the ground of the paths shown: total energy on arrival minus total energy on leaving.
Json losses_of(const RunFolder& run) {
  struct Loss {
    std::uint64_t rock, impact;
    double x_m, travelled_m, lost_J, arrived_with_kinetic_J;
  };
  std::vector<Loss> losses;
  for (const Path& path : run.paths.items) {
    std::uint64_t impact = 0;
    double travelled_m = 0;  // on plan
    for (std::size_t i = 0; i + 1 < path.rows.size(); ++i) {
      const PathEventRow& row = path.rows[i];
      if (i > 0) {
        const auto& before = path.rows[i - 1].position_m;
        travelled_m += std::hypot(row.position_m[0] - before[0], row.position_m[1] - before[1]);
      }
      if (row.state != PathState::impact) continue;
      losses.push_back({path.rock, ++impact, row.position_m[0], travelled_m, row.total_J() - path.rows[i + 1].total_J(),
                        row.ke_translational_J + row.ke_rotational_J});
    }
  }
  const std::size_t step = losses.size() / most_loss_points + 1;
  auto rows = Json::array();
  for (std::size_t i = 0; i < losses.size(); i += step) {
    const Loss& loss = losses[i];
    rows.push_back({loss.rock, loss.impact, drawn(loss.x_m), drawn(loss.travelled_m), drawn_J(loss.lost_J),
                    drawn_J(loss.arrived_with_kinetic_J)});
  }
  auto by_number = Json::array();
  for (const ImpactLoss& loss : run.impact_losses) {
    by_number.push_back({by_number.size() + 1, loss.count, drawn_J(loss.sum_J / static_cast<double>(loss.count)),
                         drawn_J(loss.least_J), drawn_J(loss.most_J)});
  }
  return {{"of_shown_paths", losses.size()},
          {"columns", {"rock", "impact", "x", "travelled", "lost", "kinetic_before"}},
          {"rows", std::move(rows)},
          {"by_number_columns", {"impact", "rocks", "mean", "least", "most"}},
          {"by_number", std::move(by_number)}};
}

Json maps_of(const RunFolder& run) {
  auto maps = Json::array();
  for (const ReportMap& map : run.maps) {
    maps.push_back({{"name", map.name},
                    {"logarithmic", map.is_logarithmic},
                    {"least", map.range.least},
                    {"greatest", map.range.greatest},
                    {"limits", map.limits},
                    {"origin", map.origin},
                    {"cell", map.cell},
                    {"columns", map.columns},
                    {"rows", map.rows},
                    {"levels", base64(map.levels)}});
  }
  return maps;
}

// To six digits.
double in_short(double value) { return std::stod(fmt::format("{:.6g}", value)); }

Json envelopes_of(const RunFolder& run) {
  auto rows = Json::array();
  for (const ReportEnvelopes::Cell& cell : run.envelopes.cells) {
    auto row = Json::array({drawn(cell.from_x_m), drawn(cell.to_x_m)});
    for (const auto& value : cell.values) row.push_back(value ? Json(in_short(*value)) : Json());
    rows.push_back(std::move(row));
  }
  auto columns = Json::array({"from_x_m", "to_x_m"});
  for (const std::string& column : run.envelopes.columns) columns.push_back(column);
  return {{"cells_each", run.envelopes.cells_each}, {"columns", std::move(columns)}, {"rows", std::move(rows)}};
}

// Each step: rocks, value, and the ends of its interval.
Json convergence_of(const RunFolder& run) {
  auto figures = Json::array();
  const auto or_null = [](const std::optional<double>& value) { return value ? Json(in_short(*value)) : Json(); };
  for (const FigureConvergence& each : run.convergence.figures) {
    auto steps = Json::array();
    for (const ConvergenceStep& step : each.steps) {
      if (!step.estimate) continue;
      const Estimate& e = *step.estimate;
      steps.push_back({step.rocks, in_short(e.value), or_null(e.low), or_null(e.high)});
    }
    figures.push_back({{"line", each.line},
                       {"text", each.figure.text()},
                       {"unit", quantity_of(each.figure.of).unit},
                       {"steps", std::move(steps)},
                       {"rocks_needed", each.rocks_needed ? Json(*each.rocks_needed) : Json()}});
  }
  return {
      {"confidence", Convergence::confidence}, {"tolerance", Convergence::tolerance}, {"figures", std::move(figures)}};
}

// Red, green and blue of the classes of maps.
Json map_colours() {
  auto colours = Json::array();
  for (const MapClass& each : map_classes({})) colours.push_back(each.colour);
  return colours;
}

Json data_of(const RunFolder& run, const RunSummary& summary) {
  stop_point();
  const auto whole = std::filesystem::absolute(run.folder).lexically_normal();
  const auto last = whole.has_filename() ? whole.filename() : whole.parent_path().filename();
  return {{"folder", last.string()},
          {"date", run.date},
          {"summary", json_of(summary)},
          {"endpoints", endpoints_of(run)},
          {"paths", paths_of(run)},
          {"hits", hits_of(run)},
          {"losses", losses_of(run)},
          {"maps", maps_of(run)},
          {"envelopes", envelopes_of(run)},
          {"convergence", convergence_of(run)},
          {"uncertainty", uncertainty_json(run.uncertainty)},
          {"notes", run.notes}};
}

void apply(const ReportChanges& changes, RunSummary& summary) {
  if (changes.title_block.empty()) return;
  Json project = *summary.project;
  project["report"].update(changes.title_block);
  summary.project = std::make_shared<const Json>(std::move(project));
  if (changes.title_block.contains("logo")) summary.inputs.logo = changes.logo;
}

std::string title_of(std::span<const RunFolder> runs) {
  std::string title;
  for (const RunFolder& run : runs) {
    title += (title.empty() ? "" : " and ") + run.summary.name;
  }
  return title;
}

}  // namespace

std::string report_page(std::span<const RunFolder> runs, std::span<const Json> observed) {
  Json data{{"version", TALUS_VERSION}, {"map_colours", map_colours()}, {"runs", Json::array()}};
  std::vector<RunSummary> summaries;
  for (const RunFolder& run : runs) summaries.push_back(run.summary);
  if (summaries.size() == 2) give_common_bins(summaries[0], summaries[1]);
  for (std::size_t k = 0; k < runs.size(); ++k) {
    Json& run = data["runs"].emplace_back(data_of(runs[k], summaries[k]));
    if (!observed.empty()) run["observed"] = observed[k];
  }
  return html_page(title_of(runs), data, assets::report_script);
}

ReportNotes write_report(std::span<const std::filesystem::path> run_folders, const std::filesystem::path& html,
                         const char* summary, const std::filesystem::path& observed, const ReportChanges& changes) {
  if (run_folders.empty() || run_folders.size() > 2) {
    throw BadInput(Problem{.file = "",
                           .where = "report",
                           .what = "given " + std::to_string(run_folders.size()) + " run folders",
                           .why = "a report shows one run, or two for comparison",
                           .hint = ""});
  }
  std::vector<RunFolder> runs;
  Problems problems;
  for (const std::filesystem::path& folder : run_folders) {
    try {
      runs.push_back(read_run_folder(folder, {}, summary));
    } catch (const BadInput& bad) {
      problems.append(bad.problems());
    }
  }
  if (problems.has_errors()) throw BadInput(std::move(problems));
  for (RunFolder& run : runs) apply(changes, run.summary);
  ReportNotes notes;
  std::vector<Json> comparisons;
  if (!observed.empty()) {
    for (RunFolder& run : runs) {
      Problems doubts;
      comparisons.push_back(observed_json(read_observed_stops(observed, run.summary, doubts), run));
      for (std::string& line : comparison_lines(comparisons.back()))
        notes.comparisons.push_back(runs.size() > 1 ? run.summary.name + ", " + line : std::move(line));
      for (const Problem& doubt : doubts.list()) run.notes.push_back(doubt.text());
      if (notes.doubts.list().empty()) notes.doubts = std::move(doubts);  // the same for two runs of one terrain
    }
  }
  const std::string page = report_page(runs, comparisons);
  OutputFile file(place_of_file(html));
  file.write(page);
  file.commit();
  return notes;
}

}  // namespace talus
