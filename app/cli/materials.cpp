// `talus materials`: the library of materials for `like = "..."` in a [[material]].

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "commands.hpp"
#include "exit_codes.hpp"
#include "talus/project/material_library.hpp"

namespace talus::cli {
namespace {

/// The symbol of a key, as docs/laws.md has it.
std::string heading(const std::string& key) {
  static const std::map<std::string, std::string> symbols{{"normal_restitution", "Rn"},
                                                          {"tangential_restitution", "Rt"},
                                                          {"friction_angle_deg", "phi, deg"},
                                                          {"roughness_deg", "roughness, deg"},
                                                          {"roughness_spacing_m", "its spacing, m"},
                                                          {"dynamic_friction", "mu"},
                                                          {"rolling_friction", "mu_r"}};
  const auto found = symbols.find(key);
  return found == symbols.end() ? key : found->second;
}

int materials() {
  const project::MaterialLibrary& library = project::material_library();
  std::vector<std::vector<std::string>> rows(library.materials.size() + 1);
  rows.front().emplace_back("like");
  for (std::size_t i = 0; i < library.materials.size(); ++i) rows[i + 1].push_back(library.materials[i].key);
  for (const std::string& key : library.given()) {
    rows.front().push_back(heading(key));
    for (std::size_t i = 0; i < library.materials.size(); ++i) {
      rows[i + 1].push_back(project::in_words(library.materials[i], key));
    }
  }
  rows.front().emplace_back("ground");
  for (std::size_t i = 0; i < library.materials.size(); ++i) rows[i + 1].push_back(library.materials[i].meaning);
  std::vector<std::size_t> widths(rows.front().size());
  for (const auto& row : rows) {
    for (std::size_t k = 0; k + 1 < row.size(); ++k) widths[k] = std::max(widths[k], row[k].size());
  }
  for (const auto& row : rows) {
    for (std::size_t k = 0; k + 1 < row.size(); ++k) fmt::print("{:<{}}  ", row[k], widths[k]);
    fmt::print("{}\n", row.back());
  }
  for (std::size_t k = 0; k < library.sources.size(); ++k) {
    fmt::print("\n[{}] {}.\n    {}.\n", k + 1, library.sources[k].text, library.sources[k].limits);
  }
  fmt::print(
      "\nTo use one: [[material]] name = \"Scree\" like = \"talus_cover\". Other keys of the material override its\n"
      "values; keys without a value from a source keep their defaults. docs/materials.md describes how the numbers\n"
      "were checked.\n");
  return done;
}

}  // namespace

Command add_materials(CLI::App& app) {
  return {app.add_subcommand("materials", "List the library of ground materials, with their sources"), materials};
}

}  // namespace talus::cli
