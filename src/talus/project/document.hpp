#pragma once
// The project file as TOML, with `--set` overrides worked in; every value knows the file and line it came from.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "talus/core/problems.hpp"
#include "talus/project/setting_paths.hpp"
#include "talus/project/toml.hpp"

namespace talus::project {

/// A project file is at most this large; terrains that need more belong in a mesh file.
inline constexpr std::uintmax_t most_bytes = 64u << 20u;

/// Reads a whole file, or says why it cannot be read.
[[nodiscard]] std::string text_of_file(const std::filesystem::path& file);

/// What a problem is about: a value; or a key that a table lacks, reported in the place of a value (the table itself,
/// or a key beside it).
struct Spot {
  const toml::node* node;  // null: of no place
  const toml::table* lacking = nullptr;
  std::string_view key{};

  Spot(const toml::node* value) : node(value) {}  // NOLINT: most problems are with a value
  Spot(const toml::node* place, const toml::table* table, std::string_view missing_key)
      : node(place), lacking(table), key(missing_key) {}
};

class Document {
 public:
  /// Throws BadInput where the text is not TOML.
  Document(std::string_view text, std::string file);
  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;

  /// Works `table.key=value` in, the value being TOML (what is none and not meant to be is taken for a string). Entries
  /// of lists are called by their number, counted from 0, or by their name: `seeder.0.rocks=10`, `material.Type
  /// One.roughness_deg=3`.
  void set(const std::string& override_text, Problems& problems);

  [[nodiscard]] const toml::table& root() const { return root_; }
  [[nodiscard]] const std::string& file() const { return file_; }

  /// A problem about a value, in its place.
  [[nodiscard]] Problem at(const toml::node& node, Severity severity = Severity::error) const;
  [[nodiscard]] Problem at(const Spot& spot, Severity severity = Severity::error) const;
  /// A problem about what is not there; `key`: the table that is meant, if it is one.
  [[nodiscard]] Problem nowhere(std::string_view key = {}) const;

 private:
  toml::table root_;
  std::string file_;
  mutable std::optional<SettingPaths> paths_;  // made for the first problem
};

/// An entry of a list; the list itself where it has none of this number.
[[nodiscard]] const toml::node* entry(const toml::node* list, std::size_t index);

/// The number that a node is; nothing where it is none. (toml++ itself gives nothing for a whole number beyond 2^53
/// that no double equals; here it is the nearest double.)
[[nodiscard]] std::optional<double> number_in(const toml::node& node);

/// A value as a problem quotes it: in one line, cut where it is long.
[[nodiscard]] std::string quoted(const toml::node& node);

}  // namespace talus::project
