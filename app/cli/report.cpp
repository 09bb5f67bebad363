#include "talus/report/report.hpp"

#include <fmt/format.h>

#include <optional>

#include "commands.hpp"
#include "earlier_output.hpp"
#include "load.hpp"
#include "talus/files/file_record.hpp"
#include "talus/files/folder_lock.hpp"
#include "talus/files/output_file.hpp"

namespace talus::cli {

int report(const ReportOptions& options) {
  const char* page = options.folders.size() > 1 ? "compare.html" : "report.html";
  const std::filesystem::path file = options.file.empty() ? options.folders.front() / page : options.file;
  (void)place_of_file(file);
  refuse_other_files(file, "<!DOCTYPE html>", "page");
  std::optional<FolderLock> lock;  // a run into this folder may be in progress
  if (options.file.empty()) lock.emplace(lock_output_folder(options.folders.front()));
  const ReportNotes notes = write_report(options.folders, file, "summary.json", options.observed);
  print_warnings(notes.doubts);
  if (options.file.empty()) renew_in_record(options.folders.front(), page);
  for (const std::string& line : notes.comparisons) fmt::print("{}\n", line);
  fmt::print("{}\n", file.string());
  return done;
}

}  // namespace talus::cli
