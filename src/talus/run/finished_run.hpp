#pragma once
// What a run that is to be resumed finds without a checkpoint: results, complete or not, of itself or of another run.

#include <filesystem>
#include <optional>
#include <string>

#include "talus/archive/run_description.hpp"
#include "talus/campaign/shard.hpp"

namespace talus::project {

struct FinishedRun {
  bool is_whole = false;  // this run is finished, and every file is there
  std::string lacks;      // the missing file of this run's results; empty: there are no results of this run
};

/// Throws BadInput if the summary is that of another run: resuming must not overwrite its results.
[[nodiscard]] FinishedRun find_finished_run(const std::filesystem::path& folder, const RunDescription& description,
                                            const RockRange& range, const std::optional<Shard>& shard);

/// Removes the summary of a finished run before other results are written, so that incomplete results are not mistaken
/// for finished ones. The summary of an interrupted run stays until it is replaced.
void remove_finished_summary(const std::filesystem::path& folder);

/// What the results of a run depend on.
struct RunInputs {
  const nlohmann::ordered_json& project;
  const std::string& fingerprint;
  std::uint64_t paths_revision = 0;  // 0: of a program without
};

/// Why two runs differ: their settings, or else the program's revision, or else only their files; nullopt if they do
/// not.
[[nodiscard]] std::optional<std::string> difference_of_inputs(const RunInputs& then, const RunInputs& now);
[[nodiscard]] RunInputs inputs_of(const RunDescription& description);

/// The results that a new run will replace: their rocks, and how that run differs; nullopt if there are none.
[[nodiscard]] std::optional<std::string> replaced_results(const std::filesystem::path& folder,
                                                          const RunDescription& now);

/// "rocks 0 to 49", "shard 1/2 with rocks 0 to 24".
[[nodiscard]] std::string name_of(const RockRange& range, const std::optional<Shard>& shard);

/// Refuses to resume from a file of another run.
[[noreturn]] void refuse_to_resume(const std::filesystem::path& file, std::string what, std::string why);
/// Refuses to resume from a file of a run of the same project by another program.
[[noreturn]] void refuse_other_program(const std::filesystem::path& file, std::string why);

}  // namespace talus::project
