#pragma once
// Rules for [[material]], and doubts about its values with the rock's model and the terrain.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "talus/project/document.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

struct MaterialRules {
  const Project& project;
  std::vector<const toml::table*> rows;  // of [[material]] in the file; null: not a table
  bool is_measured;                      // the terrain is a file of natural ground in 3D: a raster, mesh or survey
  /// The value of a key of a table; null if the file does not give it or it was refused.
  std::function<const toml::node*(const toml::table* of, std::string_view key)> accepted;
  std::function<void(const Spot& at, std::string where, std::string what, std::string why, std::string hint,
                     Severity severity)>
      report;

  void check() const;

 private:
  void check_forest(const Material& material, const toml::table& row, const std::string& where) const;
  void check_sphere(const Material& material, const toml::table& row, const std::string& where) const;
  void check_body(const Material& material, const toml::table& row, const std::string& where) const;
  void check_faces(const Material& material, const toml::table& row, const std::string& where) const;
  void check_roughness() const;
};

}  // namespace talus::project
