#pragma once
// Rules for the ground, across [ground], [[area]], [[forest]] and [[material]].

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
  const toml::table* row;                   // [ground] in the file; null: none
  const toml::table* terrain;               // [terrain] in the file; null: none
  std::vector<const toml::table*> areas;    // the rows of [[area]]; null: not a table
  std::vector<const toml::table*> forests;  // the rows of [[forest]]; null: not a table
  std::optional<bool> is_2d;                // nullopt: unknown
  /// The value of a key of a table; null if the file does not give it or it was refused.
  std::function<const toml::node*(const toml::table* of, std::string_view key)> accepted;
  std::function<void(const Spot& at, std::string where, std::string what, std::string why, std::string hint)> report;

  void check() const;

 private:
  using Node = const toml::node*;
  void refuse(const Spot& at, std::string what, std::string why, std::string hint = "") const;
  [[nodiscard]] bool is_on(std::string_view kind) const { return terrain && terrain->contains(kind); }
  void check_default() const;
  void check_segments(Node segments) const;
  void check_triangles(Node triangles) const;
  void check_raster() const;
  void check_polygons() const;
  void check_areas() const;
  void check_forests() const;
  void check_forest(const ForestArea& forest, const toml::table& given, const std::string& where) const;
  void check_file(const std::string& where, std::string_view key, Node node, const std::filesystem::path& file) const;
  /// Checks the names in a table, `classes` or `values`.
  void check_materials_in(std::string_view key, Node names) const;
  void check_material(const std::string& where, Node node, const std::string& key, const std::string& name) const;
};

}  // namespace talus::project
