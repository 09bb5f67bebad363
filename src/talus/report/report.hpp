#pragma once
// The report: one HTML page about one run or two, which opens from disk without a network.

#include <filesystem>
#include <span>
#include <string>

#include "talus/archive/run_folder.hpp"

namespace talus {

/// Writes the page about one or two runs from the files in their folders. The page appears under its name when it is
/// complete. Throws BadInput if a folder cannot be read or the page cannot be written. `summary` is the name of the
/// summaries, which differs while a run is being finished.
void write_report(std::span<const std::filesystem::path> run_folders, const std::filesystem::path& html,
                  const char* summary = "summary.json");

/// The page as text. The same folders give the same bytes.
[[nodiscard]] std::string report_page(std::span<const RunFolder> runs);

}  // namespace talus
