#pragma once
// Shared by the readers of GDAL's files: GDAL's messages kept off the terminal, opening a raster or refusing it, and
// commands for the user to copy. Only for files that are built with GDAL.

#include <gdal_priv.h>

#include <filesystem>
#include <string>
#include <string_view>

#include "talus/core/problems.hpp"
#include "talus/gdal/gdal_files.hpp"
#include "talus/gdal/gdal_start.hpp"

namespace talus {

/// During its lifetime, collects GDAL's messages of this thread, and restricts GDAL in this thread to the files in
/// reach.
class GdalMessages {
 public:
  explicit GdalMessages(GdalFiles files = {});
  GdalMessages(const GdalMessages&) = delete;
  GdalMessages& operator=(const GdalMessages&) = delete;
  ~GdalMessages();

  /// The files in reach.
  [[nodiscard]] GdalFiles& files() { return files_; }
  /// The limit of the queries that GDAL makes for them.
  [[nodiscard]] QueryLimit& queries() { return queries_; }
  /// Discards the failures so far.
  void clear() { failure_.clear(); }
  [[nodiscard]] bool has_failure() const { return !failure_.empty(); }
  /// GDAL's message about the first failure, in one line.
  [[nodiscard]] std::string failure() const;

 private:
  static void note(CPLErr severity, CPLErrorNum number, const char* message);
  GdalFiles files_;
  GdalReach reach_{files_};
  QueryLimit queries_;
  std::string failure_;
};

/// The text quoted for a shell.
[[nodiscard]] std::string shell_word(const std::string& text);

/// The errors and warnings of one file, collected so that the user sees all of them at once.
class RasterProblems {
 public:
  explicit RasterProblems(std::filesystem::path file) : file_(std::move(file)) {}

  void refuse(std::string what, std::string why, std::string hint = "");
  /// Adds an error after which reading cannot continue, and throws BadInput with all errors.
  [[noreturn]] void stop(std::string what, std::string why, std::string hint = "");
  void warn(std::string what, std::string why, std::string hint = "");
  /// Throws BadInput if there are errors.
  void throw_if_any() const;

  /// `before FILE FILE_ending`: a command with the file's name and that of a new one next to it, quoted for a shell.
  [[nodiscard]] std::string command(std::string_view before, std::string_view ending) const;
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  [[nodiscard]] const Problems& warnings() const { return warnings_; }

 private:
  std::filesystem::path file_;
  Problems refusals_;
  Problems warnings_;
};

/// Opens a raster with at least one band for reading. Throws BadInput.
[[nodiscard]] GDALDatasetUniquePtr open_raster(GdalMessages& messages, RasterProblems& problems,
                                               GdalKind kind = GdalKind::raster);

/// Warns if a raster has several bands, of which only the first is read; a mask does not count.
void warn_of_further_bands(GDALDataset& dataset, RasterProblems& problems);

/// The position of the cells, as GDAL's six numbers: x = [0] + [1] column + [2] row and y = [3] + [4] column + [5] row,
/// with columns and rows from the corner of the first cell. Adds an error and returns false if the file has none, or if
/// its cells have no area.
[[nodiscard]] bool read_geotransform(GDALDataset& dataset, double (&geotransform)[6], RasterProblems& problems);

}  // namespace talus
