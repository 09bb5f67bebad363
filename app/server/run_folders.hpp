#pragma once
// The folders of runs: DIR/runs/PROJECT/ID for a project file in DIR, with run.json, project.toml and the results.

#include <filesystem>
#include <string>
#include <vector>

#include "run.hpp"

namespace talus::server {

/// The folder of a project's runs. Both are relative to the folder that is served.
[[nodiscard]] inline std::string runs_folder(const std::string& project_file) {
  const std::filesystem::path file(project_file);
  return (file.parent_path() / "runs" / file.stem()).generic_string();
}

/// Reads the run.json of every run below `base`, down to `deepest_project`. All ids differ, also those of copied
/// folders.
[[nodiscard]] std::vector<Run> find_runs(const std::filesystem::path& base);

/// Reads the run.json of every run in a folder of runs.
[[nodiscard]] std::vector<Run> find_runs_in(const std::filesystem::path& folder, const std::filesystem::path& base);

/// Creates a folder named by the current time, to the millisecond, and the folders above it.
[[nodiscard]] std::filesystem::path new_folder(const std::filesystem::path& parent);
/// Creates a folder in `parent`, named by the time, with run.json and the texts of the project and, of a
/// calibration, the study, and sets the run's folder and id. Throws BadInput if that fails.
void create_run_folder(Run& run, const std::filesystem::path& parent, const std::string& project,
                       const std::string& study = {});

/// Removes run.json: if the rest cannot be removed, the next server does not list the run. Throws BadInput if it fails.
void remove_run_file(const Run& run);
/// Removes the rest, and the folders above if they are empty then. Throws BadInput if a part cannot be removed.
void remove_run_folder(const Run& run);

}  // namespace talus::server
