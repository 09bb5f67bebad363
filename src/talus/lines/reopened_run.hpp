#pragma once
// A finished run from its folder: its project and its model, built again, and the paths of its rocks.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "talus/campaign/model.hpp"
#include "talus/core/problems.hpp"
#include "talus/lines/asked_run.hpp"
#include "talus/project/project.hpp"

namespace talus {

/// The project that a run's summary holds, with other settings of [design], for a line that is asked. No warnings: the
/// run has given its own, and those about the defaults, which a summary spells out, are nobody's. `file`: to which the
/// project's paths are relative. Throws BadInput.
[[nodiscard]] project::Project project_again(const nlohmann::ordered_json& echoed, const std::filesystem::path& file,
                                             const std::vector<std::string>& settings);

class ReopenedRun {
 public:
  /// `folder`: of the run. `files`: the folder of the project's files; empty: the one that `folder` is in. `settings`:
  /// `design.KEY=VALUE`. Throws BadInput if the run is of another version, has no trajectories, or if the files of its
  /// project have changed since.
  ReopenedRun(const std::filesystem::path& folder, const std::filesystem::path& files,
              const std::vector<std::string>& settings = {});
  ReopenedRun(const ReopenedRun&) = delete;
  ReopenedRun& operator=(const ReopenedRun&) = delete;

  [[nodiscard]] const project::Project& project() const { return project_; }
  [[nodiscard]] const Model& model() const { return model_; }
  [[nodiscard]] const AskedRun& asked() const { return *asked_; }

 private:
  project::Project project_;
  Model model_;
  std::unique_ptr<const AskedRun> asked_;
};

/// The problem of a run whose trajectories were not kept; `file`: where they would be.
[[nodiscard]] Problem no_trajectories(const std::filesystem::path& file);

}  // namespace talus
