#pragma once
// The project file as TOML, with `--set` overrides applied. Every value keeps the file and line it came from.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "talus/core/problems.hpp"
#include "talus/project/setting_paths.hpp"
#include "talus/project/toml.hpp"

namespace talus::project {

/// Maximum size of a project file; larger terrains belong in a mesh file.
inline constexpr std::uintmax_t most_bytes = 64u << 20u;

/// Reads a whole file. Throws BadInput with the reason if it cannot be read. `kind`, for messages: project, study.
[[nodiscard]] std::string text_of_file(const std::filesystem::path& file, std::string_view kind = "project");

/// The location of a problem: a value; or a key that is missing in a table, reported at another value (the table itself
/// or another key).
struct Spot {
  const toml::node* node;  // null: no location
  const toml::table* lacking = nullptr;
  std::string_view key{};

  Spot(const toml::node* value) : node(value) {}  // NOLINT: most problems are about a value
  Spot(const toml::node* place, const toml::table* table, std::string_view missing_key)
      : node(place), lacking(table), key(missing_key) {}
};

class Document {
 public:
  /// Throws BadInput if the text is not TOML.
  Document(std::string_view text, std::string file);
  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;

  /// Applies `table.key=value`, where the value is TOML or else a string without its quotes. List entries are addressed
  /// by zero-based number or by name: `seeder.0.rocks=10`, `material.Type One.roughness_deg=3`.
  void set(const std::string& override_text, Problems& problems);

  [[nodiscard]] const toml::table& root() const { return root_; }
  [[nodiscard]] const std::string& file() const { return file_; }

  /// A problem at the location of a value.
  [[nodiscard]] Problem at(const toml::node& node, Severity severity = Severity::error) const;
  [[nodiscard]] Problem at(const Spot& spot, Severity severity = Severity::error) const;
  /// A problem without a location in the text; `key` is the missing table, if any.
  [[nodiscard]] Problem nowhere(std::string_view key = {}) const;

 private:
  toml::table root_;
  std::string file_;
  mutable std::optional<SettingPaths> paths_;  // created for the first problem
};

/// The entry of a list; the list itself if it has no such entry.
[[nodiscard]] const toml::node* entry(const toml::node* list, std::size_t index);

/// The number in a node; nullopt if it is not a number. (For an integer beyond 2^53 that no double equals, toml++ has
/// no value; here it is the nearest double.)
[[nodiscard]] std::optional<double> number_in(const toml::node& node);

/// A value as quoted in a problem: in one line, truncated if it is long.
[[nodiscard]] std::string quoted(const toml::node& node);

}  // namespace talus::project
