#pragma once
// Whether settings have an effect beside what a project file says else: the conditions of their declaration.

#include <optional>
#include <string>
#include <string_view>
#include <unordered_set>

#include "talus/core/problems.hpp"
#include "talus/project/document.hpp"
#include "talus/project/settings.hpp"

namespace talus::project {

/// What a condition asks for, in words: `model = "rigid_sphere"`, `points`, `no terrain.section`.
[[nodiscard]] std::string in_words(const Table& table, const Condition& condition);
/// Of all conditions, joined by "or".
[[nodiscard]] std::string in_words(const Table& table, const Need& need);

/// The message about a setting that a need is not met for. `now`: what the first condition's key is.
struct NotMet {
  Severity severity;
  std::string what, why, hint;
};
[[nodiscard]] NotMet message(const Table& table, const Setting& setting, const Need& need, std::string_view now);

/// Holds the values of a file against the conditions of settings.
class Applying {
 public:
  /// `refused` are values that were not read; what hangs on them nobody knows, and it counts as met.
  Applying(const toml::table& root, const std::unordered_set<const toml::node*>& refused)
      : root_(root), refused_(refused) {}

  /// What is wrong with a setting that the row gives: the first of its needs that is not met and is reported; nothing:
  /// it applies, or its value asks for nothing.
  [[nodiscard]] std::optional<NotMet> against(const Table& table, const toml::table& row, const Setting& setting) const;

 private:
  [[nodiscard]] bool holds(const Table& table, const toml::table& row, const Condition& condition) const;
  [[nodiscard]] bool is_met(const Table& table, const toml::table& row, const Need& need) const;
  /// The value of a key as text, or its default's.
  [[nodiscard]] std::string text(const Table& table, const toml::table* row, std::string_view key) const;

  const toml::table& root_;
  const std::unordered_set<const toml::node*>& refused_;
};

}  // namespace talus::project
