#pragma once
// A whole run: the model's rocks, and its results in a folder.

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
  /// Which rocks is not said here but by `shard`. Progress is called with how many rocks of the run are done, those of
  /// a run that it goes on with included; first once before any rock is thrown.
  CampaignOptions campaign;
  std::optional<Shard> shard;                   // nothing: the whole campaign
  bool resume = false;                          // go on from the last checkpoint in the folder
  double checkpoint_every = 20;                 // [s]; 0: never
  std::function<void(const std::string&)> say;  // what the user should know before rocks are thrown
  Ranks* ranks = nullptr;                       // that simulate rocks, too, this being rank 0; null: this process alone
  const FolderLock* lock = nullptr;             // of the folder, who calls having it; null: it is locked for the run
  std::uint64_t maps_memory = 0;                // that maps may take [bytes]; 0: half of what this process may use
  bool only_results = false;                    // of the rocks done so far: no more are computed
  /// How long a run that was stopped among its rocks may take to write the results of what is done [s].
  double closing_seconds = 1;
};

struct RunResult {
  CampaignOutcome outcome;
  Summary summary;
  Problems warnings;              // those that only the run could know
  RockRange range;                // rocks that were to be done
  std::uint64_t done_before = 0;  // rocks of an earlier run that this one went on with
  bool was_complete = false;      // there was nothing left to do; the summary is empty
  /// All results of the rocks done were written. Otherwise the run was stopped before; its rocks are in run.state, from
  /// where it can go on, and its tables are there.
  bool has_results = true;
};

/// Runs the campaign and writes endpoints.csv, paths.csv, barriers.csv, summary.json, report.html and, in 3D, maps,
/// as the project asks; of a shard tables, summary.json and run.state, for merging (merge.hpp). While it runs,
/// run.state is written now and then, and stays if the run does not come to its end: one that resumes goes on from
/// there and gives the same bytes. A run that is stopped among its rocks writes what it has, as far as the time allows;
/// one that is stopped while it writes keeps its state and leaves the results. Where maps come to take more memory than
/// they may, or there is none, it keeps what is done and throws OutOfMemory. Throws BadInput where the folder cannot
/// be written to, and then says from where it can be resumed, and where another program writes results there; files are
/// there whole or not at all. Throws Stopped where it is stopped before its first rock.
RunResult run_into(const std::filesystem::path& folder, const Project& project, const Model& model,
                   const Problems& warnings, const RunOptions& options);

}  // namespace talus::project
