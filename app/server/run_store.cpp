#include "run_store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "run_folders.hpp"
#include "talus/archive/run_state.hpp"
#include "talus/calibration/study.hpp"
#include "talus/files/output_file.hpp"
#include "talus/project/document.hpp"
#include "talus/project/problem_paths.hpp"

namespace talus::server {

namespace {

namespace fs = std::filesystem;
using Task = RunWorker::Task;

constexpr std::size_t longest_name = 200;  // bytes

/// Names are given by users and shown as text.
void check_name(const std::string& name) {
  const auto refuse = [&](const char* why) { return Refusal(400, "name", "cannot be the name of a run", why); };
  if (name.empty()) throw refuse("it is empty");
  if (name.size() > longest_name) throw refuse("it is too long");
  if (std::any_of(name.begin(), name.end(), [](unsigned char c) { return c < 32 || c == 127; }))
    throw refuse("it has control characters");
}

Refusal not_now(const Run& run, const char* what, const char* why, const char* hint = "") {
  return Refusal(409, run.id, what, why, hint);
}

/// A file that a study names, as a name in the folder that is served.
std::string name_beside(const std::string& study, const fs::path& named) {
  return (fs::path(study).parent_path() / named).lexically_normal().generic_string();
}

/// Refuses what only the command line does.
void check_order(const std::string& file, const calibration::Study& study, const Workplace& workplace) {
  if (!study.models.empty())
    throw Refusal(400, file, "has [[model]]", "the workbench calibrates one model at a time",
                  "Run the study with talus calibrate");
  for (const auto& site : study.sites) static_cast<void>(workplace.at(name_beside(file, site.project)));
  for (const calibration::StudyObservations& each : study.observations)
    static_cast<void>(workplace.at(name_beside(file, each.file())));
  if (fs::path(name_beside(file, study.sites.front().project)).parent_path() != fs::path(file).parent_path())
    throw Refusal(400, file, "names a project in another folder", "the study belongs beside its first project");
}

/// The text of a file; nullopt if there is none.
std::optional<std::string> text_if_any(const fs::path& file) {
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return std::nullopt;
  return project::text_of_file(file);
}

}  // namespace

RunStore::RunStore(const Workplace& workplace, EventHub& events, ModelReading& reading)
    : workplace_(workplace), events_(events), reading_(reading), worker_(workplace, events, reading, mutex_) {
  for (Run& run : find_runs(workplace.folder())) {
    const auto entry = std::make_shared<RunEntry>();
    entry->run = std::move(run);
    entries_.emplace(entry->run.id, entry);
  }
}

std::shared_ptr<RunEntry> RunStore::entry_of(const std::string& id) {
  const auto found = entries_.find(id);
  if (found == entries_.end()) throw Refusal(404, id, "there is no such run");
  Run& run = found->second->run;
  if (run.is_elsewhere) {  // the other program may have changed it
    run = read_run(run.folder, workplace_.folder());
    run.id = id;
  }
  return found->second;
}

std::vector<Run> RunStore::list() {
  const std::lock_guard lock(mutex_);
  std::vector<Run> runs;
  for (const auto& [id, entry] : entries_) runs.push_back(entry_of(id)->run);
  std::sort(runs.begin(), runs.end(),
            [](const Run& a, const Run& b) { return a.begun != b.begun ? a.begun > b.begun : a.id > b.id; });
  return runs;
}

Run RunStore::find(const std::string& id) {
  const std::lock_guard lock(mutex_);
  return entry_of(id)->run;
}

std::shared_ptr<const RunWatch> RunStore::watch(const std::string& id) {
  const std::lock_guard lock(mutex_);
  const auto entry = entry_of(id);
  if (!entry->watch) throw Refusal(404, id, "has no results so far", "it is not being simulated");
  return entry->watch;
}

Run RunStore::begin(const RunOrder& order) {
  const fs::path file = workplace_.project(order.file);
  if (!order.name.empty()) check_name(order.name);
  auto entry = std::make_shared<RunEntry>();
  Run& run = entry->run;
  run.file = fs::path(order.file).lexically_normal().generic_string();
  run.asked_rocks = order.rocks;
  run.asked_seed = order.seed;
  run.begun = time_now();
  try {
    entry->built = build_for_run(reading_, order.text, file, overrides_of(run));
  } catch (const BadInput& bad) {
    throw BadInput(seen_from(workplace_.folder(), project::with_paths(bad.problems(), order.text, file)));
  }
  run.project = entry->built->project.name;
  run.name = order.name.empty() ? run.project : order.name;
  run.dimension = std::holds_alternative<Profile>(*entry->built->model.surface) ? 2 : 3;
  run.rocks = entry->built->model.rocks();
  run.problems = as_json(seen_from(workplace_.folder(), entry->built->warnings));

  return queue(entry, order.text, "");
}

Run RunStore::begin(const CalibrationOrder& order) {
  const std::string name = fs::path(order.file).lexically_normal().generic_string();
  if (!name.ends_with(study_ending))
    throw Refusal(400, order.file, "is not the name of a study", std::string("it does not end in ") + study_ending);
  const fs::path file = workplace_.at(name);
  const auto before = text_if_any(file);
  if (before && *before != order.text && !order.replace)
    throw Refusal(409, name, "already exists", "", "Give the study another name, or open this one and change it");
  auto entry = std::make_shared<RunEntry>();
  Run& run = entry->run;
  std::string project_text;
  try {
    const calibration::StudyReading reading = calibration::read_study_text(order.text, file);
    check_order(name, reading.study, workplace_);
    entry->calibration = prepare_calibration(reading_, reading);
    run.file = name_beside(name, reading.study.sites.front().project);
    project_text = project::text_of_file(workplace_.at(run.file));
  } catch (const BadInput& bad) {
    throw BadInput(seen_from(workplace_.folder(), project::with_paths(bad.problems(), order.text, file)));
  }
  const calibration::PreparedStudy& prepared = entry->calibration->study;
  run.kind = RunKind::calibration;
  run.study = fs::path(name).filename().string();
  run.begun = time_now();
  run.project = prepared.sites().front().project().name;
  run.name = prepared.study().name;
  run.dimension = prepared.sites().front().project().is_2d() ? 2 : 3;
  run.rocks = static_cast<std::uint64_t>(prepared.study().draws);
  run.problems = as_json(seen_from(workplace_.folder(), entry->calibration->warnings));
  OutputFile study(workplace_.written(file));
  study.write(order.text);
  study.commit();
  return queue(entry, project_text, order.text);
}

Run RunStore::queue(const std::shared_ptr<RunEntry>& entry, const std::string& project, const std::string& study) {
  Run& run = entry->run;
  const std::lock_guard lock(mutex_);
  if (worker_.is_closed()) throw Refusal(503, run.file, "cannot be run", why_closing);
  create_run_folder(run, workplace_.at(runs_folder(run.file)), project, study);
  // Of the queued runs only the first keeps its model in memory.
  if (!worker_.is_idle()) {
    entry->built.reset();
    entry->calibration.reset();
  }
  entries_[run.id] = entry;
  worker_.enqueue(entry, Task::begin);
  events_.publish("run", run.id, json_of(run));
  return run;
}

Run RunStore::rename(const std::string& id, const std::string& name) {
  check_name(name);
  const std::lock_guard lock(mutex_);
  Run& run = entry_of(id)->run;
  if (run.is_elsewhere) throw not_now(run, "cannot be renamed", why_elsewhere);
  if (run.is_damaged) throw not_now(run, "cannot be renamed", "its run.json is damaged");
  run.name = name;
  changed(run);
  return run;
}

Run RunStore::stop(const std::string& id) {
  const std::lock_guard lock(mutex_);
  const auto entry = entry_of(id);
  Run& run = entry->run;
  if (run.is_elsewhere) throw not_now(run, "cannot be stopped", why_elsewhere);
  if (run.state != RunState::waiting && run.state != RunState::running)
    throw not_now(run, "cannot be stopped", "it is neither waiting nor running");
  entry->stop = true;
  if (run.is_active) return run;
  worker_.unqueue(*entry);
  entry->built.reset();
  run.state = RunState::stopped;
  changed(run);
  return run;
}

Run RunStore::resume(const std::string& id) {
  const std::lock_guard lock(mutex_);
  const auto entry = entry_of(id);
  Run& run = entry->run;
  const char* what = "cannot be resumed";
  if (worker_.is_closed()) throw Refusal(503, run.id, what, why_closing);
  if (run.is_elsewhere) throw not_now(run, what, why_elsewhere);
  if (run.is_damaged) throw not_now(run, what, "its run.json is damaged", "Run its project again");
  if (run.state == RunState::done) throw not_now(run, what, "it is done");
  if (run.state == RunState::waiting || run.state == RunState::running)
    throw not_now(run, what, "it is waiting or running");
  worker_.unqueue(*entry);
  if (run.is_active) entry->stop = true;  // its results so far are being written
  entry->state_before.reset();
  if (run.state != RunState::failed) entry->state_before = run.state;
  run.state = RunState::waiting;
  run.problems = Json::array();
  worker_.enqueue(entry, Task::resume);
  changed(run);
  return run;
}

Run RunStore::write_results(const std::string& id) {
  const std::lock_guard lock(mutex_);
  const auto entry = entry_of(id);
  const Run& run = entry->run;
  const char* what = "has no results to write";
  if (worker_.is_closed()) throw Refusal(503, run.id, what, why_closing);
  if (run.is_elsewhere) throw not_now(run, what, why_elsewhere);
  if (run.state != RunState::interrupted) throw not_now(run, what, "it was not interrupted");
  std::error_code ignored;
  const bool has_finished_rocks =
      fs::exists(run.folder / run_state_name, ignored) || fs::exists(run.folder / "summary.json", ignored);
  if (!has_finished_rocks) throw not_now(run, what, "no rock was finished");
  worker_.unqueue(*entry);
  worker_.enqueue(entry, Task::write_results);
  return run;
}

void RunStore::remove(const std::string& id) {
  const std::lock_guard lock(mutex_);
  const auto entry = entry_of(id);
  const Run& run = entry->run;
  if (run.is_elsewhere) throw not_now(run, "cannot be removed", why_elsewhere);
  if (run.is_active) throw not_now(run, "cannot be removed", "it is running", "Stop it first");
  remove_run_file(run);
  worker_.unqueue(*entry);
  entries_.erase(id);
  events_.publish("removed", id, {{"id", id}});
  remove_run_folder(run);
}

std::vector<std::shared_ptr<RunEntry>> RunStore::idle_runs_of(const std::string& file, const char* what) {
  const fs::path folder = workplace_.at(runs_folder(file));
  std::vector<std::shared_ptr<RunEntry>> found;
  for (const auto& [id, entry] : entries_) {
    if (entry->run.file != file && entry->run.folder.parent_path() != folder) continue;
    const Run& run = entry_of(id)->run;
    const auto refuse = [&](const std::string& why, const char* hint) { return Refusal(409, file, what, why, hint); };
    const std::string its_run = fmt::format("its run \"{}\"", run.name);
    if (run.is_elsewhere) throw refuse(fmt::format("another program is using {}", its_run), "");
    if (run.is_active || run.state == RunState::running) throw refuse(its_run + " is running", "Stop it first");
    if (run.state == RunState::waiting) throw refuse(its_run + " is waiting", "Stop it first");
    found.push_back(entry);
  }
  return found;
}

void RunStore::move_project(const std::string& file, const std::string& to,
                            const std::function<void(const std::vector<fs::path>&)>& move) {
  const std::lock_guard lock(mutex_);
  const auto entries = idle_runs_of(file, "cannot be renamed");
  std::vector<fs::path> calibrations;
  for (const auto& entry : entries)
    if (entry->run.kind == RunKind::calibration) calibrations.push_back(entry->run.folder);
  move(calibrations);
  for (const auto& entry : entries) {
    Run& run = entry->run;
    worker_.unqueue(*entry);
    entry->built.reset();
    entry->calibration.reset();
    run.folder = workplace_.at(runs_folder(to)) / run.folder.filename();
    run.file = to;
    if (!run.is_damaged) changed(run);
  }
}

void RunStore::remove_project(const std::string& file, const std::function<void(std::size_t)>& move) {
  const std::lock_guard lock(mutex_);
  const auto entries = idle_runs_of(file, "cannot be deleted");
  move(entries.size());
  for (const auto& entry : entries) {
    const std::string id = entry->run.id;
    worker_.unqueue(*entry);
    entries_.erase(id);
    events_.publish("removed", id, {{"id", id}});
  }
}

void RunStore::add_project(const std::string& file) {
  const std::lock_guard lock(mutex_);
  for (Run& run : find_runs_in(workplace_.at(runs_folder(file)), workplace_.folder())) {
    const std::string id = run.id;
    for (int k = 2; entries_.contains(run.id); ++k) run.id = fmt::format("{}-{}", id, k);
    const auto entry = std::make_shared<RunEntry>();
    entry->run = std::move(run);
    entries_.emplace(entry->run.id, entry);
    events_.publish("run", entry->run.id, json_of(entry->run));
  }
}

}  // namespace talus::server
