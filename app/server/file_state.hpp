#pragma once
// Whether a file that was read has changed since.

#include <filesystem>
#include <optional>
#include <string>

namespace talus::server {

/// A text that changes when the file, or one that belongs to it (slope.prj, slope.tif.aux.xml), is written again.
/// nullopt if changes cannot be detected: the file may refer to others.
[[nodiscard]] std::optional<std::string> state_of_file(const std::filesystem::path& file);

}  // namespace talus::server
