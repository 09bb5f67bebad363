#pragma once
// Typical grounds with values from the literature, which projects refer to by `like = "talus_cover"`.

#include <string>
#include <string_view>
#include <vector>

#include "talus/project/project.hpp"

namespace talus::project {

struct LibrarySource {
  std::string text;     // the publication
  std::string limits;   // for which rocks and which model its numbers hold
  std::string checked;  // how the numbers were checked against it
};

/// A key of [[material]] that an entry gives.
struct LibraryValue {
  std::string key;
  std::size_t source = 0;  // place in MaterialLibrary::sources
};

struct LibraryMaterial {
  std::string key;                  // by which projects refer to it
  std::string meaning;              // its name in the source
  Material material;                // with defaults for what no source gives
  std::vector<LibraryValue> given;  // in the order of the settings

  /// Null: no source gives the key.
  [[nodiscard]] const LibraryValue* find(std::string_view setting_key) const;
};

struct MaterialLibrary {
  std::vector<LibrarySource> sources;      // in the order of their first use
  std::vector<LibraryMaterial> materials;  // in the order of materials.toml, which is embedded in the program

  /// Null: there is no such entry.
  [[nodiscard]] const LibraryMaterial* find(std::string_view key) const;
  /// The keys of [[material]] that at least one entry gives, in the order of the settings.
  [[nodiscard]] std::vector<std::string> given() const;
};

[[nodiscard]] const MaterialLibrary& material_library();
[[nodiscard]] std::string_view material_library_text();

/// A property for display: "0.35", "0.33 to 0.37", "0.35 (normal, sd 0.04)".
[[nodiscard]] std::string in_words(const Distribution& property);
/// A value of an entry with the number of its source: "0.33 to 0.37 [1]"; empty if no source gives it.
[[nodiscard]] std::string in_words(const LibraryMaterial& entry, std::string_view key);

/// docs/materials.md.
[[nodiscard]] std::string materials_page();

}  // namespace talus::project
