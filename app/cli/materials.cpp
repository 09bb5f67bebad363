// `talus materials`: the library of materials for `like = "..."` in a [[material]].

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "commands.hpp"
#include "talus/project/material_library.hpp"

namespace talus::cli {

int materials() {
  const auto& library = project::material_library();
  std::size_t key_width = 0, meaning_width = 0;
  for (const auto& entry : library) {
    key_width = std::max(key_width, entry.key.size());
    meaning_width = std::max(meaning_width, entry.meaning.size());
  }
  const auto row = [&](std::string_view key, std::string_view meaning, std::string_view normal,
                       std::string_view tangential, std::string_view source) {
    fmt::print("{:<{}}  {:<{}}  {:<13}  {:<13}  {}\n", key, key_width, meaning, meaning_width, normal, tangential,
               source);
  };
  row("like", "ground", "Rn", "Rt", "source");
  std::vector<std::string> sources;
  for (const auto& entry : library) {
    auto source = std::find(sources.begin(), sources.end(), entry.source);
    if (source == sources.end()) source = sources.insert(source, entry.source);
    row(entry.key, entry.meaning, project::in_words(entry.material.normal_restitution),
        project::in_words(entry.material.tangential_restitution), fmt::format("[{}]", source - sources.begin() + 1));
  }
  fmt::print("\n");
  for (std::size_t k = 0; k < sources.size(); ++k) fmt::print("[{}] {}\n", k + 1, sources[k]);
  fmt::print(
      "\nTo use one: [[material]] name = \"Scree\" like = \"talus_cover\". Other keys of the material override its\n"
      "values; keys without a value from the source keep their defaults. docs/materials.md describes how the numbers\n"
      "were checked.\n");
  return done;
}

}  // namespace talus::cli
