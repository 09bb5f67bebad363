#pragma once
// Rules for one [[seeder]], across its keys: each type of seeder has its own keys.

#include <functional>
#include <string>
#include <string_view>

#include "talus/project/document.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

struct SeederRules {
  const Project& project;
  const Seeder& seeder;
  const toml::table& row;  // in the file
  bool type_is_known;      // `type` was read, or is not given
  bool is_2d;
  bool has_grid;  // the terrain is a raster
  /// The value of a key; null if the file does not give it or it was refused.
  std::function<const toml::node*(std::string_view key)> accepted;
  std::function<void(const Spot& at, std::string what, std::string why, std::string hint, Severity severity)> report;

  /// Reports a position given in the way of another type, or a missing one. Returns the key that was reported, "" if
  /// none, or "type" if the type itself is wrong, so that the other keys cannot be judged.
  [[nodiscard]] std::string_view check_place() const;
  void check() const;

 private:
  [[nodiscard]] bool has(std::string_view key) const { return row.contains(key); }
  /// Whether the key is missing, and no unknown key (which is reported anyway) was probably meant to be it.
  [[nodiscard]] bool misses(std::string_view key) const;
  /// Returns the key that it reported, present or missing; "" stands for the whole row.
  std::string_view refuse(std::string_view key, std::string what, std::string why, std::string hint = "") const;
  void check_cells() const;
  void check_files() const;
};

}  // namespace talus::project
