#pragma once
// A whole run: simulates the model's rocks and writes the results to a folder.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "talus/campaign/campaign.hpp"
#include "talus/campaign/model.hpp"
#include "talus/campaign/ranks.hpp"
#include "talus/campaign/shard.hpp"
#include "talus/core/problems.hpp"
#include "talus/files/folder_lock.hpp"
#include "talus/project/project.hpp"
#include "talus/results/summary.hpp"
#include "talus/run/run_results.hpp"

namespace talus::project {

struct RunOptions {
  /// The rocks are set by `shard`, not here. Progress is called with the number of rocks done, including those of a run
  /// that is resumed; for the first time before any rock is simulated.
  CampaignOptions campaign;
  std::optional<Shard> shard;                   // nullopt: the whole campaign
  bool resume = false;                          // resume from the last checkpoint in the folder
  double checkpoint_every = 20;                 // [s]; 0: never
  std::function<void(const std::string&)> say;  // prints notes for the user before rocks are simulated
  Ranks* ranks = nullptr;                       // helpers of this process, which is rank 0; null: this process alone
  const FolderLock* lock = nullptr;             // the caller's lock of the folder; null: the run locks it
  std::uint64_t maps_memory = 0;                // limit for maps [bytes]; 0: half of the memory available
  /// Sees the rocks that this process simulates, beside the run's own observers; null: none. Changes no result.
  Observer* watch = nullptr;
  /// Called between blocks, with the sums over all rocks so far, including those of a run that is resumed.
  std::function<void(const Summary&)> so_far;
  bool only_results = false;  // write the results of the rocks done so far; simulate no more
  /// How long a run that was stopped may take to write the results of the rocks done [s].
  double closing_seconds = 1;
};

struct RunResult {
  CampaignOutcome outcome;
  Summary summary;
  Problems warnings;              // found by the run
  std::optional<StoredRocks> trajectories{};
  RockRange range;                // of the run
  std::uint64_t done_before = 0;  // rocks of the earlier run that was resumed
  bool was_complete = false;      // all rocks were done already; the summary is empty
  /// Whether all results of the rocks done were written. If not, the run was stopped before: its tables are there, and
  /// it can be resumed from run.state.
  bool has_results = true;
};

/// Runs the campaign and writes endpoints.csv, paths.csv, barriers.csv, summary.json, report.html and, in 3D, maps, as
/// the project requests; of a shard tables, summary.json and run.state, for merging (merge.hpp). run.state is also
/// written at intervals, and stays if the run does not finish: a resumed run gives the same bytes. A run that is
/// stopped while it simulates writes the results so far, if time allows; one that is stopped while it writes keeps its
/// state without results. If maps exceed their limit or memory is exhausted, it keeps the rocks done and throws
/// OutOfMemory. Throws BadInput if the folder cannot be written to (with a hint to resume), or if another program
/// writes results there. Files appear complete or not at all. Throws Stopped if stopped before the first rock.
RunResult run_into(const std::filesystem::path& folder, const Project& project, const Model& model,
                   const Problems& warnings, const RunOptions& options);

}  // namespace talus::project
