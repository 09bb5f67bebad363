#pragma once
// Usual grounds with values from the literature, for a project to name: `like = "talus_cover"`.

#include <string>
#include <string_view>
#include <vector>

#include "talus/project/project.hpp"

namespace talus::project {

struct LibraryMaterial {
  std::string key;                 // by which a project names it
  std::string meaning;             // what its source calls it
  Material material;               // what the source does not give has its default
  std::vector<std::string> given;  // keys of what the source gives
  std::string source;              // the publication
  std::string checked;             // how the numbers were held against it
};

/// In the order of materials.toml, which is part of the program.
[[nodiscard]] const std::vector<LibraryMaterial>& material_library();
[[nodiscard]] std::string_view material_library_text();

/// A property for people: "0.35", "0.33 to 0.37", "0.35 (normal, sd 0.04)".
[[nodiscard]] std::string in_words(const Distribution& property);

/// docs/materials.md.
[[nodiscard]] std::string materials_page();

}  // namespace talus::project
