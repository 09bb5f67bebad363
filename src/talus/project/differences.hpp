#pragma once
// The settings in which two projects differ.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace talus::project {

struct Difference {
  std::string key;                     // as `--set` takes it: material.Type One.roughness_deg
  nlohmann::ordered_json here, there;  // null: not set
};

/// The differences of two echoed projects (echo.hpp), in the order of the first; settings of the second alone come
/// last. List entries are matched by name if all names are different, else by their zero-based number. A list of values
/// is one value.
[[nodiscard]] std::vector<Difference> differences(const nlohmann::ordered_json& here,
                                                  const nlohmann::ordered_json& there);

}  // namespace talus::project
