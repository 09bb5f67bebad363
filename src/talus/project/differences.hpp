#pragma once
// In which settings two projects differ.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace talus::project {

struct Difference {
  std::string key;                     // as `--set` takes it: material.Type One.roughness_deg
  nlohmann::ordered_json here, there;  // null: not set
};

/// Of two echoed projects (echo.hpp), in the order of the first; what only the second has comes last. Entries of lists
/// go together by their names where they have some of their own, otherwise by their numbers, counted from 0; a list of
/// values is one value.
[[nodiscard]] std::vector<Difference> differences(const nlohmann::ordered_json& here,
                                                  const nlohmann::ordered_json& there);

}  // namespace talus::project
