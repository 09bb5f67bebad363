#pragma once
// The report: one HTML page about one run or two, which opens from disk without a network.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "talus/archive/run_folder.hpp"
#include "talus/core/problems.hpp"

namespace talus {

/// What a page says about observed stops.
struct ReportNotes {
  Problems doubts;                       // about their file
  std::vector<std::string> comparisons;  // the distance of each run from them, a line for each quantity
};

/// What a page says otherwise than the summaries of its runs.
struct ReportChanges {
  nlohmann::ordered_json title_block = nlohmann::ordered_json::object();  // settings of [report], by key
  std::string logo{};                                                     // if the settings have one: a `data:` address
};

/// Writes the page about one or two runs from the files in their folders. The page appears under its name when it is
/// complete. Throws BadInput if a folder cannot be read or the page cannot be written. `summary` is the name of the
/// summaries, which differs while a run is being finished. `observed` is a file of observed stops (observed_stops.hpp)
/// to compare each run with; empty: none. `changes` apply to all runs.
ReportNotes write_report(std::span<const std::filesystem::path> run_folders, const std::filesystem::path& html,
                         const char* summary = "summary.json", const std::filesystem::path& observed = {},
                         const ReportChanges& changes = {});

/// The page as text. The same folders give the same bytes. `observed`: the observed_json() of each run, or empty.
[[nodiscard]] std::string report_page(std::span<const RunFolder> runs,
                                      std::span<const nlohmann::ordered_json> observed = {});

}  // namespace talus
