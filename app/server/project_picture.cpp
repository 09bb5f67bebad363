#include "project_picture.hpp"

#include <fmt/format.h>

#include <chrono>
#include <fstream>
#include <iterator>
#include <mutex>

#include "draft.hpp"
#include "run_folders.hpp"
#include "talus/files/output_file.hpp"

namespace talus::server {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_picture_bytes = 256u << 10u;

fs::path place_of_picture(const Workplace& workplace, const std::string& file) {
  static_cast<void>(workplace.project(file));
  return workplace.at(runs_folder(file)) / ".picture";
}

/// By the first bytes of the file (PNG, third edition, section 5.2; RFC 9649, section 2.4). Empty: another type.
std::string picture_type(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG\r\n\x1a\n")) return "image/png";
  if (bytes.size() > 12 && bytes.starts_with("RIFF") && bytes.substr(8, 4) == "WEBP") return "image/webp";
  return {};
}

bool is_regular(const fs::path& path) {
  std::error_code ignored;
  return fs::symlink_status(path, ignored).type() == fs::file_type::regular;
}

}  // namespace

Answer picture_of(const Workplace& workplace, const std::string& file) {
  const fs::path place = place_of_picture(workplace, file);
  std::error_code error;
  if (!is_regular(place) || fs::file_size(place, error) > most_picture_bytes || error)
    throw Refusal(404, file, "has no picture");
  std::ifstream in(place, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(in), {});
  const std::string type = picture_type(bytes);
  if (type.empty()) throw Refusal(404, file, "has no picture");
  return {.type = type, .body = bytes, .headers = {{"X-Content-Type-Options", "nosniff"}}};
}

void save_picture(const Workplace& workplace, const std::string& file, const httplib::ContentReader& content) {
  const fs::path place = place_of_picture(workplace, file);
  std::string bytes;
  const bool is_whole = content([&](const char* data, std::size_t length) {
    bytes.append(data, length);
    return bytes.size() <= most_picture_bytes;
  });
  if (bytes.size() > most_picture_bytes)
    throw Refusal(413, file, "has too large a picture",
                  fmt::format("at most {} bytes are accepted", most_picture_bytes));
  if (!is_whole) throw Refusal(400, file, "the upload is incomplete");
  if (picture_type(bytes).empty()) throw Refusal(400, file, "has no picture", "expected a PNG or WebP file");
  const std::lock_guard lock(project_writing());
  std::error_code ignored;
  const fs::path project = workplace.project(file);
  if (!fs::exists(project, ignored) && !fs::exists(draft_place(project), ignored))
    throw Refusal(404, file, "there is no such file");
  fs::create_directories(place.parent_path(), ignored);
  OutputFile output(place);
  output.write(bytes);
  output.commit();
}

std::optional<std::int64_t> picture_time(const fs::path& file) {
  const fs::path place = file.parent_path() / "runs" / file.stem() / ".picture";
  if (!is_regular(place)) return std::nullopt;
  std::error_code error;
  const auto time = std::chrono::file_clock::to_sys(fs::last_write_time(place, error));
  if (error) return std::nullopt;
  return std::chrono::floor<std::chrono::milliseconds>(time).time_since_epoch().count();
}

}  // namespace talus::server
