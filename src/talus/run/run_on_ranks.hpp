#pragma once
// A run whose rocks are simulated by several processes. Rank 0 runs it as if it were alone (run.hpp), except that the
// other ranks help to simulate until it dismisses them.

#include <atomic>
#include <span>
#include <string>
#include <vector>

#include "talus/campaign/ranks.hpp"
#include "talus/core/problems.hpp"
#include "talus/run/checkpoint.hpp"
#include "talus/run/run.hpp"

namespace talus::project {

/// For rank 0: waits until all others have read the project, and returns the number of threads of each. Throws BadInput
/// with all errors on them and all differences between them: everything must be the same, to the bits of the paths.
/// Throws Stopped at the request of the thread's StopScope or of another rank.
[[nodiscard]] std::vector<int> meet_ranks(Ranks& ranks, const RunDescription& description, int own_threads);

/// For rank 0, after meet_ranks: simulates the rocks that remain after `begun` with the threads of each rank, and adds
/// them to sums and tables. Throws the error of any rank.
CampaignOutcome simulate_on_ranks(Ranks& ranks, std::span<const int> threads, const Project& project,
                                  const Model& model, const RunOptions& options, const RunStateHeader& begun,
                                  RunSums& sums, TableFiles& tables, Checkpoints& checkpoints);

/// For rank 0, at the end in any case: makes the others exit with this code.
void dismiss_ranks(Ranks& ranks, int exit_code);

/// For the other ranks, after reading the project: does the work that rank 0 assigns, and returns its exit code. Of the
/// options only threads, stop and shard are used.
int help_run(Ranks& ranks, const Project& project, const Model& model, const Problems& warnings,
             const RunOptions& options);

/// For the other ranks, after an error, which rank 0 will report. Returns its exit code.
int cannot_help(Ranks& ranks, const std::string& what, int exit_code);

}  // namespace talus::project
