#pragma once
// A site predicted from the other sites of a study, run by run: the parameters are calibrated on the others alone, and
// each run is simulated from its own recorded release with draws from their posterior.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "talus/calibration/calibrate.hpp"
#include "talus/calibration/study.hpp"
#include "talus/core/problems.hpp"
#include "talus/core/vec.hpp"

namespace talus::validation {

/// A run of the experiment. Places on plan, in the project's coordinates [m].
struct ObservedRun {
  std::string name;
  std::string group;  // of the column `group` of its stops; may be empty
  Vec2 release, stop;
  [[nodiscard]] double runout() const { return (stop - release).norm(); }
};

/// A run with what was predicted for it. Runouts are from its own release, on plan [m].
struct PredictedRun {
  ObservedRun observed;
  std::vector<Vec2> stops;                                          // predicted: one of each replica
  double mean = 0, p05 = 0, p25 = 0, median = 0, p75 = 0, p95 = 0;  // of the predicted runout
  double share_below = 0;                                           // of predicted runouts below the observed one
};

/// Scores of a forecast, means over the runs; lower is better.
struct Scores {
  double runout = 0;  // continuous ranked probability score of the runout [m]
  double place = 0;   // energy score of the stop on plan [m]
};

struct Moments {
  double mean = 0, std_dev = 0;
};

struct Range {
  double low = 0, high = 0;
};

/// How many runs lie within a central interval of their own predictions, and the central 95 % of the number expected if
/// intervals hold what they claim and runs are independent.
struct Coverage {
  std::uint64_t count = 0;
  Range expected;
};

/// What is known of a parameter from the other sites.
struct FoundParameter {
  std::string name, unit;
  double prior_p05 = 0, prior_p95 = 0, p05 = 0, median = 0, p95 = 0;
};

struct SitePrediction {
  std::string site, from;  // `from`: the names of the other sites
  std::vector<PredictedRun> runs;
  std::vector<ObservedRun> learned_from;
  Moments observed, predicted;  // of the runout; predicted: of all runs in all replicas
  /// 90 % of the replicas: of the mean and of the standard deviation over the runs.
  Range mean_90, std_dev_90;
  Coverage in_50, in_90;
  /// `constant`: the runouts and the stops of the other sites' runs, as a forecast for every run.
  Scores posterior, prior, constant;
  /// Of the runout of single runs: errors of the mean (root mean square) and of the median (mean magnitude) of each
  /// run's own prediction, and of the mean and median runout of the other sites' runs.
  double rmse = 0, rmse_constant = 0, mae = 0, mae_constant = 0;
  double misfit = 1, effective_sets = 0;
  std::vector<FoundParameter> parameters;
  Problems warnings;
};

struct PredictionOptions {
  int threads = 0;  // 0: as many as there are cores
  std::function<void(std::size_t done, std::size_t all)> progress{};
};

/// Predicts every site of the study. Throws BadInput if a project or an observation cannot be read, or stops cannot be
/// matched with releases: the column `name` of the stops must name the rows of a table of releases.
[[nodiscard]] std::vector<SitePrediction> predict_sites(const calibration::Study& study,
                                                        const PredictionOptions& options);

/// The scores of the prior of each site. They follow from laws, terrain, releases and ranges without a calibration.
[[nodiscard]] std::vector<Scores> prior_scores(const calibration::Study& study, int threads = 0);

}  // namespace talus::validation
