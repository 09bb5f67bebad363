#pragma once
// The report of a sensitivity study.

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace talus {

/// The page from the study's summary.json. The same summary gives the same bytes.
[[nodiscard]] std::string study_page(std::string_view name, const nlohmann::ordered_json& summary);

}  // namespace talus
