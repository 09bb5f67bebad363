#pragma once
// The results of an experiment: tables, the page, and what is printed.

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "talus/calibration/experiment.hpp"
#include "talus/calibration/prediction.hpp"
#include "talus/files/csv_table.hpp"

namespace talus::validation {

/// The predictions of one model of an experiment.
struct ModelResult {
  std::string model;
  std::vector<SitePrediction> sites;
};

/// A row of results.csv: a site predicted from the others. Runouts are on plan, from the release of each run.
struct ResultRow {
  static constexpr const char* file_name = "results.csv";

  std::string model{}, predicted{}, from{};
  std::uint64_t runs = 0, in_50 = 0, in_90 = 0;
  double observed_mean = 0, observed_std_dev = 0;
  double mean = 0, mean_p05 = 0, mean_p95 = 0, std_dev = 0, std_dev_p05 = 0, std_dev_p95 = 0;
  double in_50_least = 0, in_50_most = 0, in_90_least = 0, in_90_most = 0;
  double crps = 0, crps_prior = 0, crps_constant = 0, place = 0, place_prior = 0, place_constant = 0;
  double rmse = 0, rmse_constant = 0, mae = 0, mae_constant = 0, misfit = 1, effective_sets = 0;

  static constexpr auto columns() {
    using R = ResultRow;
    return std::tuple(
        word("model", "name of the model", &R::model), word("predicted", "the site that was predicted", &R::predicted),
        word("from", "the sites on which the parameters were calibrated", &R::from),
        key("runs", "number of runs predicted", &R::runs),
        quantity("observed_mean_m", "m", "mean observed runout", &R::observed_mean),
        quantity("observed_std_dev_m", "m", "standard deviation of observed runouts", &R::observed_std_dev),
        quantity("mean_m", "m", "mean predicted runout", &R::mean),
        quantity("mean_p05_m", "m", "90 % of repetitions of all runs have a mean above it ...", &R::mean_p05),
        quantity("mean_p95_m", "m", "... and below it", &R::mean_p95),
        quantity("std_dev_m", "m", "standard deviation of predicted runouts", &R::std_dev),
        quantity("std_dev_p05_m", "m", "the same range of the standard deviation of a repetition", &R::std_dev_p05),
        quantity("std_dev_p95_m", "m", "", &R::std_dev_p95),
        key("in_50", "runs within the central 50 % of their own prediction", &R::in_50),
        quantity("in_50_least", "", "central 95 % of that number if the claim holds", &R::in_50_least),
        quantity("in_50_most", "", "", &R::in_50_most), key("in_90", "runs within the central 90 %", &R::in_90),
        quantity("in_90_least", "", "", &R::in_90_least), quantity("in_90_most", "", "", &R::in_90_most),
        quantity("crps_m", "m", "mean continuous ranked probability score of the runout", &R::crps),
        quantity("crps_prior_m", "m", "the same with the prior", &R::crps_prior),
        quantity("crps_constant_m", "m", "and with the runouts of the other sites", &R::crps_constant),
        quantity("place_m", "m", "mean energy score of the stop on plan", &R::place),
        quantity("place_prior_m", "m", "the same with the prior", &R::place_prior),
        quantity("place_constant_m", "m", "and with the stops of the other sites", &R::place_constant),
        quantity("rmse_m", "m", "root mean square error of each run's mean predicted runout", &R::rmse),
        quantity("rmse_constant_m", "m", "of the mean runout of the other sites", &R::rmse_constant),
        quantity("mae_m", "m", "mean magnitude of the error of each run's median predicted runout", &R::mae),
        quantity("mae_constant_m", "m", "of the median runout of the other sites", &R::mae_constant),
        quantity("misfit", "", "factor by which the likelihood was widened", &R::misfit),
        quantity("effective_sets", "", "independent sets that would be as accurate as the posterior",
                 &R::effective_sets));
  }
};

/// A row of runs.csv.
struct RunRow {
  static constexpr const char* file_name = "runs.csv";

  std::string model{}, site{}, run{};
  double release_x = 0, release_y = 0, stop_x = 0, stop_y = 0, runout = 0;
  double mean = 0, p05 = 0, p25 = 0, median = 0, p75 = 0, p95 = 0, share_below = 0;

  static constexpr auto columns() {
    using R = RunRow;
    return std::tuple(
        word("model", "name of the model", &R::model), word("site", "the predicted site", &R::site),
        word("run", "name of the run", &R::run), quantity("release_x_m", "m", "x of its release", &R::release_x),
        quantity("release_y_m", "m", "y", &R::release_y),
        quantity("stop_x_m", "m", "x of its observed stop", &R::stop_x), quantity("stop_y_m", "m", "y", &R::stop_y),
        quantity("runout_m", "m", "observed runout on plan", &R::runout),
        quantity("mean_m", "m", "mean predicted runout of this run", &R::mean),
        quantity("p05_m", "m", "5 % of its predicted runouts are below", &R::p05),
        quantity("p25_m", "m", "25 %", &R::p25), quantity("median_m", "m", "50 %", &R::median),
        quantity("p75_m", "m", "75 %", &R::p75), quantity("p95_m", "m", "95 %", &R::p95),
        quantity("share_below", "", "share of predicted runouts below the observed one", &R::share_below));
  }
};

/// A row of groups.csv: the runs of a group, such as those of one boulder, of all sites together.
struct GroupRow {
  static constexpr const char* file_name = "groups.csv";

  std::string model{}, group{};
  std::uint64_t runs = 0;
  double observed_mean = 0, mean = 0, rmse = 0, rmse_constant = 0;

  static constexpr auto columns() {
    using R = GroupRow;
    return std::tuple(word("model", "name of the model", &R::model),
                      word("group", "the group, as the stops name it", &R::group),
                      key("runs", "number of its runs", &R::runs),
                      quantity("observed_mean_m", "m", "mean observed runout", &R::observed_mean),
                      quantity("mean_m", "m", "mean predicted runout", &R::mean),
                      quantity("rmse_m", "m", "root mean square error of each run's mean predicted runout", &R::rmse),
                      quantity("rmse_constant_m", "m", "of the mean runout of the other sites, whatever the group",
                               &R::rmse_constant));
  }
};

[[nodiscard]] std::vector<ResultRow> rows_of(std::span<const ModelResult> models);
/// Group by group in alphabetical order, and in each model by model; none if runs have no groups.
[[nodiscard]] std::vector<GroupRow> group_rows_of(std::span<const ModelResult> models);

/// The results of all rows and the published ones as Markdown tables, for docs/validation.md.
[[nodiscard]] std::string markdown(const Experiment& experiment, std::span<const ResultRow> rows,
                                   std::span<const GroupRow> groups);

/// The page as text: one file that opens without a network.
[[nodiscard]] std::string page_of(const Experiment& experiment, std::span<const ModelResult> models);

/// Writes results.csv, runs.csv, report.html and, if runs have groups, groups.csv, each complete under its name.
void write_results(const std::filesystem::path& folder, const Experiment& experiment,
                   std::span<const ModelResult> models);

}  // namespace talus::validation
