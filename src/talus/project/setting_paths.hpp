#pragma once
// Where each value of a project file stands, in words for programs: a form marks the field that is reported.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "talus/project/toml.hpp"

namespace talus::project {

/// Paths such as `material.0.normal_restitution.mean`: keys, and numbers of entries counted from 0, as `--set` takes
/// them. A key with other letters than a to z, A to Z, digits, '_' and '-' is in quotes.
class SettingPaths {
 public:
  /// The table must outlive this, and not change.
  explicit SettingPaths(const toml::table& root);

  /// Of a value below the table; empty for the table itself.
  [[nodiscard]] std::string of(const toml::node& node) const;
  /// Of the first value that begins on a line of the file; a table before what is in it. Empty where none does.
  [[nodiscard]] std::string on_line(std::uint32_t line) const;
  /// Of the text that reads like this. Empty where none does.
  [[nodiscard]] std::string of_text(std::string_view text) const;

  [[nodiscard]] static std::string below(std::string path, std::string_view key);

 private:
  static constexpr std::uint32_t none = 0xffffffffU;
  struct Entry {
    const toml::node* node;
    std::uint32_t parent;  // an entry; none: the table itself
    std::uint32_t number;  // in a list
  };
  void add(const toml::node& node, std::uint32_t parent, std::uint32_t number);
  [[nodiscard]] std::string path(std::uint32_t entry) const;

  const toml::table& root_;
  std::vector<Entry> entries_;             // a table or list before what is in it
  std::vector<std::uint32_t> by_address_;  // the same, sorted
};

}  // namespace talus::project
