#pragma once
// How many held-out observations lie within the ranges that were predicted for them.

#include <cstddef>
#include <string>
#include <vector>

#include "talus/calibration/calibrate.hpp"

namespace talus::calibration {

/// How many of the observations of a feature that were held out, in all folds or sites, lie within the central 90 % of
/// their prediction, and the central 95 % of the number expected if predictions hold what they claim and observations
/// are independent.
struct HeldOutCoverage {
  std::string group;
  Feature feature;
  std::size_t observations = 0, within_90 = 0, min_expected = 0, max_expected = 0;
  [[nodiscard]] bool is_too_narrow() const { return within_90 < min_expected; }
};

/// In the order of the features.
[[nodiscard]] std::vector<HeldOutCoverage> coverage_of(const std::vector<HeldOut>& held_out);

/// The number of observations that lie in the central 90 % of the forecast for their stratum. `feature`: the column.
[[nodiscard]] std::size_t within_90(const Sample& observed, const Sample& forecast, Eigen::Index feature);

}  // namespace talus::calibration
