#ifdef TALUS_HAS_GDAL

#include "talus/gdal/proj_files.hpp"

#include <dlfcn.h>
#include <proj.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "talus/gdal/gdal_files.hpp"

namespace talus {

namespace {

namespace fs = std::filesystem;

/// Where PROJ looks for its data.
std::vector<std::string> searched_by_proj() {
  std::vector<std::string> places;
  std::string_view rest = proj_info().searchpath;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(':'), rest.size());
    places.emplace_back(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return places;
}

/// These places as they exist, without links.
const std::vector<fs::path>& folders_of_proj() {
  static const std::vector<fs::path> folders = [] {
    std::vector<fs::path> found;
    for (const std::string& place : searched_by_proj()) {
      std::error_code error;
      const fs::path folder = fs::canonical(place, error);
      if (!error) found.push_back(folder);
    }
    return found;
  }();
  return folders;
}

/// The archive of the program has PROJ's data next to PROJ's library (packaging/bundle). The two belong together: those
/// that the environment or the system names may be of another version, and come after.
void prefer_bundled_data() {
  Dl_info library{};
  if (dladdr(reinterpret_cast<const void*>(&proj_info), &library) == 0 || library.dli_fname == nullptr) return;
  const fs::path data = fs::path(library.dli_fname).parent_path() / "proj";
  std::error_code ignored;
  if (!fs::exists(data / "proj.db", ignored)) return;
  std::vector<std::string> places = searched_by_proj();
  places.insert(places.begin(), data.string());
  std::vector<const char*> names;
  for (const std::string& place : places) names.push_back(place.c_str());
  proj_context_set_search_paths(nullptr, static_cast<int>(names.size()), names.data());
}

bool is_ordinary_file_of_proj(const char* name) {
  std::error_code error;
  const fs::path file = fs::canonical(name, error);  // the target of a link decides
  if (error || !fs::is_regular_file(file, error)) return false;
  return std::ranges::any_of(folders_of_proj(), [&](const fs::path& folder) {
    return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
  });
}

std::FILE* file_of(PROJ_FILE_HANDLE* handle) { return reinterpret_cast<std::FILE*>(handle); }

PROJ_FILE_HANDLE* open_for_proj(PJ_CONTEXT*, const char* name, PROJ_OPEN_ACCESS access, void*) {
  const bool is_read = access == PROJ_OPEN_ACCESS_READ_ONLY;
  if (!others_use_gdal() && (!is_read || !is_ordinary_file_of_proj(name))) return nullptr;
  const char* const how = is_read ? "rb" : access == PROJ_OPEN_ACCESS_READ_UPDATE ? "r+b" : "w+b";
  return reinterpret_cast<PROJ_FILE_HANDLE*>(std::fopen(name, how));
}
std::size_t read_for_proj(PJ_CONTEXT*, PROJ_FILE_HANDLE* file, void* to, std::size_t bytes, void*) {
  return std::fread(to, 1, bytes, file_of(file));
}
std::size_t write_for_proj(PJ_CONTEXT*, PROJ_FILE_HANDLE* file, const void* from, std::size_t bytes, void*) {
  return std::fwrite(from, 1, bytes, file_of(file));
}
int seek_for_proj(PJ_CONTEXT*, PROJ_FILE_HANDLE* file, long long by, int from, void*) {
  return fseeko(file_of(file), by, from) == 0 ? 1 : 0;
}
unsigned long long tell_proj(PJ_CONTEXT*, PROJ_FILE_HANDLE* file, void*) {
  return static_cast<unsigned long long>(ftello(file_of(file)));
}
void close_for_proj(PJ_CONTEXT*, PROJ_FILE_HANDLE* file, void*) { std::fclose(file_of(file)); }
int exists_for_proj(PJ_CONTEXT*, const char* name, void*) {
  std::error_code ignored;
  return (others_use_gdal() ? fs::exists(name, ignored) : is_ordinary_file_of_proj(name)) ? 1 : 0;
}
int make_folder_for_proj(PJ_CONTEXT*, const char* name, void*) {
  std::error_code error;
  return others_use_gdal() && (fs::create_directory(name, error), !error) ? 1 : 0;
}
int remove_for_proj(PJ_CONTEXT*, const char* name, void*) {
  std::error_code error;
  return others_use_gdal() && fs::remove(name, error) ? 1 : 0;
}
int rename_for_proj(PJ_CONTEXT*, const char* from, const char* to, void*) {
  std::error_code error;
  return others_use_gdal() && (fs::rename(from, to, error), !error) ? 1 : 0;
}

/// PROJ asks this for its own files, the first of which is its database. It answers nothing, and gives the context
/// functions of ours to open files with.
const char* guard_context(PJ_CONTEXT* context, const char*, void*) {
  static const PROJ_FILE_API guarded{.version = 1,
                                     .open_cbk = &open_for_proj,
                                     .read_cbk = &read_for_proj,
                                     .write_cbk = &write_for_proj,
                                     .seek_cbk = &seek_for_proj,
                                     .tell_cbk = &tell_proj,
                                     .close_cbk = &close_for_proj,
                                     .exists_cbk = &exists_for_proj,
                                     .mkdir_cbk = &make_folder_for_proj,
                                     .unlink_cbk = &remove_for_proj,
                                     .rename_cbk = &rename_for_proj};
  proj_context_set_fileapi(context, &guarded, nullptr);
  return nullptr;
}

}  // namespace

void guard_proj_files() {
  prefer_bundled_data();
  (void)folders_of_proj();
  // GDAL has a context of its own for each thread. These copy the finder of the default context, but not its functions
  // for files.
  proj_context_set_file_finder(nullptr, &guard_context, nullptr);
}

}  // namespace talus

#endif
