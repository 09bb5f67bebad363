#pragma once
// Checks the conditions of settings: whether each has an effect, given the other settings of the file.

#include <optional>
#include <string>
#include <string_view>
#include <unordered_set>

#include "talus/core/problems.hpp"
#include "talus/project/document.hpp"
#include "talus/project/settings.hpp"

namespace talus::project {

/// A condition in words: `model = "rigid_sphere"`, `points`, `no terrain.section`.
[[nodiscard]] std::string in_words(const Table& table, const Condition& condition);
/// All conditions of a need, joined by "or".
[[nodiscard]] std::string in_words(const Table& table, const Need& need);

/// The message about a setting with an unmet need. `now` is the value of the first condition's key.
struct NotMet {
  Severity severity;
  std::string what, why, hint;
};
[[nodiscard]] NotMet message(const Table& table, const Setting& setting, const Need& need, std::string_view now);

/// Compares the values of a file with the conditions of settings.
class ConditionCheck {
 public:
  /// `refused` are values that were not read; conditions on them count as met.
  ConditionCheck(const toml::table& root, const std::unordered_set<const toml::node*>& refused)
      : root_(root), refused_(refused) {}

  /// The first need of a setting in this row that is not met and has to be reported; nullopt if the setting applies or
  /// its value is always accepted.
  [[nodiscard]] std::optional<NotMet> unmet(const Table& table, const toml::table& row, const Setting& setting) const;

 private:
  [[nodiscard]] bool is_true(const Table& table, const toml::table& row, const Condition& condition) const;
  [[nodiscard]] bool is_met(const Table& table, const toml::table& row, const Need& need) const;
  /// The value of a key as text; without the key, the default.
  [[nodiscard]] std::string text(const Table& table, const toml::table* row, std::string_view key) const;

  const toml::table& root_;
  const std::unordered_set<const toml::node*>& refused_;
};

}  // namespace talus::project
