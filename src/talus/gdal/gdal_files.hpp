#pragma once
// Which files of the machine GDAL may touch. A raster or vector file may name others - as sources, overviews,
// sidecars, connections - that its user does not know of; none of them is opened but those that are listed here. For
// files that are built with GDAL only.

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <system_error>

namespace talus {

/// Whether a name is one of GDAL's own file systems: /vsizip/FILE/MEMBER, /vsigzip/FILE, /vsicurl/ADDRESS ...
[[nodiscard]] bool is_name_of_gdal(std::string_view name);

/// Whether it is one that is read: /vsizip/ or /vsigzip/ of a file on the disk.
[[nodiscard]] bool is_archive_name(std::string_view name);

/// The file on the disk in which that lies which a name stands for: the archive of a member, or the file itself.
/// Nothing where there is no such file, where it cannot be looked at (`error`), and where the name is that of another
/// of GDAL's file systems.
[[nodiscard]] std::optional<std::filesystem::path> file_on_disk(const std::filesystem::path& name,
                                                                std::error_code& error);

/// A list of files that may be read, and at most one folder that may be written to. Links are followed: what counts is
/// where a file lies.
class GdalFiles {
 public:
  /// No file at all: for coordinate systems.
  GdalFiles() = default;
  /// That one, and those that belong to it; of a folder, the files in it.
  explicit GdalFiles(const std::filesystem::path& file) { add(file); }
  /// All that lies in a folder or below it, which may be written, too.
  [[nodiscard]] static GdalFiles in_folder(const std::filesystem::path& folder);

  /// The file, and those in its folder whose names begin with its own up to the last dot, and a dot: dem.tif,
  /// dem.tif.aux.xml, dem.tfw, dem.prj. Of an archive all members.
  void add(const std::filesystem::path& file);

  [[nodiscard]] bool may_read(const std::filesystem::path& file) const;
  [[nodiscard]] bool may_write(const std::filesystem::path& file) const;
  /// Whether the names in a folder may be seen.
  [[nodiscard]] bool may_list(const std::filesystem::path& folder) const;

 private:
  void add_one(const std::filesystem::path& file);

  std::set<std::string, std::less<>> files_;  // without links
  std::set<std::string, std::less<>> stems_;  // FOLDER/NAME, to which a dot and more may be added
  std::set<std::string, std::less<>> folders_;
  std::string written_;  // the folder that may be written to, with a slash at its end; empty: none
};

/// While it lives, these are the files that GDAL may touch in this thread. Where none lives, GDAL opens nothing.
class GdalReach {
 public:
  explicit GdalReach(const GdalFiles& files);
  GdalReach(const GdalReach&) = delete;
  GdalReach& operator=(const GdalReach&) = delete;
  ~GdalReach();

 private:
  const GdalFiles* before_;
};

/// Why a file in reach could not be opened though it is there - too many open files, no permission -, which GDAL takes
/// for a file that is missing: "dem.prj: Too many open files". Of this thread, since the last time it was asked for.
[[nodiscard]] std::optional<std::string> failure_of_disk();

/// Puts GDAL's file systems under this guard: the disk as above, /vsimem/, /vsizip/ and /vsigzip/ (whose archives lie
/// on the disk); all others - of networks, standard input, parts of files - open nothing. Once a program.
void guard_gdal_files();

}  // namespace talus
