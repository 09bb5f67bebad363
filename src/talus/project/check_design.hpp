#pragma once
// Rules for the design of barriers, across [design] and the barriers and collectors that it names.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "talus/project/document.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

struct DesignRules {
  const Project& project;
  const Design& design;
  const toml::table& row;                                // [design] as it stands in the file
  std::vector<const toml::table*> barriers, collectors;  // as they stand there; null: no table
  std::optional<bool> is_2d;                             // nothing: nobody knows
  /// The value of a key of a table, where the file has it and it was not refused; else null.
  std::function<const toml::node*(const toml::table* of, std::string_view key)> good;
  std::function<void(const toml::node* at, std::string what, std::string why, std::string hint, Severity severity)>
      report;

  void check() const;

 private:
  /// As results will call them, barriers first; nothing where a name was refused.
  [[nodiscard]] std::optional<std::vector<std::string>> names() const;
  void about_lines() const;
  void about_name(const toml::node& node, const std::string& key, const std::string& name,
                  const std::vector<std::string>& known) const;
  void about_sections() const;
  void about_lists() const;
  void about_standard() const;
  void about_what_is_stopped_before() const;
};

}  // namespace talus::project
