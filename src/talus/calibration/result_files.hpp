#pragma once
// The folder of a calibration: the posterior, all sets, the best fit as projects, a summary and a report.

#include <atomic>
#include <filesystem>
#include <functional>

#include "talus/calibration/calibrate.hpp"

namespace talus::calibration {

struct FolderOptions {
  int threads = 0;
  /// As in CalibrationOptions.
  std::function<void(std::size_t done, std::size_t all)> progress{};
  std::function<void(const std::string& what)> phase{};
};

/// Calibrates into a folder. Sets that an earlier calibration of the same study simulated there are not simulated
/// again; those of another study are removed. After a stop (Stopped is thrown) finished sets are kept. Throws BadInput
/// if the folder cannot be written to, or another program writes to it.
[[nodiscard]] CalibrationResult calibrate_into(const std::filesystem::path& folder, const PreparedStudy& study,
                                               const FolderOptions& options);

/// Writes all files but the finished sets. Each appears under its name when it is complete.
void write_results(const std::filesystem::path& folder, const PreparedStudy& study, const CalibrationResult& result);

/// posterior.csv: a row for each set with a weight. Columns: `weight` (they add up to 1), `score`, and a column for
/// each parameter, named by its path, or by `PATH@SITE` where each site has its own.
[[nodiscard]] std::string posterior_table(const PreparedStudy& study, const CalibrationResult& result);
/// sets.csv: the same for all sets, with their round, logarithm of the likelihood, and whether they agree.
[[nodiscard]] std::string sets_table(const PreparedStudy& study, const CalibrationResult& result);

/// The text of a site's project file with these values, to be kept in `folder`: file names are relative to it.
[[nodiscard]] std::string project_with(const PreparedStudy& study, std::size_t site, const study::ParameterSet& values,
                                       const std::filesystem::path& folder);

}  // namespace talus::calibration
