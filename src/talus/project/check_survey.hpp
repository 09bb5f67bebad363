#pragma once
// Rules for a terrain from survey data or from closed polylines, across the keys of [terrain].

#include <functional>
#include <string>
#include <string_view>

#include "talus/project/document.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

struct SurveyRules {
  const Project& project;
  const toml::table& row;  // [terrain] in the file
  /// The value of a key; null if the file does not give it or it was refused.
  std::function<const toml::node*(std::string_view key)> accepted;
  std::function<void(const Spot& at, std::string what, std::string why, std::string hint, Severity severity)> report;

  void check() const;

 private:
  void check_files() const;
  void check_polylines() const;
};

}  // namespace talus::project
