#pragma once
// What the readers of rasters share: GDAL without a word on the terminal, a file opened or refused, and command lines
// for the user to copy. For files that are built with GDAL only.

#include <gdal_priv.h>

#include <filesystem>
#include <string>
#include <string_view>

#include "talus/core/problems.hpp"
#include "talus/gdal/gdal_files.hpp"

namespace talus {

/// While it lives, GDAL's messages of this thread come here and nowhere else, and GDAL touches no files in this thread
/// but those in reach.
class GdalMessages {
 public:
  explicit GdalMessages(GdalFiles files = {});
  GdalMessages(const GdalMessages&) = delete;
  GdalMessages& operator=(const GdalMessages&) = delete;
  ~GdalMessages();

  /// What is in reach.
  [[nodiscard]] GdalFiles& files() { return files_; }
  /// Forgets what failed so far.
  void clear() { failure_.clear(); }
  [[nodiscard]] bool has_failure() const { return !failure_.empty(); }
  /// What failed first, in GDAL's words, in one line.
  [[nodiscard]] std::string failure() const;

 private:
  static void note(CPLErr severity, CPLErrorNum number, const char* message);
  GdalFiles files_;
  GdalReach reach_{files_};
  std::string failure_;
};

/// A word that a shell reads back as this text.
[[nodiscard]] std::string shell_word(const std::string& text);

/// What is wrong with one raster: collected, so that the user sees all of it at once.
class RasterProblems {
 public:
  explicit RasterProblems(std::filesystem::path file) : file_(std::move(file)) {}

  void refuse(std::string what, std::string why, std::string hint = "");
  /// Refuses what leaves nothing else to be said, and throws BadInput with all that was found.
  [[noreturn]] void stop(std::string what, std::string why, std::string hint = "");
  void warn(std::string what, std::string why, std::string hint = "");
  /// Throws BadInput where there was a refusal.
  void throw_if_any() const;

  /// `before FILE FILE_ending`, the file's name and that of a new one beside it in a form that a shell reads.
  [[nodiscard]] std::string command(std::string_view before, std::string_view ending) const;
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  [[nodiscard]] const Problems& warnings() const { return warnings_; }

 private:
  std::filesystem::path file_;
  Problems refusals_;
  Problems warnings_;
};

/// Opens a raster with at least one band to read from. Throws BadInput.
[[nodiscard]] GDALDatasetUniquePtr open_raster(GdalMessages& messages, RasterProblems& problems);

/// Warns where a raster has bands beyond the first, which alone is read; one that is a mask is no such band.
void warn_of_further_bands(GDALDataset& dataset, RasterProblems& problems);

/// Where the cells of a file lie: GDAL's six numbers, of which x = [0] + [1] column + [2] row and
/// y = [3] + [4] column + [5] row, counted from a corner of the first cell. Complains and gives false where a file has
/// none, or where its cells have no area.
[[nodiscard]] bool read_geotransform(GDALDataset& dataset, double (&geotransform)[6], RasterProblems& problems);

}  // namespace talus
