#pragma once
// The project file as a JSON Schema (draft 7, which TOML editors support): keys, types, ranges, words, defaults.

#include <nlohmann/json.hpp>

namespace talus::project {

[[nodiscard]] nlohmann::ordered_json schema();

}  // namespace talus::project
