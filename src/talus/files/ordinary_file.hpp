#pragma once
// Files that are read to their end must have one: a pipe that nobody writes to would be waited for.

#include <filesystem>
#include <optional>
#include <string>

namespace talus {

/// Why a path is not that of an ordinary file: "it is a folder", "it is a pipe". Nothing where it is one, and where
/// there is nothing of that name or nothing is known of it, of which opening it says more.
[[nodiscard]] std::optional<std::string> not_an_ordinary_file(const std::filesystem::path& path);

}  // namespace talus
