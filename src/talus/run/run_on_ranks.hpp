#pragma once
// A run whose rocks are thrown by several processes. Rank 0 runs it as if it were alone (run.hpp) but for the throwing;
// the others help it until it lets them go.

#include <atomic>
#include <span>
#include <string>
#include <vector>

#include "talus/campaign/ranks.hpp"
#include "talus/core/problems.hpp"
#include "talus/run/checkpoint.hpp"
#include "talus/run/run.hpp"

namespace talus::project {

/// For rank 0: waits until all others have read the project, and gives the threads of each. Throws BadInput with all
/// that went wrong on them, or differs: everything has to be the same everywhere, to the bits of paths. Throws Stopped
/// at the request of the thread's StopScope or of one of them.
[[nodiscard]] std::vector<int> meet_ranks(Ranks& ranks, const RunDescription& description, int own_threads);

/// For rank 0, after meeting: throws the rocks that `begun` leaves to be done, with the threads of each rank. Sums and
/// tables then hold them. Throws what went wrong on any rank.
CampaignOutcome simulate_on_ranks(Ranks& ranks, std::span<const int> threads, const Project& project,
                                  const Model& model, const RunOptions& options, const RunStateHeader& begun,
                                  RunSums& sums, TableFiles& tables, Checkpoints& checkpoints);

/// For rank 0, at the end of whatever happened: lets the others go with this exit code.
void dismiss_ranks(Ranks& ranks, int exit_code);

/// For the others, once they have read the project: does what rank 0 wants, and gives its exit code. Of the options
/// threads, stop and shard matter.
int help_run(Ranks& ranks, const Project& project, const Model& model, const Problems& warnings,
             const RunOptions& options);

/// For the others, where something is wrong: rank 0 will say it. Gives its exit code.
int cannot_help(Ranks& ranks, const std::string& what, int exit_code);

}  // namespace talus::project
