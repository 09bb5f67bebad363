#include "run_store.hpp"

#include <algorithm>
#include <utility>

#include "run_folders.hpp"
#include "talus/archive/run_state.hpp"
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
  run.dimension = std::holds_alternative<Profile>(entry->built->model.surface) ? 2 : 3;
  run.rocks = entry->built->model.rocks();
  run.problems = as_json(seen_from(workplace_.folder(), entry->built->warnings));

  const fs::path parent = fs::path(run.file).parent_path() / "runs" / fs::path(run.file).stem();
  const std::lock_guard lock(mutex_);
  if (worker_.is_closed()) throw Refusal(503, run.file, "cannot be run", why_closing);
  create_run_folder(run, workplace_.at(parent.generic_string()), order.text);
  // Of the queued runs only the first keeps its model in memory.
  if (!worker_.is_idle()) entry->built.reset();
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

}  // namespace talus::server
