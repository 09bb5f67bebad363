#include "talus/calibration/validation_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "talus/files/output_file.hpp"

namespace talus::validation {

namespace {

void put(const std::filesystem::path& path, const std::string& text) {
  OutputFile file(path);
  file.write(text);
  file.commit();
}

RunRow row_of(const std::string& model, const std::string& site, const PredictedRun& run) {
  const ObservedRun& seen = run.observed;
  return {.model = model,
          .site = site,
          .run = seen.name,
          .release_x = seen.release.x(),
          .release_y = seen.release.y(),
          .stop_x = seen.stop.x(),
          .stop_y = seen.stop.y(),
          .runout = seen.runout(),
          .mean = run.mean,
          .p05 = run.p05,
          .p25 = run.p25,
          .median = run.median,
          .p75 = run.p75,
          .p95 = run.p95,
          .share_below = run.share_below};
}

}  // namespace

std::vector<ResultRow> rows_of(std::span<const ModelResult> models) {
  std::vector<ResultRow> rows;
  for (const ModelResult& model : models) {
    for (const SitePrediction& site : model.sites) {
      rows.push_back({.model = model.model,
                      .predicted = site.site,
                      .from = site.from,
                      .runs = site.runs.size(),
                      .in_50 = site.in_50.count,
                      .in_90 = site.in_90.count,
                      .observed_mean = site.observed.mean,
                      .observed_std_dev = site.observed.std_dev,
                      .mean = site.predicted.mean,
                      .mean_p05 = site.mean_90.low,
                      .mean_p95 = site.mean_90.high,
                      .std_dev = site.predicted.std_dev,
                      .std_dev_p05 = site.std_dev_90.low,
                      .std_dev_p95 = site.std_dev_90.high,
                      .in_50_least = site.in_50.expected.low,
                      .in_50_most = site.in_50.expected.high,
                      .in_90_least = site.in_90.expected.low,
                      .in_90_most = site.in_90.expected.high,
                      .crps = site.posterior.runout,
                      .crps_prior = site.prior.runout,
                      .crps_constant = site.constant.runout,
                      .place = site.posterior.place,
                      .place_prior = site.prior.place,
                      .place_constant = site.constant.place,
                      .rmse = site.rmse,
                      .rmse_constant = site.rmse_constant,
                      .mae = site.mae,
                      .mae_constant = site.mae_constant,
                      .misfit = site.misfit,
                      .effective_sets = site.effective_sets});
    }
  }
  return rows;
}

std::vector<GroupRow> group_rows_of(std::span<const ModelResult> models) {
  struct Sums {
    double runs = 0, observed = 0, predicted = 0, squares = 0, squares_of_constant = 0;
  };
  std::map<std::pair<std::string, std::size_t>, Sums> groups;
  for (std::size_t m = 0; m < models.size(); ++m) {
    for (const SitePrediction& site : models[m].sites) {
      double constant = 0;
      for (const ObservedRun& other : site.learned_from)
        constant += other.runout() / static_cast<double>(site.learned_from.size());
      for (const PredictedRun& run : site.runs) {
        if (run.observed.group.empty()) continue;
        Sums& sums = groups[{run.observed.group, m}];
        const double runout = run.observed.runout();
        sums.runs += 1;
        sums.observed += runout;
        sums.predicted += run.mean;
        sums.squares += (run.mean - runout) * (run.mean - runout);
        sums.squares_of_constant += (constant - runout) * (constant - runout);
      }
    }
  }
  std::vector<GroupRow> rows;
  for (const auto& [key, sums] : groups) {
    rows.push_back({.model = models[key.second].model,
                    .group = key.first,
                    .runs = static_cast<std::uint64_t>(sums.runs),
                    .observed_mean = sums.observed / sums.runs,
                    .mean = sums.predicted / sums.runs,
                    .rmse = std::sqrt(sums.squares / sums.runs),
                    .rmse_constant = std::sqrt(sums.squares_of_constant / sums.runs)});
  }
  return rows;
}

namespace {

/// What the rows say in short, so that the page states no number that they do not have. Expects one row or more.
std::string findings(std::span<const ResultRow> rows) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double farthest = 0, min_spread = infinity, max_spread = -infinity, min_score = infinity, max_score = -infinity;
  std::size_t runouts = 0, places = 0, halves = 0, bands = 0;
  for (const ResultRow& row : rows) {
    farthest = std::max(farthest, std::abs(row.mean - row.observed_mean));
    const double spread = row.std_dev - row.observed_std_dev, score = row.crps / row.crps_prior;
    min_spread = std::min(min_spread, spread);
    max_spread = std::max(max_spread, spread);
    min_score = std::min(min_score, score);
    max_score = std::max(max_score, score);
    const auto is_within = [](auto count, double least, double most) {
      return static_cast<double>(count) >= least && static_cast<double>(count) <= most;
    };
    runouts += row.crps < row.crps_constant ? 1U : 0U;
    places += row.place < row.place_constant ? 1U : 0U;
    halves += is_within(row.in_50, row.in_50_least, row.in_50_most) ? 1U : 0U;
    bands += is_within(row.in_90, row.in_90_least, row.in_90_most) ? 1U : 0U;
  }
  return fmt::format(
      "In these {} predictions\n\n"
      "- mean runouts are off by up to {:.1f} m, and predicted spreads less observed ones are {:+.1f} to {:+.1f} m;\n"
      "- the score of the runout is {:.0f} to {:.0f} % of the prior's; it is better than that of a constant in {}, and "
      "that of the place in {};\n"
      "- as many runs as expected lie within the central 50 % in {}, and within 90 % in {}.\n",
      rows.size(), farthest, min_spread, max_spread, 100 * min_score, 100 * max_score, runouts, places, halves, bands);
}

}  // namespace

