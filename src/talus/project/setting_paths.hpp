#pragma once
// The path of each value of a project file, by which a form marks the field that a problem is about.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "talus/project/toml.hpp"

namespace talus::project {

/// Paths such as `material.0.normal_restitution.mean`: keys and zero-based numbers of entries, as `--set` takes them.
/// A key with characters other than a to z, A to Z, digits, '_' and '-' is quoted.
class SettingPaths {
 public:
  /// The table must outlive this object and not change.
  explicit SettingPaths(const toml::table& root);

  /// The path of a value below the table; empty for the table itself.
  [[nodiscard]] std::string of(const toml::node& node) const;
  /// The path of the first value that begins on a line of the file, a table before its contents. Empty if there is
  /// none.
  [[nodiscard]] std::string on_line(std::uint32_t line) const;
  /// The path of the first string with this text. Empty if there is none.
  [[nodiscard]] std::string of_text(std::string_view text) const;

  /// `path.key`, the key quoted if necessary.
  [[nodiscard]] static std::string below(std::string path, std::string_view key);

 private:
  static constexpr std::uint32_t none = 0xffffffffU;
  struct Entry {
    const toml::node* node;
    std::uint32_t parent;  // index of an entry; none: the table itself
    std::uint32_t number;  // in a list
    std::string_view key;  // in a table
  };
  void add(const toml::node& node, std::uint32_t parent, std::uint32_t number, std::string_view key);
  [[nodiscard]] std::string path(std::uint32_t entry) const;

  std::vector<Entry> entries_;  // a table or list before its contents
  // Indices into entries_: by the nodes' addresses, and the first by line and by text.
  std::unordered_map<const toml::node*, std::uint32_t> by_address_;
  std::unordered_map<std::uint32_t, std::uint32_t> by_line_;
  std::unordered_map<std::string_view, std::uint32_t> by_text_;
};

/// The parts of a path such as `material."Type 1.5".roughness_deg`; nullopt if a quote is left open or a part is empty.
[[nodiscard]] std::optional<std::vector<std::string>> parts_of(std::string_view path);

}  // namespace talus::project
