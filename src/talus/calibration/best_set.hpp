#pragma once
// The set of least score beside the posterior.

#include <string>

#include "talus/calibration/calibrate.hpp"

namespace talus::calibration {

/// A sentence that names the parameters of which the best set lies outside the central 90 % of the posterior, and says
/// how that can be; empty if there are none.
[[nodiscard]] std::string why_best_is_outside(const PreparedStudy& study, const CalibrationResult& result);

}  // namespace talus::calibration
