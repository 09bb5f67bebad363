#pragma once
// Assigns settings to problems that were found without knowledge of the project file.

#include <filesystem>
#include <string_view>

#include "talus/core/problems.hpp"

namespace talus::project {

/// Sets the path of problems that have none: by their line, by their file if a setting names it, or by the table that
/// they name.
[[nodiscard]] Problems with_paths(const Problems& problems, std::string_view text, const std::filesystem::path& file);

}  // namespace talus::project
