#pragma once
// Rules for [terrain], across its keys: each way to define the slope has its own keys.

#include <functional>
#include <string>
#include <string_view>

#include "talus/project/document.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

struct TerrainRules {
  const Project& project;
  const toml::table& row;  // in the file
  /// The value of a key; null if the file does not give it or it was refused.
  std::function<const toml::node*(std::string_view key)> accepted;
  std::function<void(const Spot& at, std::string what, std::string why, std::string hint, Severity severity)> report;

  void check() const;

 private:
  using Node = const toml::node*;
  void refuse(const Spot& at, std::string what, std::string why, std::string hint = "") const;
  void check_section(Node section) const;
  void check_deviations(Node deviations) const;
  void check_mesh_files(Node mesh) const;
  void check_mesh_file(Node mesh, const std::filesystem::path& file, const std::string& name) const;
  void check_inline_mesh() const;
};

}  // namespace talus::project
