#include "talus/run/merge.hpp"

#include <fmt/format.h>

#include <memory>

#include "command_options.hpp"
#include "commands.hpp"
#include "exit_codes.hpp"
#include "load.hpp"
#include "outcome.hpp"
#include "talus/campaign/thread_supply.hpp"

namespace talus::cli {

namespace {

struct MergeOptions {
  std::vector<std::filesystem::path> folders;
  std::filesystem::path folder;  // empty: the only input folder, or the project's name
  bool partial = false;
  int threads = 0;
  std::uint64_t maps_memory = 0;  // as in RunOptions
  bool quiet = false;
};

int merge(const MergeOptions& options) {
  take_threads(options.threads);
  const project::MergeResult result =
      project::merge_runs({options.folders, options.folder, options.partial, options.threads, options.maps_memory});
  print_warnings(result.warnings);
  if (!options.quiet) {
    fmt::print("{}: {} of {} rocks, from {} {}\n", result.description.name, result.summary.done,
               result.description.rocks, result.parts, result.parts == 1 ? "run" : "runs");
    std::vector<std::string> barriers;
    for (const auto& barrier : result.description.model.at("barriers")) barriers.push_back(barrier.at("name"));
    print_summary(result.summary, barriers);
    print_stored(result.trajectories);
    for (const RockRange& rocks : result.missing) {
      fmt::print("  missing: rocks {} to {}\n", rocks.first, rocks.last - 1);
    }
    fmt::print("Results are in {}{}\n", result.output.string(),
               result.description.wants_report ? "; open report.html to view them" : "");
  }
  return done;
}

}  // namespace

Command add_merge(CLI::App& app) {
  const auto options = std::make_shared<MergeOptions>();
  CLI::App* command = app.add_subcommand("merge", "Merge the shards of a campaign into one result");
  command
      ->add_option("folders", options->folders,
                   "Folders of the shards, in any order, or one folder that contains all of them")
      ->required()
      ->check(names_folder)
      ->type_name("DIR");
  add_output_folder(*command, options->folder,
                    "Folder for the results (default: DIR if only one is given, else named after the project)");
  command->add_flag("--partial", options->partial,
                    "Merge although shards are missing; marks the result as interrupted");
  add_threads(*command, options->threads, "Number of threads for writing maps (default: all cores)");
  add_maps_memory(*command, options->maps_memory);
  add_quiet(*command, options->quiet);
  return {command, [options] { return merge(*options); }};
}

}  // namespace talus::cli
