#pragma once
// Rules for the design of barriers, across [design] and the barriers and collectors that it names.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "talus/project/document.hpp"
#include "talus/project/factor_set.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

struct DesignRules {
  const Project& project;
  const Design& design;
  const toml::table& row;                                      // [design] in the file
  std::vector<const toml::table*> barriers, collectors, kits;  // their rows; null: not a table
  std::optional<bool> is_2d;                                   // nullopt: unknown
  bool asks_a_line;                                            // of a finished run: the project needs none
  /// The value of a key of a table; null if the file does not give it or it was refused.
  std::function<const toml::node*(const toml::table* of, std::string_view key)> accepted;
  std::function<void(const toml::node* at, std::string what, std::string why, std::string hint, Severity severity)>
      report;
  /// The same for a kit, by its number.
  std::function<void(std::size_t kit, const toml::node* at, std::string what, std::string why, std::string hint,
                     Severity severity)>
      report_kit;
  /// For problems of a file that [design] names.
  std::function<void(const Problems& problems)> report_of_file;

  void check() const;

 private:
  /// The names of all lines in the results, barriers first; nullopt if a name was refused.
  [[nodiscard]] std::optional<std::vector<std::string>> names() const;
  void check_lines() const;
  void check_name(const toml::node& node, const std::string& key, const std::string& name,
                  const std::vector<std::string>& known) const;
  void check_sections() const;
  void check_lists() const;
  void check_standard() const;
  /// Factors of the set that nothing gives, and given ones that the set does not have. Reads the set's file.
  void check_factors() const;
  void check_factors(const FactorSet& set) const;
  void check_kits(const FactorSet* set) const;
  void check_kit(std::size_t kit, const FactorSet* set) const;
  void check_pairs() const;
  void check_barriers_before_protected_line() const;
};

}  // namespace talus::project
