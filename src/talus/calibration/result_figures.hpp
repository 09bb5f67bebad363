#pragma once
// The numbers behind the figures of a calibration, for its report, its summary and the workbench.

#include <cstddef>
#include <span>
#include <vector>

#include "talus/calibration/calibrate.hpp"

namespace talus::calibration {

/// A parameter's prior and posterior in bins of equal width, from the prior's 0.1 % to its 99.9 %. Shares of the
/// posterior beyond them are in the outermost bins.
struct ParameterHistogram {
  std::vector<double> edges;
  std::vector<double> prior, posterior;  // shares
};
[[nodiscard]] ParameterHistogram histogram_of(std::size_t parameter, const PreparedStudy& study,
                                              const CalibrationResult& result);

/// The correlation of two parameters in the posterior; 0 if one of them has a single value.
[[nodiscard]] double correlation_of(std::size_t a, std::size_t b, const CalibrationResult& result);

/// Quantiles (5, 50 and 95 %), at each place, of the distribution functions of as many rocks as were observed.
struct DistributionBand {
  std::vector<double> low, middle, high;
};

/// A feature of a group: the observed values in ascending order, and how the prior and the posterior predict them.
struct PredictedDistribution {
  std::vector<double> observed;
  std::vector<double> at;  // places of the bands
  DistributionBand prior, posterior;
};
/// Empty if no set has a simulated rock of this group.
[[nodiscard]] PredictedDistribution prediction_of(std::size_t group, std::size_t feature, const PreparedStudy& study,
                                                  const CalibrationResult& result);

}  // namespace talus::calibration
