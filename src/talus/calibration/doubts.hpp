#pragma once
// Warnings about a calibration: what its results do not say.

#include <vector>

#include "talus/calibration/calibrate.hpp"
#include "talus/calibration/group_comparison.hpp"

namespace talus::calibration {

/// How much the observations say about a parameter.
struct Learned {
  double width = 1;  // standard deviation of the posterior over that of the prior, as shares of the prior
  double at_least = 0, at_most = 0;  // share of the posterior in the lowest and highest twentieth of the prior
  [[nodiscard]] bool is_nothing() const { return width > 0.9; }
};
[[nodiscard]] Learned learned_about(std::size_t parameter, const PreparedStudy& study, const CalibrationResult& result);

/// Adds all warnings to the result.
void add_doubts(const PreparedStudy& study, const std::vector<GroupComparison>& comparisons, CalibrationResult& result);

}  // namespace talus::calibration
