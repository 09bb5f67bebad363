#pragma once
// Input files must be ordinary files: reading a pipe without a writer would wait forever.

#include <filesystem>
#include <optional>
#include <string>

namespace talus {

/// Why a path is not an ordinary file: "it is a folder", "it is a pipe". nullopt if it is one, does not exist or cannot
/// be accessed (opening it reports the reason).
[[nodiscard]] std::optional<std::string> not_an_ordinary_file(const std::filesystem::path& path);

}  // namespace talus
