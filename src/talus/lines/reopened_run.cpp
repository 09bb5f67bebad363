#include "talus/lines/reopened_run.hpp"

#include <fmt/format.h>

#include <system_error>

#include "talus/archive/run_summary.hpp"
#include "talus/lines/stored_paths.hpp"
#include "talus/model/fingerprint.hpp"
#include "talus/model/model.hpp"
#include "talus/project/echo.hpp"
#include "talus/project/read.hpp"
#include "talus/store/trajectory_store.hpp"

namespace talus {

namespace fs = std::filesystem;

project::Project project_again(const nlohmann::ordered_json& echoed, const fs::path& file,
                               const std::vector<std::string>& settings) {
  project::Overrides overrides;
  overrides.asks_a_line = true;
  overrides.settings = settings;
  try {
    return project::read_project_text(project::text_of_echo(echoed), file, overrides).project;
  } catch (const BadInput& refused) {
    Problems errors;
    for (const Problem& problem : refused.problems().list()) {
      if (problem.severity == Severity::error) errors.add(problem);
    }
    throw BadInput(errors);
  }
}

Problem no_trajectories(const fs::path& file) {
  return {.file = file.string(),
          .what = "the run has no stored trajectories",
          .why = "lines are asked of the paths of its rocks",
          .hint = "Run it again with output.trajectories"};
}

ReopenedRun::ReopenedRun(const fs::path& folder, const fs::path& files, const std::vector<std::string>& settings) {
  const fs::path summary = folder / "summary.json";
  const RunIdentity run = read_run_identity(summary);
  if (run.talus.version != TALUS_VERSION) {
    throw BadInput(Problem{.file = summary.string(),
                           .what = "these are the results of another version of talus",
                           .why = fmt::format("it was {} and is {}", run.talus.version, TALUS_VERSION),
                           .hint = "Run the project again"});
  }
  fs::path own = fs::absolute(folder).lexically_normal();
  if (!own.has_filename()) own = own.parent_path();  // of "out/"
  const fs::path base = files.empty() ? own.parent_path() : files;
  // By default results are in a folder that has the project's name and is beside it.
  project_ = project_again(*run.project, base / (own.filename().string() + ".toml"), settings);
  Problems told;  // by the run
  model_ = project::build_model(project_, told);
  if (project::fingerprint_of(*run.project, model_) != run.fingerprint) {
    throw BadInput(Problem{.file = summary.string(),
                           .what = "the files of this project have changed since the run",
                           .why = "the terrain, the ground or the releases are not the same",
                           .hint = "Run the project again"});
  }
  const fs::path store = folder / trajectories_name;
  std::error_code ignored;
  if (!fs::exists(store, ignored)) throw BadInput(no_trajectories(store));
  asked_ = std::make_unique<AskedRun>(model_, std::make_unique<StoredPaths>(store), run.ways);
}

}  // namespace talus
