#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "talus/calibration/validation_results.hpp"
#include "talus/report/study_page.hpp"

namespace talus::validation {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t dots_of_plan = 1500;  // predicted stops

/// To a hundredth of a metre, or of a percent of a share: finer than a page shows.
double drawn(double value) { return std::round(value * 100) / 100; }
double drawn_share(double share) { return std::round(share * 1e4) / 1e4; }

Json place(const Vec2& at) { return {drawn(at.x()), drawn(at.y())}; }

/// A row of a table, by the names of its columns.
template <TableRow Row>
Json row_json(const Row& row) {
  Json json;
  for_columns<Row>([&](const auto& column) { json[std::string(column.name)] = column.in(row); });
  return json;
}

/// What was predicted for each run, in the order of the observed runouts.
Json runs_json(const SitePrediction& site) {
  std::vector<const PredictedRun*> runs;
  for (const PredictedRun& run : site.runs) runs.push_back(&run);
  std::ranges::stable_sort(runs, {}, [](const PredictedRun* run) { return run->observed.runout(); });
  Json rows = Json::array();
  for (const PredictedRun* run : runs) {
    rows.push_back({{"name", run->observed.name},
                    {"observed", drawn(run->observed.runout())},
                    {"p05", drawn(run->p05)},
                    {"p25", drawn(run->p25)},
                    {"p75", drawn(run->p75)},
                    {"p95", drawn(run->p95)}});
  }
  return rows;
}

double share_below(const std::vector<double>& ascending, double value) {
  const auto below = std::ranges::upper_bound(ascending, value) - ascending.begin();
  return static_cast<double>(below) / static_cast<double>(ascending.size());
}

/// The distribution of runouts, and the band within which 90 % of those of the replicas lie.
Json distribution_json(const SitePrediction& site) {
  std::vector<double> observed;
  for (const PredictedRun& run : site.runs) observed.push_back(drawn(run.observed.runout()));
  std::ranges::sort(observed);
  const std::size_t replicas = site.runs.front().stops.size();
  double most = observed.back();
  std::vector<std::vector<double>> of_replica(replicas);
  for (std::size_t r = 0; r < replicas; ++r) {
    for (const PredictedRun& run : site.runs) of_replica[r].push_back((run.stops[r] - run.observed.release).norm());
    std::ranges::sort(of_replica[r]);
  }
  for (const PredictedRun& run : site.runs) most = std::max(most, run.p95);
  constexpr int places = 80;
  Json at = Json::array(), low = Json::array(), median = Json::array(), high = Json::array();
  for (int k = 0; k <= places; ++k) {
    const double here = most * 1.05 * k / places;
    std::vector<double> shares;
    for (const std::vector<double>& runouts : of_replica) shares.push_back(share_below(runouts, here));
    std::ranges::sort(shares);
    const auto q = [&](double part) {
      return drawn_share(shares[static_cast<std::size_t>(part * static_cast<double>(replicas - 1))]);
    };
    at.push_back(drawn(here));
    low.push_back(q(0.05));
    median.push_back(q(0.5));
    high.push_back(q(0.95));
  }
  return {{"observed", observed},
          {"at", std::move(at)},
          {"posterior", {{"low", std::move(low)}, {"median", std::move(median)}, {"high", std::move(high)}}}};
}

/// Releases and stops on plan; of the predicted stops some.
Json plan_json(const SitePrediction& site) {
  Json releases = Json::array(), observed = Json::array(), predicted = Json::array();
  for (const PredictedRun& run : site.runs) {
    releases.push_back(place(run.observed.release));
    observed.push_back(place(run.observed.stop));
  }
  const std::size_t replicas = site.runs.front().stops.size(), all = replicas * site.runs.size();
  for (std::size_t k = 0; k < all; k += std::max<std::size_t>(all / dots_of_plan, 1))
    predicted.push_back(place(site.runs[k % site.runs.size()].stops[k / site.runs.size()]));
  return {{"releases", std::move(releases)}, {"observed", std::move(observed)}, {"predicted", std::move(predicted)}};
}

Json prediction_json(const std::string& model, const SitePrediction& site) {
  double mean = 0;
  for (const ObservedRun& run : site.learned_from) mean += run.runout() / static_cast<double>(site.learned_from.size());
  Json parameters = Json::array(), warnings = Json::array();
  for (const FoundParameter& each : site.parameters) {
    parameters.push_back({{"name", each.name},
                          {"unit", each.unit},
                          {"prior", {{"p05", each.prior_p05}, {"p95", each.prior_p95}}},
                          {"posterior", {{"p05", each.p05}, {"p50", each.median}, {"p95", each.p95}}}});
  }
  for (Problem problem : site.warnings.list()) {
    problem.file = std::filesystem::path(problem.file).filename().string();
    warnings.push_back(problem.text());
  }
  return {{"model", model},
          {"site", site.site},
          {"from", site.from},
          {"mean_of_the_others", drawn(mean)},
          {"runs", runs_json(site)},
          {"distribution", distribution_json(site)},
          {"plan", plan_json(site)},
          {"parameters", std::move(parameters)},
          {"warnings", std::move(warnings)}};
}

}  // namespace

std::string page_of(const Experiment& experiment, std::span<const ModelResult> models) {
  Json published = Json::array(), results = Json::array(), groups = Json::array(), predictions = Json::array();
  for (const PublishedResult& other : experiment.published) {
    published.push_back({{"name", other.name},
                         {"observed_mean_m", other.observed_mean_m},
                         {"predicted_mean_m", other.predicted_mean_m},
                         {"mean_abs_error_m", other.mean_abs_error_m ? Json(*other.mean_abs_error_m) : Json()},
                         {"source", other.source}});
  }
  for (const ResultRow& row : rows_of(models)) results.push_back(row_json(row));
  for (const GroupRow& row : group_rows_of(models)) groups.push_back(row_json(row));
  for (const ModelResult& model : models) {
    for (const SitePrediction& site : model.sites) predictions.push_back(prediction_json(model.model, site));
  }
  return validation_page(experiment.title, {{"talus", TALUS_VERSION},
                                            {"title", experiment.title},
                                            {"summary", experiment.summary},
                                            {"limits", experiment.limits},
                                            {"results", std::move(results)},
                                            {"groups", std::move(groups)},
                                            {"published", std::move(published)},
                                            {"predictions", std::move(predictions)},
                                            {"split", experiment.split},
                                            {"sought", experiment.sought},
                                            {"not_sought", experiment.not_sought},
                                            {"citations", experiment.citations},
                                            {"licence", experiment.licence}});
}

}  // namespace talus::validation
