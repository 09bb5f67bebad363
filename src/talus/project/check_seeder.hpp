#pragma once
// Rules for one [[seeder]], across its keys: each type of seeder has keys of its own.

#include <functional>
#include <string>
#include <string_view>

#include "talus/project/document.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

struct SeederRules {
  const Project& project;
  const Seeder& seeder;
  const toml::table& row;  // as it stands in the file
  bool type_is_good;       // absent or read
  bool is_flat;            // the analysis is 2D
  bool has_grid;           // the terrain is a raster
  /// The value of a key, where the file has it and it was not refused; else null.
  std::function<const toml::node*(std::string_view key)> good;
  std::function<void(const Spot& at, std::string what, std::string why, std::string hint, Severity severity)> report;

  /// Reports a key that says a place in a way of another type, or that is missing, and gives it back; "type" where the
  /// type itself is wrong, and nothing is known of the other keys.
  [[nodiscard]] std::string_view about_place() const;
  void check() const;

 private:
  [[nodiscard]] bool has(std::string_view key) const { return row.contains(key); }
  /// Nor is there an unknown key that was probably meant to be it, which is reported anyway.
  [[nodiscard]] bool misses(std::string_view key) const;
  /// Gives back the key that it reported, there or missing; "" for the whole row.
  std::string_view refuse(std::string_view key, std::string what, std::string why, std::string hint = "") const;
  void about_cells() const;
  void about_heading() const;
  void about_files() const;
};

}  // namespace talus::project
