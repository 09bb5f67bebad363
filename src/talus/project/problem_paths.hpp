#pragma once
// The settings that problems are about, where whoever found them did not know the project file.

#include <filesystem>
#include <string_view>

#include "talus/core/problems.hpp"

namespace talus::project {

/// Gives problems of a project a path, where they have none: by their line, by the file that they are about, which a
/// setting names, or by the table that they name.
[[nodiscard]] Problems with_paths(const Problems& problems, std::string_view text, const std::filesystem::path& file);

}  // namespace talus::project
