#pragma once
// The model of a project's text, or of a run.

#include <filesystem>
#include <string_view>

#include "http/answer.hpp"
#include "talus/campaign/model.hpp"
#include "talus/project/project.hpp"
#include "talus/project/read.hpp"

namespace talus::server {

struct BuiltProject {
  project::Project project;
  Model model;
  Problems warnings;
};

/// From a text that stands for a file. Throws BadInput with all problems.
[[nodiscard]] BuiltProject build(std::string_view text, const std::filesystem::path& file,
                                 const project::Overrides& overrides);

/// Problems that name files of the folder as they are called there.
[[nodiscard]] Problems seen_from(const std::filesystem::path& folder, const Problems& problems);

}  // namespace talus::server
