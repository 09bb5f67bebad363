#pragma once
// Which files GDAL may access. A raster or vector file may refer to others - as sources, overviews, sidecars or
// connections - without the user's knowledge; only those listed here are opened. Only for files that are built with
// GDAL.

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <system_error>

namespace talus {

/// Whether a name is in one of GDAL's virtual file systems: /vsizip/FILE/MEMBER, /vsigzip/FILE, /vsicurl/ADDRESS ...
[[nodiscard]] bool is_name_of_gdal(std::string_view name);

/// Whether it is in one that Talus reads: /vsizip/ or /vsigzip/ of a file on disk.
[[nodiscard]] bool is_archive_name(std::string_view name);

/// The file on disk that contains what a name refers to: the archive of a member, or the file itself. nullopt if there
/// is no such file, if it cannot be accessed (`error`), or if the name is in another of GDAL's file systems.
[[nodiscard]] std::optional<std::filesystem::path> file_on_disk(const std::filesystem::path& name,
                                                                std::error_code& error);

/// The files that may be read, and at most one folder that may be written to. Links are resolved: the place of the
/// target decides.
class GdalFiles {
 public:
  /// No files at all: enough for coordinate systems.
  GdalFiles() = default;
  /// That file and those that belong to it; for a folder, the files in it.
  explicit GdalFiles(const std::filesystem::path& file) { add(file); }
  /// All files in a folder or below it, which may be written, too.
  [[nodiscard]] static GdalFiles in_folder(const std::filesystem::path& folder);

  /// Adds the file, and those in its folder whose names begin with its stem and a dot: dem.tif, dem.tif.aux.xml,
  /// dem.tfw, dem.prj. For an archive, all members. Only ordinary files and folders: to GDAL, pipes, devices and links
  /// to them do not exist, since reading them may never end.
  void add(const std::filesystem::path& file);

  [[nodiscard]] bool may_read(const std::filesystem::path& file) const;
  [[nodiscard]] bool may_write(const std::filesystem::path& file) const;
  /// Whether the names in a folder may be listed.
  [[nodiscard]] bool may_list(const std::filesystem::path& folder) const;

 private:
  void add_one(const std::filesystem::path& file);

  std::set<std::string, std::less<>> files_;  // links resolved
  std::set<std::string, std::less<>> stems_;  // FOLDER/STEM of the files FOLDER/STEM.*
  std::set<std::string, std::less<>> folders_;
  std::string written_;  // the folder that may be written to, with a final slash; empty: none
};

/// During its lifetime, GDAL may access these files in this thread. Without one, GDAL opens nothing.
class GdalReach {
 public:
  explicit GdalReach(const GdalFiles& files);
  GdalReach(const GdalReach&) = delete;
  GdalReach& operator=(const GdalReach&) = delete;
  ~GdalReach();

 private:
  const GdalFiles* before_;
};

/// Why an existing file in reach could not be opened (too many open files, no permission), which GDAL treats as a
/// missing file: "dem.prj: Too many open files". The first such failure in this thread since the last call.
[[nodiscard]] std::optional<std::string> failure_of_disk();

/// Whether GDAL is shared with other code, and it is that code, not Talus, that uses it in this thread.
[[nodiscard]] bool others_use_gdal();

/// Restricts GDAL's file systems: the disk as above; /vsimem/, /vsizip/ and /vsigzip/ (whose archives are on disk)
/// work; all others - networks, standard input, parts of files - open nothing. To be called once per program. If GDAL
/// `is_shared` with other code of the process, threads without a GdalReach are that code's, and not restricted.
void guard_gdal_files(bool is_shared);

}  // namespace talus
