#pragma once
// Calibration: which parameters of the projects of a study agree with what was observed.
//
// Sets of parameters are drawn in rounds (sampler.hpp) and simulated with the same draws of rocks; the likelihood of
// each comes from its simulated rocks (likelihood.hpp). Beside it stands a proper score, the energy distance between
// the simulated and the observed distribution, with the threshold that chance alone gives: the distance between
// resamples of the observations and the observations.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "talus/calibration/observations.hpp"
#include "talus/calibration/sampler.hpp"
#include "talus/calibration/study.hpp"
#include "talus/core/problems.hpp"
#include "talus/study/prepared_sites.hpp"

namespace talus::calibration {

/// A study whose projects, observations and parameters have been read and checked.
class PreparedStudy {
 public:
  /// Builds the models and reads the observations. Throws BadInput with all problems; doubts are added to `warnings`.
  /// `variant`: one of the study's models; null: the projects as they are.
  PreparedStudy(Study study, const StudyModel* variant, Problems& warnings);

  [[nodiscard]] const Study& study() const { return study_; }
  [[nodiscard]] const std::vector<study::PreparedSite>& sites() const { return sites_.sites(); }
  [[nodiscard]] const std::vector<ObservedGroup>& groups() const { return groups_; }
  [[nodiscard]] const std::vector<study::Parameter>& parameters() const { return sites_.parameters(); }

  /// One value for each parameter.
  [[nodiscard]] study::ParameterSet values_at(const Place& place) const;
  /// The sites with their parameters.
  [[nodiscard]] const study::PreparedSites& prepared() const { return sites_; }
  /// The settings of the variant.
  [[nodiscard]] const std::vector<std::string>& overrides() const { return overrides_; }
  /// Identifies the study, its projects and observations, and the program.
  [[nodiscard]] const std::string& fingerprint() const { return fingerprint_; }

 private:
  void check_folds() const;
  void check_dependence(Problems& warnings) const;

  Study study_;
  study::PreparedSites sites_;
  std::vector<ObservedGroup> groups_;
  std::vector<std::string> overrides_;
  std::string fingerprint_;
};

/// The simulated rocks of one set, and how they compare with the observations.
struct SetResult {
  std::size_t round = 0;
  study::ParameterSet values;
  std::vector<Sample> samples;         // by group
  std::vector<LogDensity> densities;   // by group; without weights
  std::vector<double> distances;       // by group: energy distance over the observed spread (group_comparison.hpp)
  std::vector<double> chances;         // by group: the distance that chance alone gives at most, in 95 %
  double log_likelihood = 0;           // as simulated; -infinity: a line that no rock reaches
  double smoothed_log_likelihood = 0;  // without the noise of the simulation (smoothed_likelihood.hpp)
  double score = 0;                    // mean distance over groups
  double weight = 0;                   // in the posterior; all add up to 1
};

struct Moments {
  double mean = 0, std_dev = 0;
};

/// A feature of a group, as observed and as predicted from the other observations.
struct PredictedFeature {
  std::string group;
  Feature feature;
  Moments observed, predicted;
  std::size_t observations = 0;
  std::size_t within_90 = 0;  // of them, in the central 90 % of what is predicted for them
};

/// The sum of the scores of a rock's observations, and their number.
struct ObservedScore {
  double sum = 0, count = 0;
};

/// A score of predictions of observations that were held out, over the spread of the observations: of the posterior
/// from the others, of the prior, and of the distribution of the other observations themselves. Lower is better.
struct HeldOut {
  std::string name;  // "fold 1", or the site
  std::size_t observations = 0;
  double posterior = 0, prior = 0;
  std::optional<double> constant;  // nullopt: there are no other observations of this kind
  std::vector<PredictedFeature> features;
  /// `posterior` of each observed rock: the sum over its observations, and their number. All calibrations of the same
  /// observations have the same rocks in the same order.
  std::vector<ObservedScore> scores;
};

struct CalibrationResult {
  std::vector<SetResult> sets;     // in the order of their draws
  std::vector<double> thresholds;  // by group: the distance that chance alone gives the best set at most, in 95 %
  std::size_t best = 0;            // the set of least score
  double effective_sets = 0;       // of the posterior
  /// Standard deviation of the (natural) logarithm of a set's likelihood by the chance of its simulated rocks, from
  /// their halves; nullopt: a half has too few rocks.
  std::optional<double> likelihood_noise;
  /// Factor by which the variances of summaries were increased because the posterior's sets do not reproduce the
  /// observations; 1: none.
  double misfit = 1;
  std::vector<HeldOut> held_out;
  Problems warnings;
};

struct CalibrationOptions {
  int threads = 0;  // 0: as many as there are cores
  /// Called with the number of sets done and of all sets; by one thread at a time.
  std::function<void(std::size_t done, std::size_t all)> progress{};
  /// Called after all sets, with what is done next.
  std::function<void(const std::string& what)> phase{};
  /// Returns the samples of a set that an earlier calibration has simulated.
  std::function<std::optional<std::vector<Sample>>(std::size_t set)> known{};
  /// Called with sets that are finished, in their order.
  std::function<void(std::size_t first, const std::vector<SetResult>& sets)> finished{};
  /// For tests of the method: factor of the logarithm of the likelihood. Anything but 1 is wrong.
  double likelihood_power = 1;
};

/// Throws Stopped at the request of the thread's StopScope.
[[nodiscard]] CalibrationResult calibrate(const PreparedStudy& study, const CalibrationOptions& options = {});

/// Whether all distances of a set are such as chance alone gives.
[[nodiscard]] bool agrees(const SetResult& set);

}  // namespace talus::calibration
