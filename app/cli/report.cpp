#include "talus/io/report.hpp"

#include <fmt/format.h>

#include "commands.hpp"

namespace talus::cli {

int report(const ReportOptions& options) {
  const char* page = options.folders.size() > 1 ? "compare.html" : "report.html";
  const std::filesystem::path file = options.file.empty() ? options.folders.front() / page : options.file;
  io::write_report(options.folders, file);
  fmt::print("{}\n", file.string());
  return done;
}

}  // namespace talus::cli
