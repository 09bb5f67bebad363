#pragma once
// The study files that name a project.

#include <filesystem>
#include <string>
#include <vector>

namespace talus::server {

struct StudyReference {
  std::filesystem::path file;
  std::string text;     // as it is
  std::string renamed;  // with the project's new name
};

/// Study files in the folder of a project with a site of that project, and the studies of `calibrations`, which are
/// folders of runs. `from` and `to` are names of files in that folder. A file that is not TOML is left out. Throws
/// BadInput if a name cannot be found in its text.
[[nodiscard]] std::vector<StudyReference> study_references(const std::filesystem::path& folder, const std::string& from,
                                                           const std::string& to,
                                                           const std::vector<std::filesystem::path>& calibrations);

}  // namespace talus::server
