#include "talus/run/merge.hpp"

#include <fmt/format.h>

#include "commands.hpp"
#include "load.hpp"
#include "outcome.hpp"
#include "talus/campaign/thread_supply.hpp"

namespace talus::cli {

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

}  // namespace talus::cli
