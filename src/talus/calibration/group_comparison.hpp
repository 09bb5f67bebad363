#pragma once
// How the simulated rocks of a set compare with one group of observations: likelihood, distance and what chance gives.
//
// - Without releases: the synthetic likelihood of the group's summaries; the energy distance between both
//   distributions, and the distance that 95 % of resamples of the observed rocks have at most.
// - With releases or classes of mass: each observed rock in the distribution of its own. The distance is the mean
// energy
//   score; chance gives what 95 % of as many rocks drawn from the set itself would have at most.
// - Zones: the probability of the observed shares; the energy distance and score with a distance of 1 between any two
//   zones, which are the sum of the squared differences of shares, and half the Brier score.

#include <cstdint>
#include <optional>
#include <vector>

#include "talus/calibration/comparison.hpp"
#include "talus/calibration/observations.hpp"

namespace talus::calibration {

struct Compared {
  LogDensity density;   // -infinity: too few rocks to estimate a distribution
  double distance = 0;  // over the observed spread
  double chance = 0;    // a distance up to this agrees
};

class GroupComparison {
 public:
  /// `group` must outlive this.
  GroupComparison(const ObservedGroup& group, std::uint64_t seed);

  [[nodiscard]] Compared compare(const Sample& simulated) const;
  /// Of a part of the observations. Expects one row or more.
  [[nodiscard]] LogDensity density(const Sample& simulated, const Sample& observed) const;
  /// The distance alone.
  [[nodiscard]] double distance(const Sample& simulated) const;
  /// The mean score of a part of the observations in a forecast; without strata, all are compared with all of it.
  [[nodiscard]] double score(const Sample& forecast, const Sample& observed) const;
  /// How many summaries the likelihood has.
  [[nodiscard]] std::size_t summary_count() const;

 private:
  [[nodiscard]] double chance_of_releases(const Sample& simulated) const;
  [[nodiscard]] double chance_of_zones() const;

  const ObservedGroup& group_;
  std::uint64_t seed_;
  std::optional<Comparison> rows_;  // not of zones
  Eigen::VectorXd shares_;          // of zones
  double chance_ = 0;               // of groups without strata
};

}  // namespace talus::calibration
