#pragma once
// summary.json of a calibration, from which its report and the workbench draw it.

#include <nlohmann/json.hpp>

#include "talus/calibration/calibrate.hpp"

namespace talus::calibration {

/// Without a posterior the figures that need one are null or missing.
[[nodiscard]] nlohmann::ordered_json summary_of(const PreparedStudy& study, const CalibrationResult& result);

/// The sets that matter in the posterior, for pictures: of each its weight, then its values.
[[nodiscard]] nlohmann::ordered_json posterior_sets(const CalibrationResult& result);

}  // namespace talus::calibration
