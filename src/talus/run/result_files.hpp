#pragma once
// Which files a run leaves in its folder, and what stands in their way.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "talus/archive/run_description.hpp"
#include "talus/campaign/shard.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

/// Relative to the folder; of the maps one that is always among them, and summary.json, which is written last, at the
/// end.
[[nodiscard]] std::vector<std::string> result_files(const RunDescription& description,
                                                    const std::optional<Shard>& shard);

/// Those that are in the folder, and all maps: what files.json records.
[[nodiscard]] std::vector<std::string> written_files(const std::filesystem::path& folder,
                                                     const RunDescription& description,
                                                     const std::optional<Shard>& shard);

/// The first of them that is not there, or not as it was recorded.
[[nodiscard]] std::optional<std::string> lacking_file(const std::filesystem::path& folder,
                                                      const RunDescription& description,
                                                      const std::optional<Shard>& shard);

/// Throws BadInput where a folder has the name of one of them, or a file that of the maps' folder.
void check_that_results_have_room(const std::filesystem::path& folder, const RunDescription& description,
                                  const std::optional<Shard>& shard);

/// Throws BadInput where a run in this folder would write over, or take away, the project or a file that it reads; each
/// is said where the project names it.
void check_that_inputs_are_kept(const std::filesystem::path& folder, const Project& project);

}  // namespace talus::project
