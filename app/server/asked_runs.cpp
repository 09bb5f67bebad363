#include "asked_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <filesystem>
#include <system_error>

#include "results/run_summary.hpp"
#include "talus/campaign/shard.hpp"
#include "talus/lines/reopened_run.hpp"
#include "talus/lines/stored_paths.hpp"

namespace talus::server {

namespace {

namespace fs = std::filesystem;

/// The size and time of a file; empty if there is none.
std::string stamp_of(const fs::path& file) {
  std::error_code error;
  const auto size = fs::file_size(file, error);
  if (error) return "";
  const auto time = fs::last_write_time(file, error);
  return error ? "" : fmt::format("{} {}", size, time.time_since_epoch().count());
}

/// Throws BadInput if it is no longer available.
std::shared_ptr<const BuiltProject> model_of(const Run& run, RunModels& models) {
  auto built = models.find(run);
  if (built) return built;
  throw BadInput(Problem{.file = run.file,
                         .what = "the model of this run is not available",
                         .why = "the project's files have changed since the run",
                         .hint = "Run the project again"});
}

}  // namespace

std::shared_ptr<OpenRun> AskedRuns::open(const Run& run) {
  const fs::path file = results_folder(run) / trajectories_name;
  const std::string stamp = stamp_of(file);
  if (stamp.empty()) throw BadInput(no_trajectories(trajectories_name));
  const auto is_it = [&](const auto& open) { return open->id == run.id; };
  {
    const std::lock_guard lock(mutex_);
    const auto found = std::ranges::find_if(open_, is_it);
    if (found != open_.end() && (*found)->stamp == stamp) {
      std::rotate(open_.begin(), found, found + 1);
      return open_.front();
    }
  }
  const auto opened = std::make_shared<OpenRun>();
  opened->id = run.id;
  opened->stamp = stamp;
  opened->built = model_of(run, models_);
  opened->asked = std::make_unique<AskedRun>(opened->built->model, std::make_unique<StoredPaths>(file),
                                             read_run_identity(results_folder(run) / "summary.json").ways);
  const std::lock_guard lock(mutex_);
  std::erase_if(open_, is_it);
  open_.push_front(opened);
  if (open_.size() > most_open) open_.pop_back();
  return opened;
}

std::shared_ptr<const ReleaseSpots> AskedRuns::releases(const Run& run) {
  {
    const std::lock_guard lock(mutex_);
    if (released_ == run.id && releases_) return releases_;
  }
  auto releases = std::make_shared<const ReleaseSpots>(model_of(run, models_)->model);
  const std::lock_guard lock(mutex_);
  released_ = run.id;
  releases_ = releases;
  return releases;
}

std::string AskedRuns::remember(const std::string& run, std::vector<std::uint64_t> rocks) {
  const std::lock_guard lock(mutex_);
  std::string name = fmt::format("s{}", ++count_);
  selections_.push_back({name, run, std::make_shared<const std::vector<std::uint64_t>>(std::move(rocks))});
  if (selections_.size() > most_selections) selections_.pop_front();
  return name;
}

std::shared_ptr<const std::vector<std::uint64_t>> AskedRuns::selection(const std::string& run,
                                                                       const std::string& name) const {
  const std::lock_guard lock(mutex_);
  for (const Selection& each : selections_) {
    if (each.name == name && each.run == run) return each.rocks;
  }
  throw Refusal(404, name, "this selection of rocks is not kept", "the server keeps the last ones, until it ends",
                "Ask for the line again");
}

bool AskedRuns::is_latest(const std::string& drag, std::uint64_t number) {
  const std::lock_guard lock(mutex_);
  const auto found = std::ranges::find(drags_, drag, &Drag::id);
  if (found == drags_.end()) {
    drags_.push_back({drag, number});
    if (drags_.size() > most_drags) drags_.pop_front();
    return true;
  }
  if (number < found->latest) return false;
  found->latest = number;
  return true;
}

std::function<bool(std::uint64_t)> rocks_passing(const Call& call, const Run& run, AskedRuns& asked) {
  const auto values = [&](const char* key) {
    std::vector<std::string> texts;
    for (std::size_t k = 0; k < call.request.get_param_value_count(key); ++k)
      texts.push_back(call.request.get_param_value(key, k));
    return texts;
  };
  std::vector<std::shared_ptr<const std::vector<std::uint64_t>>> selections;
  for (const std::string& name : values("crossing")) selections.push_back(asked.selection(run.id, name));
  std::vector<std::size_t> released;
  std::shared_ptr<const ReleaseSpots> spots;
  for (const std::string& text : values("release")) {
    if (!spots) spots = asked.releases(run);
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || number >= spots->list().size())
      throw Refusal(400, "release", fmt::format("this run has no release place \"{}\"", text),
                    fmt::format("expected a number below {}", spots->list().size()));
    released.push_back(number);
  }
  if (selections.empty() && released.empty()) return {};
  return [selections, released, spots](std::uint64_t rock) {
    const auto has = [&](const auto& selection) { return std::ranges::binary_search(*selection, rock); };
    return (selections.empty() || std::ranges::any_of(selections, has)) &&
           (released.empty() || std::ranges::count(released, spots->of_rock(rock)) > 0);
  };
}

}  // namespace talus::server
