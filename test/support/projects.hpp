#pragma once
// Projects as texts of a file slope.toml, and the problems that are reported about them.

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "support/replaced.hpp"
#include "talus/core/problems.hpp"
#include "talus/model/model.hpp"
#include "talus/project/read.hpp"

namespace talus::testing_tools {

/// Reads a project and returns its warnings; or, if it is refused, the errors and warnings.
[[nodiscard]] inline std::string problems_of_reading(std::string_view text, const project::Overrides& overrides = {}) {
  try {
    return project::read_project_text(text, "slope.toml", overrides).warnings.text();
  } catch (const BadInput& bad) {
    return bad.problems().text();
  }
}

/// What refuses a project: the errors of reading it, together with the warnings; "" if it is read.
[[nodiscard]] inline std::string refusal_of_reading(std::string_view text, const project::Overrides& overrides = {}) {
  try {
    static_cast<void>(project::read_project_text(text, "slope.toml", overrides));
  } catch (const BadInput& bad) {
    return bad.problems().text();
  }
  return "";
}

/// The model of a project; warnings of reading and building it are added to `warnings`.
[[nodiscard]] inline Model model_of(std::string_view text, Problems& warnings) {
  const project::Reading reading = project::read_project_text(text, "slope.toml");
  warnings.append(reading.warnings);
  return project::build_model(reading.project, warnings);
}

[[nodiscard]] inline Model model_of(std::string_view text) {
  Problems warnings;
  return model_of(text, warnings);
}

/// The model of a project about which there is nothing to warn of.
[[nodiscard]] inline Model model_without_warnings(std::string_view text) {
  Problems warnings;
  Model model = model_of(text, warnings);
  EXPECT_EQ(warnings.text(), "");
  return model;
}

/// Builds the model of a project and returns the warnings; or, if it is refused, the errors.
[[nodiscard]] inline std::string problems_of_model(std::string_view text) {
  Problems warnings;
  try {
    static_cast<void>(model_of(text, warnings));
  } catch (const BadInput& bad) {
    return bad.problems().text();
  }
  return warnings.text();
}

}  // namespace talus::testing_tools
