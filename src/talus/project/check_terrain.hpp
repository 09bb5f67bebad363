#pragma once
// Rules for [terrain], across its keys: the slope is said in one of several ways, each with keys of its own.

#include <functional>
#include <string>
#include <string_view>

#include "talus/project/document.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

struct TerrainRules {
  const Project& project;
  const toml::table& row;  // as it stands in the file
  bool is_flat;            // the analysis is 2D
  /// The value of a key, where the file has it and it was not refused; else null.
  std::function<const toml::node*(std::string_view key)> good;
  std::function<void(const Spot& at, std::string what, std::string why, std::string hint, Severity severity)> report;

  void check() const;

 private:
  using Node = const toml::node*;
  void refuse(const Spot& at, std::string what, std::string why, std::string hint = "") const;
  void about_section(Node section) const;
  void about_deviations(Node deviations) const;
  void about_mesh_file(Node mesh) const;
  void about_inline_mesh() const;
};

}  // namespace talus::project
