#pragma once
// Settings of [report] that are given when a report is written again.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace talus::project {

struct TitleBlockSettings {
  nlohmann::ordered_json given = nlohmann::ordered_json::object();  // by key, as in an echo
  std::string logo;  // the picture of the key `logo` as a `data:` address; empty if it is not given
};

/// Reads overrides such as `report.author=A. Meier`; a logo is relative to the current folder. Throws BadInput with all
/// problems, settings of other tables among them.
[[nodiscard]] TitleBlockSettings title_block_settings(const std::vector<std::string>& overrides);

}  // namespace talus::project
