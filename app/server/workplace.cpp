#include "workplace.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>

#include "http/answer.hpp"
#include "talus/core/utf8.hpp"
#include "talus/files/checksum.hpp"
#include "talus/files/output_file.hpp"

namespace talus::server {

namespace {

bool is_below(const std::filesystem::path& folder, const std::filesystem::path& path) {
  const auto [end, ignored] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return end == folder.end();
}

/// A hash of the path and the inode number. The latter differs if the folder is created again, or on another machine.
std::string identity_of(const std::filesystem::path& folder) {
  struct stat status {};
  stat(folder.c_str(), &status);
  return text_of(checksum_of(fmt::format("{} {}", folder.string(), status.st_ino)));
}

}  // namespace

Workplace::Workplace(std::filesystem::path folder)
    : folder_(std::filesystem::canonical(folder)), identity_(identity_of(folder_)) {}

std::filesystem::path Workplace::at(std::string_view name) const {
  const auto refuse = [&](const std::string& why) {
    return Refusal(403, std::string(name), "is not a name in this folder", why);
  };
  if (name.empty()) throw refuse("it is empty");
  if (name.size() > 1000) throw refuse("it is too long");
  const bool has_control = std::any_of(name.begin(), name.end(), [](unsigned char c) { return c < 32 || c == 127; });
  if (has_control) throw refuse("it has control characters");
  const std::filesystem::path relative(name);
  if (relative.is_absolute()) throw refuse("it is absolute");
  for (const std::filesystem::path& part : relative) {
    if (part == "..") throw refuse("it leads out of the folder");
    if (part.string().starts_with('.')) throw refuse("it begins with a dot");
  }
  const std::filesystem::path whole = folder_ / relative;
  std::error_code error;
  const std::filesystem::path real = std::filesystem::weakly_canonical(whole, error);
  if (error == std::errc::filename_too_long) throw refuse("it is too long");
  if (error) throw refuse(error.message());
  if (!is_below(folder_, real)) throw refuse("it leads out of the folder");
  return whole;
}

std::filesystem::path Workplace::existing(std::string_view name) const {
  std::filesystem::path path = at(name);
  std::error_code error;
  if (!std::filesystem::exists(path, error)) throw Refusal(404, std::string(name), "there is no such file");
  return path;
}

std::filesystem::path Workplace::project(std::string_view name) const {
  std::filesystem::path path = at(name);
  if (path.extension() != ".toml")
    throw Refusal(400, std::string(name), "is not a project file", "its name does not end in .toml");
  return path;
}

std::filesystem::path Workplace::written(const std::filesystem::path& file) const {
  const std::filesystem::path place = place_of_file(file);
  std::error_code error;
  const std::filesystem::path real = std::filesystem::weakly_canonical(place, error);
  if (error || !is_below(folder_, real))
    throw Refusal(403, file.lexically_relative(folder_).string(), "cannot be written", "it leads out of the folder");
  return place;
}

}  // namespace talus::server
