#include "run_models.hpp"

#include <algorithm>

#include "results/run_summary.hpp"
#include "talus/project/document.hpp"
#include "talus/project/echo.hpp"
#include "talus/project/fingerprint.hpp"

namespace talus::server {

namespace {

std::shared_ptr<const BuiltProject> build_again(const Run& run, const Workplace& workplace) {
  try {
    auto built = std::make_shared<BuiltProject>(
        build(project::text_of_file(run.folder / run_project_name), workplace.at(run.file), overrides_of(run)));
    const std::string fingerprint = project::fingerprint_of(project::echo(built->project), built->model);
    if (read_summary(run).value("fingerprint", Json()) != fingerprint) return nullptr;
    return built;
  } catch (const BadInput&) {
    return nullptr;
  }
}

}  // namespace

std::shared_ptr<const BuiltProject> RunModels::find(const Run& run) {
  // One at a time, so that two who ask for the same one do not both build it.
  const std::lock_guard lock(mutex_);
  const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const auto& kept) { return kept.first == run.id; });
  if (found != kept_.end()) {
    std::rotate(kept_.begin(), found, found + 1);
    return kept_.front().second;
  }
  auto built = build_again(run, workplace_);
  if (!built) return nullptr;  // the project's files may come back
  kept_.emplace_front(run.id, built);
  if (kept_.size() > most_kept) kept_.pop_back();
  return built;
}

}  // namespace talus::server
