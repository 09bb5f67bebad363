#pragma once
// A picture of a project, as its view was last seen: `.picture` in the folder of its runs, a PNG or WebP file.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "http/router.hpp"
#include "workplace.hpp"

namespace talus::server {

/// Refuses (404) a project without a picture.
[[nodiscard]] Answer picture_of(const Workplace& workplace, const std::string& file);
/// Refuses (413) a large picture, and (400) what is none; (404) one of a project that does not exist.
void save_picture(const Workplace& workplace, const std::string& file, const httplib::ContentReader& content);
/// When the picture of a project was saved [ms since 1970]; nullopt: there is none. `file`: its path.
[[nodiscard]] std::optional<std::int64_t> picture_time(const std::filesystem::path& file);

}  // namespace talus::server
