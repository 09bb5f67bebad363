#include "run_models.hpp"

#include <algorithm>

#include "results/run_summary.hpp"
#include "talus/model/fingerprint.hpp"
#include "talus/project/document.hpp"
#include "talus/project/echo.hpp"

namespace talus::server {

namespace {

namespace fs = std::filesystem;

std::shared_ptr<const BuiltProject> rebuild(const Run& run, const fs::path& file, ModelReading& reading) {
  try {
    return reading.read<BuiltProject>("run " + run.id, [run, file] {
      BuiltProject built = build(project::text_of_file(run.folder / run_project_name), file, overrides_of(run));
      const std::string fingerprint = project::fingerprint_of(project::echo(built.project), built.model);
      if (read_run_identity(results_folder(run) / "summary.json").fingerprint != fingerprint)
        throw BadInput(Problem{.file = file.string(), .what = "the files of this project have changed since the run"});
      return built;
    });
  } catch (const BadInput&) {
    return nullptr;
  }
}

}  // namespace

std::shared_ptr<const BuiltProject> RunModels::find(const Run& run) {
  const auto is_it = [&](const auto& kept) { return kept->run == run.id; };
  {
    const std::lock_guard lock(mutex_);
    const auto found = std::find_if(kept_.begin(), kept_.end(), is_it);
    if (found != kept_.end()) {
      std::rotate(kept_.begin(), found, found + 1);
      return kept_.front()->built;
    }
  }
  auto built = rebuild(run, workplace_.at(run.file), reading_);
  if (!built) return nullptr;  // not cached: the project's files may be restored
  const std::lock_guard lock(mutex_);
  std::erase_if(kept_, is_it);
  kept_.push_front(std::make_shared<const Kept>(Kept{run.id, built, bytes_of(built->model)}));
  kept_.resize(count_within(kept_, most_bytes_));
  return built;
}

}  // namespace talus::server
