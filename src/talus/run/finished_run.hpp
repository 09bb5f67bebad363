#pragma once
// What a run that was asked to go on finds where there is no checkpoint: results, whole or not, its own or another's.

#include <filesystem>
#include <optional>
#include <string>

#include "talus/archive/run_description.hpp"
#include "talus/campaign/shard.hpp"

namespace talus::project {

struct FinishedRun {
  bool is_whole = false;  // of just this run, to its end, with every file
  std::string lacks;      // if it is this run's, the file that is missing; empty: there are no results of it
};

/// Throws BadInput where the summary is that of another run: its results are not to be lost by a wish to go on.
[[nodiscard]] FinishedRun find_finished_run(const std::filesystem::path& folder, const RunDescription& description,
                                            const RockRange& range, const std::optional<Shard>& shard);

/// Before other results are written: until all of them are there nobody must take them for whole. A summary that says
/// that it is none of a whole run stays until the new one takes its place.
void remove_finished_summary(const std::filesystem::path& folder);

/// In which settings two projects differ, or else in their fingerprints; nothing where they do not.
[[nodiscard]] std::optional<std::string> difference_of_projects(const nlohmann::ordered_json& then,
                                                                const std::string& fingerprint_then,
                                                                const RunDescription& now);

/// What a run that begins anew will replace: the results of which rocks, and in what that run differs; nothing where
/// there are none.
[[nodiscard]] std::optional<std::string> replaced_results(const std::filesystem::path& folder,
                                                          const RunDescription& now);

/// "rocks 0 to 49", "shard 1/2 with rocks 0 to 24".
[[nodiscard]] std::string name_of(const RockRange& range, const std::optional<Shard>& shard);

/// Refuses to go on from a file of another run.
[[noreturn]] void refuse_to_go_on(const std::filesystem::path& file, std::string what, std::string why);

}  // namespace talus::project
