#pragma once
// A project as text, and what was read from it.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "talus/project/read.hpp"

namespace talus::python {

struct GivenProject {
  std::string text;
  std::filesystem::path file;
  project::Overrides overrides;
  project::Reading reading;

  /// Throws BadInput.
  GivenProject(std::string text, std::filesystem::path file, project::Overrides overrides);
  /// The same with more overrides, which go before the earlier ones.
  [[nodiscard]] project::Overrides with(const project::Overrides& more) const;
};

}  // namespace talus::python
