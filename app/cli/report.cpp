#include "talus/io/report.hpp"

#include <fmt/format.h>

#include <optional>

#include "commands.hpp"
#include "talus/io/folder_lock.hpp"

namespace talus::cli {

int report(const ReportOptions& options) {
  const char* page = options.folders.size() > 1 ? "compare.html" : "report.html";
  const std::filesystem::path file = options.file.empty() ? options.folders.front() / page : options.file;
  std::optional<FolderLock> lock;  // of a run's folder, which may be that of a run under way
  if (options.file.empty()) lock.emplace(lock_output_folder(options.folders.front()));
  io::write_report(options.folders, file);
  fmt::print("{}\n", file.string());
  return done;
}

}  // namespace talus::cli
