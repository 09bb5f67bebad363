#pragma once
// Merges runs of parts of a campaign into the results of the whole. Does not need the project's files.

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "talus/archive/run_description.hpp"
#include "talus/archive/run_summary.hpp"
#include "talus/campaign/shard.hpp"
#include "talus/core/problems.hpp"
#include "talus/results/summary.hpp"

namespace talus::project {

struct MergeOptions {
  /// Folders with a run.state, or with subfolders that have one.
  std::vector<std::filesystem::path> folders;
  std::filesystem::path output;   // empty: the only folder, or the project's name
  bool partial = false;           // accept missing rocks; the results are marked as interrupted
  int threads = 0;                // for writing maps; 0: all cores
  std::uint64_t maps_memory = 0;  // limit for maps [bytes]; 0: half of the memory available to this process
};

struct MergeResult {
  std::filesystem::path output;
  RunDescription description;
  Summary summary;
  Problems warnings;
  std::vector<RockRange> missing;  // rocks that no part has
  std::size_t parts = 0;
  std::optional<StoredRocks> trajectories{};
};

/// Every file has the same bytes as in one run of all rocks (except `timings`), whatever the parts and their order.
/// Tables are streamed; only the maps and one part's state at a time are in memory. Throws BadInput, before anything is
/// written, for states that cannot be read, are of different campaigns, have rocks in common or (unless the result may
/// be partial) leave some out; and for tables that do not belong to their states. Throws OutOfMemory, before anything
/// is written, if the maps together exceed their limit.
MergeResult merge_runs(const MergeOptions& options);

}  // namespace talus::project
