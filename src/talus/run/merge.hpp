#pragma once
// Runs of parts of one campaign, put together into the results of the whole. The project's files are not needed.

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "talus/archive/run_description.hpp"
#include "talus/campaign/shard.hpp"
#include "talus/core/problems.hpp"
#include "talus/results/summary.hpp"

namespace talus::project {

struct MergeOptions {
  /// Each a folder with a run.state, or one with subfolders that have one.
  std::vector<std::filesystem::path> folders;
  std::filesystem::path output;   // empty: the only folder, or the project's name
  bool partial = false;           // make do with what there is, marked as interrupted
  int threads = 0;                // to write maps with; 0: as many as there are cores
  std::uint64_t maps_memory = 0;  // that maps may take [bytes]; 0: half of what this process may use
};

struct MergeResult {
  std::filesystem::path output;
  RunDescription description;
  Summary summary;
  Problems warnings;
  std::vector<RockRange> missing;  // rocks that nobody did
  std::size_t parts = 0;
};

/// Whatever the order of the folders, and whatever the parts are, every file has the bytes that one run of all rocks
/// gives (`timings` aside). Tables are streamed; in memory there are the maps and one part's state at a time. Throws
/// BadInput, before anything is written, on states that cannot be read, are of different campaigns, have rocks in
/// common or, unless the result may be partial, leave some out; and on tables that are not those of their states.
/// Throws OutOfMemory, before anything is written, where the maps together take more than they may.
MergeResult merge_runs(const MergeOptions& options);

}  // namespace talus::project
