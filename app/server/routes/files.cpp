#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>

#include "project_picture.hpp"
#include "routes/routes.hpp"
#include "talus/files/file_formats.hpp"
#include "talus/files/output_file.hpp"

namespace talus::server {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_listed = 2'000;  // files in the list

std::string_view kind_of(const fs::path& file) {
  if (file.filename().string().ends_with(study_ending)) return "study";
  if (file.filename().string().ends_with(".materials.toml")) return "materials";
  if (ending_of(file) == ".toml") return "project";
  const FileFormat* format = format_of(file);
  return format ? name_of(format->kind) : "other";
}

/// Folders of results contain no input; the server lists its runs separately.
bool is_of_results(const fs::path& folder) {
  std::error_code ignored;
  return fs::exists(folder / "summary.json", ignored) || fs::exists(folder / "run.json", ignored);
}

struct Listing {
  Json files = Json::array();
  Json drafts = Json::array();  // projects with a draft
  bool is_cut = false;
};

Listing listing(const Workplace& workplace) {
  Listing found;
  auto& [files, drafts, is_cut] = found;
  std::error_code error;
  auto entry =
      fs::recursive_directory_iterator(workplace.folder(), fs::directory_options::skip_permission_denied, error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    const fs::path& path = entry->path();
    std::error_code ignored;
    const bool is_hidden = path.filename().string().starts_with('.');
    if (entry->is_directory(ignored)) {
      if (is_hidden || entry.depth() >= deepest_project || is_of_results(path) || path.filename() == "node_modules")
        entry.disable_recursion_pending();
      continue;
    }
    if (!entry->is_regular_file(ignored)) continue;
    if (is_hidden && path.extension() == ".draft") {
      const std::string name = path.stem().string().substr(1);
      drafts.push_back((path.parent_path() / name).lexically_relative(workplace.folder()).generic_string());
    }
    if (is_hidden) continue;
    if (files.size() == most_listed) {
      is_cut = true;
      break;
    }
    const std::string_view kind = kind_of(path);
    const auto modified = std::chrono::file_clock::to_sys(entry->last_write_time(ignored));
    files.push_back({{"name", path.lexically_relative(workplace.folder()).generic_string()},
                     {"bytes", entry->file_size(ignored)},
                     {"modified", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}",
                                              std::chrono::time_point_cast<std::chrono::seconds>(modified))},
                     {"kind", kind}});
    if (kind == "project") {
      const auto picture = picture_time(path);
      files.back()["picture"] = picture ? Json(*picture) : Json();
    }
  }
  std::sort(files.begin(), files.end(), [](const Json& a, const Json& b) { return a["name"] < b["name"]; });
  std::sort(drafts.begin(), drafts.end());
  return found;
}

/// The temporary file of an upload. Its name is unique, so that concurrent uploads of one file do not mix.
fs::path part_of(const fs::path& path) {
  static std::atomic<unsigned> uploads{0};
  return path.parent_path() / fmt::format(".{}.{}-{}.part", path.filename().string(), getpid(), ++uploads);
}

Answer save_upload(const httplib::Request& request, const httplib::ContentReader& content, const Workplace& workplace,
                   std::uint64_t most_bytes) {
  const std::string name = request.matches[1].str();
  const fs::path path = workplace.at(name);
  const auto check_place = [&] {
    std::error_code ignored;
    if (fs::exists(path, ignored) && request.get_param_value("replace") != "1")
      throw Refusal(409, name, "already exists");
  };
  const auto too_large = [&] {
    return Refusal(413, name, "is too large", fmt::format("at most {} bytes are accepted", most_bytes));
  };
  check_place();
  if (request.get_header_value<std::uint64_t>("Content-Length") > most_bytes) throw too_large();
  std::error_code ignored;
  fs::create_directories(path.parent_path(), ignored);
  OutputFile file(path, part_of(path));
  std::uint64_t bytes = 0;
  const bool is_whole = content([&](const char* data, std::size_t length) {
    bytes += length;
    if (bytes > most_bytes) return false;
    file.write({data, length});
    return true;
  });
  if (bytes > most_bytes) throw too_large();
  if (!is_whole) throw Refusal(400, name, "the upload is incomplete");
  // Check and rename in one step: uploads of the same name may end at the same time.
  static std::mutex ending;
  const std::lock_guard lock(ending);
  check_place();
  file.commit();
  return json_answer({{"name", name}, {"bytes", bytes}}, 201);
}

}  // namespace

void add_file_routes(Router& router, const Workplace& workplace) {
  router.get("/api/files", [&workplace](const Call&) {
    Listing found = listing(workplace);
    return json_answer(
        {{"files", std::move(found.files)}, {"drafts", std::move(found.drafts)}, {"more", found.is_cut}});
  });
  router.upload(R"(/api/files/(.+))", [&](const httplib::Request& request, const httplib::ContentReader& content) {
    return save_upload(request, content, workplace, router.limits().upload_bytes);
  });
}

}  // namespace talus::server
