#include "talus/report/report.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "commands.hpp"
#include "earlier_output.hpp"
#include "load.hpp"
#include "pdf_printing.hpp"
#include "stop_signals.hpp"
#include "talus/core/stop.hpp"
#include "talus/files/file_record.hpp"
#include "talus/files/folder_lock.hpp"
#include "talus/files/output_file.hpp"
#include "talus/project/title_block.hpp"

namespace talus::cli {

namespace {

ReportChanges changes_of(const ReportOptions& options) {
  std::vector<std::string> settings = options.settings;
  if (!options.paper.empty()) settings.push_back("report.paper=" + options.paper);
  if (!options.units.empty()) settings.push_back("report.units=" + options.units);
  project::TitleBlockSettings block = project::title_block_settings(settings);
  return {std::move(block.given), std::move(block.logo)};
}

void print_notes(const ReportNotes& notes) {
  print_warnings(notes.doubts);
  for (const std::string& line : notes.comparisons) fmt::print("{}\n", line);
}

int write_pdf(const ReportOptions& options, const ReportChanges& changes) {
  refuse_other_files(options.pdf, "%PDF-", "PDF file");
  catch_stop_signals();
  const PdfPrinting printing(options.pdf);
  try {
    const StopScope scope(&stop_wanted());
    print_notes(write_report(options.folders, printing.page(), "summary.json", options.observed, changes));
  } catch (const Stopped&) {
    return stopped;
  }
  if (!printing.print()) return stopped;
  fmt::print("{}\n", options.pdf.string());
  return done;
}

int write_page(const ReportOptions& options, const ReportChanges& changes) {
  const char* page = options.folders.size() > 1 ? "compare.html" : "report.html";
  const std::filesystem::path file = options.file.empty() ? options.folders.front() / page : options.file;
  (void)place_of_file(file);
  refuse_other_files(file, "<!DOCTYPE html>", "page");
  std::optional<FolderLock> lock;  // a run into this folder may be in progress
  if (options.file.empty()) lock.emplace(lock_output_folder(options.folders.front()));
  const ReportNotes notes = write_report(options.folders, file, "summary.json", options.observed, changes);
  if (options.file.empty()) renew_in_record(options.folders.front(), page);
  print_notes(notes);
  fmt::print("{}\n", file.string());
  return done;
}

}  // namespace

int report(const ReportOptions& options) {
  const ReportChanges changes = changes_of(options);
  if (options.pdf.empty()) return write_page(options, changes);
  const int code = write_pdf(options, changes);
  return code == done && !options.file.empty() ? write_page(options, changes) : code;
}

}  // namespace talus::cli
