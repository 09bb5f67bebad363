#pragma once
// The files that a run writes to its folder, and what would prevent writing them.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "talus/archive/run_description.hpp"
#include "talus/campaign/shard.hpp"
#include "talus/project/project.hpp"

namespace talus::project {

/// Relative to the folder: of the maps only one that is always among them, and at the end summary.json, which is
/// written last.
[[nodiscard]] std::vector<std::string> result_files(const RunDescription& description,
                                                    const std::optional<Shard>& shard);

/// Those that exist in the folder, and all maps: the files that files.json records.
[[nodiscard]] std::vector<std::string> written_files(const std::filesystem::path& folder,
                                                     const RunDescription& description,
                                                     const std::optional<Shard>& shard);

/// The first of them that is missing, or not as recorded.
[[nodiscard]] std::optional<std::string> lacking_file(const std::filesystem::path& folder,
                                                      const RunDescription& description,
                                                      const std::optional<Shard>& shard);

/// Throws BadInput if a folder has the name of one of them, or a file that of the maps' folder.
void check_that_results_have_room(const std::filesystem::path& folder, const RunDescription& description,
                                  const std::optional<Shard>& shard);

/// Throws BadInput if a run in this folder would overwrite or remove the project or a file that it reads; each error is
/// reported at the line of the project that names the file.
void check_that_inputs_are_kept(const std::filesystem::path& folder, const Project& project);

}  // namespace talus::project
