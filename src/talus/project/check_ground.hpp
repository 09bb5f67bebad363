#pragma once
// Rules for which ground is made of which material, across [ground], the areas painted on it and the materials.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "talus/project/document.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

/// Expects the names of all materials to be known.
struct GroundRules {
  const Project& project;
  const toml::table* row;                 // [ground] as it stands in the file; null: it does not
  const toml::table* terrain;             // [terrain] likewise
  std::vector<const toml::table*> areas;  // the rows of [[area]]; null: no table
  std::optional<bool> is_flat;            // the analysis is 2D; nothing: nobody knows
  /// The value of a key of a table, where the file has it and it was not refused; else null.
  std::function<const toml::node*(const toml::table* of, std::string_view key)> good;
  std::function<void(const Spot& at, std::string where, std::string what, std::string why, std::string hint)> report;

  void check() const;

 private:
  using Node = const toml::node*;
  void refuse(const Spot& at, std::string what, std::string why, std::string hint = "") const;
  [[nodiscard]] bool is_on(std::string_view kind) const { return terrain && terrain->contains(kind); }
  void about_default() const;
  void about_segments(Node segments) const;
  void about_triangles(Node triangles) const;
  void about_raster() const;
  void about_polygons() const;
  void about_areas() const;
  void about_file(std::string_view key, Node node, const std::filesystem::path& file) const;
  /// Of a table of names, `classes` or `values`.
  void about_materials_in(std::string_view key, Node names) const;
  void about_material(const std::string& where, Node node, const std::string& key, const std::string& name) const;
};

}  // namespace talus::project
