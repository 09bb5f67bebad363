#pragma once
// The pages of studies of projects: sensitivity, rock models, calibration, and the prediction of field experiments.

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace talus {

/// The page from the study's summary.json. The same summary gives the same bytes.
[[nodiscard]] std::string study_page(std::string_view name, const nlohmann::ordered_json& summary);

/// The page from the compare.json of a comparison.
[[nodiscard]] std::string models_page(std::string_view name, const nlohmann::ordered_json& comparison);

/// The page of a calibration from its summary.json and the sets of its posterior: of each its weight, then its values.
[[nodiscard]] std::string calibration_page(std::string_view name, nlohmann::ordered_json summary,
                                           nlohmann::ordered_json sets);

/// The page of a field experiment.
[[nodiscard]] std::string validation_page(std::string_view title, const nlohmann::ordered_json& experiment);

}  // namespace talus
