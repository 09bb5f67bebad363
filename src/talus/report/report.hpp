#pragma once
// The report: one HTML page about one run, or about two laid over each other, that opens from disk without a network.

#include <filesystem>
#include <span>
#include <string>

#include "talus/archive/run_folder.hpp"

namespace talus {

/// Writes the page about one or two runs, made from nothing but the files in their folders. The page appears under its
/// name only when it is whole. Throws BadInput on folders that cannot be read and on a page that cannot be written.
/// `summary` is the name of the summaries, of which one that is being made has another.
void write_report(std::span<const std::filesystem::path> run_folders, const std::filesystem::path& html,
                  const char* summary = "summary.json");

/// The page's text. The same folders give the same text, byte for byte.
[[nodiscard]] std::string report_page(std::span<const RunFolder> runs);

}  // namespace talus
