#ifdef TALUS_HAS_GDAL

#include "talus/gdal/gdal_files.hpp"

#include <cpl_string.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <memory>
#include <system_error>
#include <utility>
#include <vector>

#include "talus/files/ordinary_file.hpp"
#include "talus/gdal/gdal_handlers.hpp"

namespace talus {

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 2> archives{"/vsizip/", "/vsigzip/"};
constexpr std::string_view in_memory = "/vsimem/";

/// The files that this thread may access; null: none.
thread_local const GdalFiles* reach = nullptr;

/// Without links, dots and a final slash; for a path that does not exist, as far as it exists.
fs::path real(const fs::path& path) {
  std::error_code error;
  fs::path whole = fs::absolute(path, error);
  if (error) return {};
  if (!whole.has_filename()) whole = whole.parent_path();
  const fs::path found = fs::weakly_canonical(whole, error);
  return error ? fs::path() : found;
}

std::string stem_of(const fs::path& file) { return (file.parent_path() / file.stem()).string(); }

/// FILE/MEMBER of /vsizip/FILE/MEMBER; nullopt if the name, or FILE, belongs to another of GDAL's file systems.
std::optional<std::string> within_archive(std::string_view name) {
  for (const std::string_view kind : archives) {
    if (!name.starts_with(kind)) continue;
    const std::string within(name.substr(kind.size()));
    return is_name_of_gdal(within) ? std::nullopt : std::optional(within);
  }
  return std::nullopt;
}

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

bool is_regular(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

}  // namespace

bool is_name_of_gdal(std::string_view name) { return name.starts_with("/vsi"); }

bool is_archive_name(std::string_view name) { return within_archive(name).has_value(); }

std::optional<fs::path> file_on_disk(const fs::path& name, std::error_code& error) {
  const std::string text = name.string();
  if (!is_name_of_gdal(text)) return fs::exists(name, error) ? std::optional(name) : std::nullopt;
  const auto within = within_archive(text);
  if (!within) return std::nullopt;
  fs::path file;
  for (const fs::path& part : fs::path(*within)) {
    file /= part;
    if (is_regular(file)) return file;
  }
  return std::nullopt;
}

GdalFiles GdalFiles::in_folder(const fs::path& folder) {
  GdalFiles files;
  files.written_ = real(folder.empty() ? "." : folder).string();
  if (!files.written_.ends_with('/')) files.written_ += '/';
  return files;
}

void GdalFiles::add_one(const fs::path& file) {
  // Sidecar files may be next to a link or next to its target.
  for (const fs::path& place :
       {real(file.parent_path().empty() ? "." : file.parent_path()) / file.filename(), real(file)}) {
    stems_.insert(stem_of(place));
    folders_.insert(place.parent_path().string());
  }
  files_.insert(real(file).string());
}

void GdalFiles::add(const fs::path& name) {
  std::error_code error;
  const std::optional<fs::path> file = file_on_disk(name, error);
  if (!file) return;
  if (!fs::is_directory(*file, error)) {
    add_one(*file);
    return;
  }
  const fs::path folder = real(*file);
  folders_.insert(folder.string());
  for (auto entry = fs::directory_iterator(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    std::error_code ignored;
    if (entry->is_regular_file(ignored) && !entry->is_symlink(ignored)) files_.insert(entry->path().string());
  }
}

bool GdalFiles::may_read(const fs::path& file) const {
  const fs::path place = real(file);
  const std::string name = place.string();
  if (name.empty() || (not_an_ordinary_file(place) && !is_folder(place))) return false;
  if (!written_.empty() && name.starts_with(written_)) return true;
  if (files_.contains(name)) return true;
  const std::size_t begin = name.rfind('/') + 1;
  for (std::size_t dot = name.find('.', begin); dot != std::string::npos; dot = name.find('.', dot + 1)) {
    if (stems_.contains(std::string_view(name).substr(0, dot))) return true;
  }
  return may_list(place);  // metadata of a folder, not the contents of its files
}

bool GdalFiles::may_write(const fs::path& file) const {
  return !written_.empty() && real(file).string().starts_with(written_);
}

bool GdalFiles::may_list(const fs::path& folder) const {
  const std::string name = real(folder).string();
  return folders_.contains(name) || (!written_.empty() && (name + '/').starts_with(written_));
}

namespace {
bool is_shared_with_others = false;
}  // namespace

bool others_use_gdal() { return reach == nullptr && is_shared_with_others; }

GdalReach::GdalReach(const GdalFiles& files) : before_(std::exchange(reach, &files)) {}
GdalReach::~GdalReach() { reach = before_; }

namespace {

thread_local std::optional<std::string> failure;

bool refused(int error) {
  errno = error;
  return false;
}

bool may_read(const char* name) {
  return others_use_gdal() || (reach != nullptr && reach->may_read(name)) || refused(ENOENT);
}
bool may_list(const char* name) {
  return others_use_gdal() || (reach != nullptr && reach->may_list(name)) || refused(ENOENT);
}
bool may_write(const char* name) {
  return others_use_gdal() || (reach != nullptr && reach->may_write(name)) || refused(EACCES);
}

/// The names in a folder, as GDAL lists them, but those of pipes and devices.
char** without_special_files(const char* folder, char** names) {
  if (names == nullptr || others_use_gdal()) return names;
  std::set<std::string, std::less<>> special;
  std::error_code error;
  for (auto entry = fs::directory_iterator(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    std::error_code ignored;
    if (!entry->is_regular_file(ignored) && !entry->is_directory(ignored)) special.insert(entry->path().filename());
  }
  if (special.empty()) return names;
  const CPLStringList all(names);
  CPLStringList kept;
  for (int k = 0; k < all.size(); ++k) {
    if (!special.contains(std::string_view(all[k]))) kept.AddString(all[k]);
  }
  return kept.StealList();
}

/// The file system of the disk, restricted to the files in reach.
class GuardedDisk final : public VSIFilesystemHandler {
 public:
  explicit GuardedDisk(VSIFilesystemHandler* disk) : disk_(disk) {}

  using VSIFilesystemHandler::Open;
  OpenedByGdal Open(const char* name, const char* how, bool says_errors, CSLConstList options) override {
    const bool is_written = std::string_view(how).find_first_of("wa+") != std::string_view::npos;
    if (is_written ? !may_write(name) : !may_read(name)) return nullptr;
    OpenedByGdal file = disk_->Open(name, how, says_errors, options);
    if (file == nullptr && errno != ENOENT && errno != ENOTDIR && !failure) {
      failure = std::string(name) + ": " + std::strerror(errno);
    }
    return file;
  }
  int Stat(const char* name, VSIStatBufL* found, int flags) override {
    return may_read(name) ? disk_->Stat(name, found, flags) : -1;
  }
  int Unlink(const char* name) override { return may_write(name) ? disk_->Unlink(name) : -1; }
  int Mkdir(const char* name, long mode) override { return may_write(name) ? disk_->Mkdir(name, mode) : -1; }
  int Rmdir(const char* name) override { return may_write(name) ? disk_->Rmdir(name) : -1; }
#if GDAL_VERSION_NUM >= GDAL_COMPUTE_VERSION(3, 11, 0)
  int Rename(const char* from, const char* to, GDALProgressFunc progress, void* of_progress) override {
    return may_write(from) && may_write(to) ? disk_->Rename(from, to, progress, of_progress) : -1;
  }
#else
  int Rename(const char* from, const char* to) override {
    return may_write(from) && may_write(to) ? disk_->Rename(from, to) : -1;
  }
#endif
  char** ReadDirEx(const char* name, int most) override {
    return may_list(name) ? without_special_files(name, disk_->ReadDirEx(name, most)) : nullptr;
  }
  int IsCaseSensitive(const char* name) override { return disk_->IsCaseSensitive(name); }
  GIntBig GetDiskFreeSpace(const char* name) override { return disk_->GetDiskFreeSpace(name); }
  int SupportsSparseFiles(const char* name) override { return disk_->SupportsSparseFiles(name); }

 private:
  VSIFilesystemHandler* disk_;
};

/// Replaces a file system of GDAL that may not be used, but by others (may be null).
class NoFiles final : public VSIFilesystemHandler {
 public:
  explicit NoFiles(VSIFilesystemHandler* of_others) : of_others_(of_others) {}

  using VSIFilesystemHandler::Open;
  OpenedByGdal Open(const char* name, const char* how, bool says_errors, CSLConstList options) override {
    return is_open() ? of_others_->Open(name, how, says_errors, options) : nullptr;
  }
  int Stat(const char* name, VSIStatBufL* found, int flags) override {
    return is_open() ? of_others_->Stat(name, found, flags) : -1;
  }
  int Unlink(const char* name) override { return is_open() ? of_others_->Unlink(name) : -1; }
  char** ReadDirEx(const char* name, int most) override {
    return is_open() ? of_others_->ReadDirEx(name, most) : nullptr;
  }

 private:
  [[nodiscard]] bool is_open() const { return (of_others_ != nullptr && others_use_gdal()) || refused(ENOENT); }
  VSIFilesystemHandler* of_others_;
};

}  // namespace

std::optional<std::string> failure_of_disk() { return std::exchange(failure, std::nullopt); }

void guard_gdal_files(bool is_shared) {
  is_shared_with_others = is_shared;
  const CPLStringList known(VSIFileManager::GetPrefixes());
  std::vector<std::string> prefixes{"/vsicurl?"};  // GetPrefixes does not list this one
  for (int i = 0; i < known.size(); ++i) prefixes.emplace_back(known[i]);
  for (const std::string& prefix : prefixes) {
    if (prefix == in_memory || std::ranges::find(archives, prefix) != archives.end()) continue;
    install_gdal_handler(prefix, std::make_unique<NoFiles>(VSIFileManager::GetHandler(prefix.c_str())));
  }
  install_gdal_handler("", std::make_unique<GuardedDisk>(VSIFileManager::GetHandler("")));
}

}  // namespace talus

#endif
