#pragma once
// The models of a study, each calibrated into a folder of its own, and compared.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "talus/calibration/calibrate.hpp"

namespace talus::calibration {

/// Mean scores over all observations that were held out.
struct HeldOutScore {
  double posterior = 0, prior = 0;
};
/// Nullopt: none was held out.
[[nodiscard]] std::optional<HeldOutScore> held_out_score(const CalibrationResult& result);

/// The folder of results where none is given: named after the study, next to its file.
[[nodiscard]] std::filesystem::path usual_folder(const Study& study);

/// Calls `calibrate` for each model of the study, with its folder in `folder` (model-1, model-2 ...), and writes
/// models.csv and pooled.csv. Returns the text of models.csv. Throws BadInput if a file cannot be written.
std::string calibrate_models_into(
    const std::filesystem::path& folder, const Study& study,
    const std::function<CalibrationResult(const StudyModel& model, const std::filesystem::path& folder)>& calibrate);

}  // namespace talus::calibration
