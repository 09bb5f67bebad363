#pragma once
// Rules for [[shape]], and for the shapes that seeders name.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "talus/project/document.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

struct ShapeRules {
  const Project& project;
  std::vector<const toml::table*> shapes, seeders;  // rows in the file; null: not a table
  bool is_2d;
  /// The value of a key of a table; null if the file does not give it or it was refused.
  std::function<const toml::node*(const toml::table* of, std::string_view key)> accepted;
  std::function<void(const Spot& at, std::string where, std::string what, std::string why, std::string hint,
                     Severity severity)>
      report;

  void check() const;

 private:
  void refuse(const toml::table& row, std::string_view table, std::size_t number, std::string_view key,
              std::string what, std::string why, std::string hint = "") const;
  void check_shape(std::size_t number) const;
  void check_block(std::size_t number) const;
  void check_group(std::size_t number) const;
  void check_in_section(std::size_t number) const;
  void check_seeder(std::size_t number) const;
  void warn_of_spheres() const;
  /// Whether rocks of the shape can be used in this project's 2D or 3D.
  [[nodiscard]] std::string why_unusable(std::string_view shape) const;
  [[nodiscard]] std::string hint_for(std::string_view mistyped) const;
};

}  // namespace talus::project
