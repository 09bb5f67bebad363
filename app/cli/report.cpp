#include "talus/report/report.hpp"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <utility>

#include "command_options.hpp"
#include "commands.hpp"
#include "earlier_output.hpp"
#include "exit_codes.hpp"
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

struct ReportOptions {
  std::vector<std::filesystem::path> folders;
  std::filesystem::path file;         // empty: report.html in the first folder, or compare.html for several
  std::filesystem::path observed;     // stops to compare with; empty: none
  std::filesystem::path pdf;          // to print to, instead of a page; empty: none
  std::string paper;                  // "A4" or "A3"; empty: the project's
  std::string units;                  // "metric" or "us"; empty: the project's
  std::vector<std::string> settings;  // of [report], which override the project's
};

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

int report(const ReportOptions& options) {
  const ReportChanges changes = changes_of(options);
  if (options.pdf.empty()) return write_page(options, changes);
  const int code = write_pdf(options, changes);
  return code == done && !options.file.empty() ? write_page(options, changes) : code;
}

}  // namespace

Command add_report(CLI::App& app) {
  const auto options = std::make_shared<ReportOptions>();
  CLI::App* command = app.add_subcommand("report", "Write report.html of a run again, or compare two runs");
  command->add_option("folders", options->folders, "Folder of one run, or of two to compare")
      ->required()
      ->expected(1, 2)
      ->check(names_folder)
      ->type_name("DIR [DIR2]");
  command
      ->add_option("-o,--output", options->file,
                   "Page to write (default: report.html, or compare.html for two runs, in the first folder)")
      ->check(names_file)
      ->type_name("FILE");
  command
      ->add_option("--observed", options->observed,
                   "Stops of rocks that were observed, laid over the simulated ones and compared with them: a table "
                   "(.csv) with columns x, y (2D: x), or a GIS file of points. A report that is written again without "
                   "it does not show them")
      ->check(names_file)
      ->type_name("FILE");
  command
      ->add_option("--pdf", options->pdf,
                   "Print the report to this PDF file with an installed Chromium or Chrome, instead of writing a page")
      ->check(names_file)
      ->type_name("FILE.pdf");
  command->add_option("--paper", options->paper, "Paper, instead of the project's")->type_name("A4|A3");
  command
      ->add_option("--units", options->units,
                   "Units of results, instead of the project's: metric, or US customary. Other files stay metric")
      ->type_name("metric|us");
  add_overrides(*command, "--set", options->settings,
                "Override a setting of [report], for example --set report.author=\"A. Meier\"; repeatable");
  return {command, [options] { return report(*options); }};
}

}  // namespace talus::cli
