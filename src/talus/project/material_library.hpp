#pragma once
// Typical grounds with values from the literature, which projects refer to by `like = "talus_cover"`.

#include <string>
#include <string_view>
#include <vector>

#include "talus/project/project.hpp"

namespace talus::project {

struct LibraryMaterial {
  std::string key;                 // by which projects refer to it
  std::string meaning;             // its name in the source
  Material material;               // with defaults for what the source does not give
  std::vector<std::string> given;  // keys that the source gives
  std::string source;              // the publication
  std::string checked;             // how the numbers were checked against it
};

/// In the order of materials.toml, which is embedded in the program.
[[nodiscard]] const std::vector<LibraryMaterial>& material_library();
[[nodiscard]] std::string_view material_library_text();

/// A property for display: "0.35", "0.33 to 0.37", "0.35 (normal, sd 0.04)".
[[nodiscard]] std::string in_words(const Distribution& property);

/// docs/materials.md.
[[nodiscard]] std::string materials_page();

}  // namespace talus::project
