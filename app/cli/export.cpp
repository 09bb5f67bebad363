#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <optional>
#include <vector>

#include "command_options.hpp"
#include "commands.hpp"
#include "earlier_output.hpp"
#include "exit_codes.hpp"
#include "talus/archive/table_columns.hpp"
#include "talus/core/problems.hpp"
#include "talus/export/stored_paths.hpp"
#include "talus/files/file_record.hpp"
#include "talus/files/output_file.hpp"

namespace talus::cli {

namespace {

struct ExportOptions {
  std::filesystem::path folder;  // of a run
  std::string paths;             // "all" or a number of rocks
  std::filesystem::path file;    // empty: standard output
};

/// nullopt: all.
std::optional<std::uint64_t> rocks_wanted(const std::string& text) {
  if (text == "all") return std::nullopt;
  std::uint64_t rocks = 0;
  const char* const end = text.data() + text.size();
  if (const auto [last, error] = std::from_chars(text.data(), end, rocks); error == std::errc() && last == end)
    return rocks;
  throw BadInput(Problem{.where = "--paths",
                         .what = fmt::format("\"{}\" is not a number of rocks", text),
                         .why = "expected \"all\" or a whole number"});
}

/// A run's own table is part of its results: their checksums are recorded, and reports are made from them.
void refuse_results(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  const std::vector<std::string> results = recorded_files(folder);
  if (std::ranges::find(results, file.filename().string()) == results.end()) return;
  throw BadInput(Problem{.file = file.string(),
                         .what = "cannot write the table here",
                         .why = "this file is a result of a run",
                         .hint = "Choose another name"});
}

struct StandardOutput : TextSink {
  void write(std::string_view text) override { fmt::print("{}", text); }
};

int export_paths(const ExportOptions& options) {
  const std::optional<std::uint64_t> wanted = rocks_wanted(options.paths);
  if (!options.file.empty()) {
    (void)place_of_file(options.file);
    refuse_results(options.file);
    std::string beginning = header_of<PathEventRow>({}, columns_in_run<PathEventRow>(false));
    beginning.pop_back();  // blocks have more columns
    refuse_other_files(options.file, beginning, "table of paths");
  }
  const TrajectoryStore store(options.folder / trajectories_name);
  if (options.file.empty()) {
    StandardOutput out;
    write_stored_paths(store, wanted, out);
    return done;
  }
  OutputFile out(options.file);
  write_stored_paths(store, wanted, out);
  out.commit();
  fmt::print("{}\n", options.file.string());
  return done;
}

}  // namespace

Command add_export(CLI::App& app) {
  const auto options = std::make_shared<ExportOptions>();
  CLI::App* command =
      app.add_subcommand("export", "Make the table paths.csv from the trajectories that a run has stored");
  add_run_folder(*command, options->folder, "Folder of the run");
  command->add_option("--paths", options->paths, "The rocks: all in the store, or a number of them, evenly spread")
      ->default_val("all")
      ->type_name("all|N");
  command->add_option("-o,--output", options->file, "Table to write (default: standard output)")
      ->check(names_file)
      ->type_name("FILE");
  return {command, [options] { return export_paths(*options); }};
}

}  // namespace talus::cli
