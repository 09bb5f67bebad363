#pragma once
// The pages of studies of a project: its sensitivity, and its rock models.

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace talus {

/// The page from the study's summary.json. The same summary gives the same bytes.
[[nodiscard]] std::string study_page(std::string_view name, const nlohmann::ordered_json& summary);

/// The page from the compare.json of a comparison.
[[nodiscard]] std::string models_page(std::string_view name, const nlohmann::ordered_json& comparison);

}  // namespace talus