std::string markdown(const Experiment& experiment, std::span<const ResultRow> rows, std::span<const GroupRow> groups) {
  std::string text =
      "| model | predicted | observed runout, m | predicted, m | 90 % of its mean | 90 % of its spread | in 50 % | in "
      "90 "
      "% |\n| --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (const ResultRow& row : rows) {
    text += fmt::format(
        "| {} | {} | {:.1f} ± {:.1f} | {:.1f} ± {:.1f} | {:.1f} to {:.1f} | {:.1f} to {:.1f} | {} of {} ({:g} to {:g}) "
        "| {} of {} ({:g} to {:g}) |\n",
        row.model, row.predicted, row.observed_mean, row.observed_std_dev, row.mean, row.std_dev, row.mean_p05,
        row.mean_p95, row.std_dev_p05, row.std_dev_p95, row.in_50, row.runs, row.in_50_least, row.in_50_most, row.in_90,
        row.runs, row.in_90_least, row.in_90_most);
  }
  text +=
      "\n| model | predicted | score of the runout, m: posterior, prior, constant | score of the place, m | error of a "
      "run, m: root mean square, constant | mean magnitude, constant |\n| --- | --- | --- | --- | --- | --- |\n";
  for (const ResultRow& row : rows) {
    text +=
        fmt::format("| {} | {} | {:.1f}, {:.1f}, {:.1f} | {:.1f}, {:.1f}, {:.1f} | {:.1f}, {:.1f} | {:.1f}, {:.1f} |\n",
                    row.model, row.predicted, row.crps, row.crps_prior, row.crps_constant, row.place, row.place_prior,
                    row.place_constant, row.rmse, row.rmse_constant, row.mae, row.mae_constant);
  }
  if (!groups.empty()) {
    text +=
        "\n| group | model | runs | observed mean runout, m | predicted, m | error of a run, m: root mean square, "
        "constant |\n| --- | --- | --- | --- | --- | --- |\n";
    for (const GroupRow& row : groups) {
      text += fmt::format("| {} | {} | {} | {:.1f} | {:.1f} | {:.1f}, {:.1f} |\n", row.group, row.model, row.runs,
                          row.observed_mean, row.mean, row.rmse, row.rmse_constant);
    }
  }
  if (!rows.empty()) text += "\n" + findings(rows);
  if (experiment.published.empty()) return text;
  text +=
      "\n| other programs | observed, m | predicted, m | difference, m | mean error of a run, m | source |\n| --- | "
      "--- "
      "| --- | --- | --- | --- |\n";
  for (const PublishedResult& other : experiment.published) {
    text += fmt::format("| {} | {:.1f} | {:.1f} | {:+.1f} | {} | {} |\n", other.name, other.observed_mean_m,
                        other.predicted_mean_m, other.predicted_mean_m - other.observed_mean_m,
                        other.mean_abs_error_m ? fmt::format("{:.1f}", *other.mean_abs_error_m) : "", other.source);
  }
  return text;
}

void write_results(const std::filesystem::path& folder, const Experiment& experiment,
                   std::span<const ModelResult> models) {
  std::string results = header_of<ResultRow>(), runs = header_of<RunRow>();
  for (const ResultRow& row : rows_of(models)) append_row(results, row);
  for (const ModelResult& model : models) {
    for (const SitePrediction& site : model.sites) {
      for (const PredictedRun& run : site.runs) append_row(runs, row_of(model.model, site.site, run));
    }
  }
  put(folder / ResultRow::file_name, results);
  if (const std::vector<GroupRow> rows = group_rows_of(models); !rows.empty()) {
    std::string groups = header_of<GroupRow>();
    for (const GroupRow& row : rows) append_row(groups, row);
    put(folder / GroupRow::file_name, groups);
  }
  put(folder / RunRow::file_name, runs);
  put(folder / "report.html", page_of(experiment, models));
}

}  // namespace talus::validation
