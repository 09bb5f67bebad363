#include "run_store.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "talus/archive/run_state.hpp"
#include "talus/core/memory_reserve.hpp"
#include "talus/core/stop.hpp"
#include "talus/files/folder_lock.hpp"
#include "talus/files/output_file.hpp"
#include "talus/project/document.hpp"
#include "talus/project/problem_paths.hpp"
#include "talus/run/run.hpp"

namespace talus::server {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr double checkpoint_every = 5;  // [s]
constexpr auto between_events = std::chrono::milliseconds(100);
constexpr std::size_t longest_name = 200;  // bytes

/// A name that a user gives: shown as text, whatever is in it.
void check_name(const std::string& name) {
  const auto refuse = [&](const char* why) { return Refusal(400, "name", "cannot be the name of a run", why); };
  if (name.empty()) throw refuse("it is empty");
  if (name.size() > longest_name) throw refuse("it is too long");
  if (std::any_of(name.begin(), name.end(), [](unsigned char c) { return c < 32 || c == 127; }))
    throw refuse("it has control characters");
}

/// Names that can stand in an address as they are.
bool can_be_id(const std::string& name) {
  return !name.empty() && name.size() <= 100 && name.front() != '.' &&
         std::all_of(name.begin(), name.end(),
                     [](unsigned char c) { return std::isalnum(c) || c == '-' || c == '_' || c == '.'; });
}

std::vector<fs::path> folders_in(const fs::path& above) {
  std::vector<fs::path> folders;
  std::error_code error;
  for (auto entry = fs::directory_iterator(above, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    std::error_code ignored;
    if (entry->is_directory(ignored) && !entry->is_symlink(ignored)) folders.push_back(entry->path());
  }
  std::sort(folders.begin(), folders.end());
  return folders;
}

bool holds_run(const fs::path& folder) {
  std::error_code ignored;
  return fs::exists(folder / run_file_name, ignored);
}

/// Whether projects may lie there, as in the list of files.
bool may_hold_projects(const fs::path& folder) {
  const std::string name = folder.filename().string();
  return !name.starts_with('.') && name != "node_modules" && !holds_run(folder);
}

/// A new folder there, named by the time.
fs::path new_folder(const fs::path& above) {
  make_output_folder(above);
  for (;;) {
    const auto now = std::chrono::time_point_cast<std::chrono::milliseconds>(std::chrono::system_clock::now());
    const auto part = now.time_since_epoch().count() % 1000;
    fs::path folder =
        above / fmt::format("{:%Y%m%d-%H%M%S}-{:03}", fmt::gmtime(std::chrono::system_clock::to_time_t(now)), part);
    std::error_code error;
    if (fs::create_directory(folder, error)) return folder;
    if (error)
      throw BadInput(Problem{.file = folder.string(), .what = "cannot make this folder", .why = error.message()});
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

/// Makes its folder, with all that makes it a run.
void begin_folder(Run& run, const fs::path& above, const std::string& text) {
  run.folder = new_folder(above);
  run.id = run.folder.filename().string();
  OutputFile project(run.folder / run_project_name);
  project.write(text);
  project.commit();
  keep(run);
}

Refusal not_now(const Run& run, const char* what, const char* why, const char* hint = "") {
  return Refusal(409, run.id, what, why, hint);
}

Json stopped_before_its_results() {
  Problems problems;
  problems.add({.severity = Severity::warning,
                .what = "the run was stopped before its results were written",
                .why = "all its rocks are kept",
                .hint = "Let it go on to write them"});
  return as_json(problems)[0];
}

const char* why_elsewhere = "another program works in its folder";
const char* why_ending = "the server is ending";

}  // namespace

RunStore::RunStore(const Workplace& workplace, EventHub& events, ModelReading& reading)
    : workplace_(workplace), events_(events), reading_(reading) {
  find_runs();
  worker_ = std::thread([this] { work(); });
}

void RunStore::find_runs() {
  const auto add = [&](const fs::path& folder) {
    if (!holds_run(folder) || !can_be_id(folder.filename().string())) return;
    auto entry = std::make_shared<Entry>();
    entry->run = find_run(folder, workplace_.folder());
    // A copied folder has the id of the first.
    const std::string id = entry->run.id;
    for (int k = 2; entries_.contains(entry->run.id); ++k) entry->run.id = fmt::format("{}-{}", id, k);
    entries_[entry->run.id] = entry;
  };
  const auto look_in = [&](const auto& self, const fs::path& above, int depth) -> void {
    for (const fs::path& folder : folders_in(above)) {
      if (!may_hold_projects(folder)) continue;
      if (folder.filename() == "runs") {
        for (const fs::path& project : folders_in(folder))
          for (const fs::path& run : folders_in(project)) add(run);
      }
      if (depth < deepest_project) self(self, folder, depth + 1);
    }
  };
  look_in(look_in, workplace_.folder(), 0);
}

std::shared_ptr<RunStore::Entry> RunStore::entry_of(const std::string& id) {
  const auto found = entries_.find(id);
  if (found == entries_.end()) throw Refusal(404, id, "there is no such run");
  Entry& entry = *found->second;
  if (entry.run.is_elsewhere) {  // what is known of it grows old
    const std::string own_id = entry.run.id;
    entry.run = find_run(entry.run.folder, workplace_.folder());
    entry.run.id = own_id;
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
  auto entry = std::make_shared<Entry>();
  Run& run = entry->run;
  run.file = fs::path(order.file).lexically_normal().generic_string();
  run.asked_rocks = order.rocks;
  run.asked_seed = order.seed;
  run.begun = time_now();
  try {
    entry->built = built(order.text, file, overrides_of(run));
  } catch (const BadInput& bad) {
    throw BadInput(seen_from(workplace_.folder(), project::with_paths(bad.problems(), order.text, file)));
  }
  run.project = entry->built->project.name;
  run.name = order.name.empty() ? run.project : order.name;
  run.dimension = std::holds_alternative<Profile>(entry->built->model.surface) ? 2 : 3;
  run.rocks = entry->built->model.rocks();
  run.problems = as_json(seen_from(workplace_.folder(), entry->built->warnings));

  const fs::path above = fs::path(run.file).parent_path() / "runs" / fs::path(run.file).stem();
  const std::lock_guard lock(mutex_);
  if (is_closed_) throw Refusal(503, run.file, "cannot be run", why_ending);
  begin_folder(run, workplace_.at(above.generic_string()), order.text);
  // Of the runs that wait none but the first holds a model in memory.
  if (under_way_ != nullptr || !queue_.empty()) entry->built.reset();
  entries_[run.id] = entry;
  queue_.push_back({entry, Task::begin});
  events_.publish("run", run.id, json_of(run));
  news_.notify_all();
  return run;
}

Run RunStore::rename(const std::string& id, const std::string& name) {
  check_name(name);
  const std::lock_guard lock(mutex_);
  const auto entry = entry_of(id);
  if (entry->run.is_elsewhere) throw not_now(entry->run, "cannot be renamed", why_elsewhere);
  if (entry->run.is_damaged) throw not_now(entry->run, "cannot be renamed", "its run.json is damaged");
  entry->run.name = name;
  changed(*entry);
  return entry->run;
}

Run RunStore::stop(const std::string& id) {
  const std::lock_guard lock(mutex_);
  const auto entry = entry_of(id);
  Run& run = entry->run;
  if (run.is_elsewhere) throw not_now(run, "cannot be stopped", why_elsewhere);
  if (run.state != RunState::waiting && run.state != RunState::running)
    throw not_now(run, "cannot be stopped", "it is not under way");
  entry->stop = true;
  if (run.is_at_work) return run;
  unqueue(*entry);
  entry->built.reset();
  run.state = RunState::stopped;
  changed(*entry);
  return run;
}

Run RunStore::resume(const std::string& id) {
  const std::lock_guard lock(mutex_);
  const auto entry = entry_of(id);
  Run& run = entry->run;
  if (is_closed_) throw Refusal(503, run.id, "cannot go on", why_ending);
  if (run.is_elsewhere) throw not_now(run, "cannot go on", why_elsewhere);
  if (run.is_damaged) throw not_now(run, "cannot go on", "its run.json is damaged", "Run its project again");
  if (run.state == RunState::waiting || run.state == RunState::running || run.state == RunState::done)
    throw not_now(run, "cannot go on", run.state == RunState::done ? "it is done" : "it is under way");
  unqueue(*entry);
  if (run.is_at_work) entry->stop = true;  // its results so far are being written
  entry->before.reset();
  if (run.state != RunState::failed) entry->before = run.state;
  run.state = RunState::waiting;
  run.problems = Json::array();
  queue_.push_back({entry, Task::resume});
  changed(*entry);
  news_.notify_all();
  return run;
}

Run RunStore::write_what_is_done(const std::string& id) {
  const std::lock_guard lock(mutex_);
  const auto entry = entry_of(id);
  const Run& run = entry->run;
  const char* what = "has nothing to be written";
  if (is_closed_) throw Refusal(503, run.id, what, why_ending);
  if (run.is_elsewhere) throw not_now(run, what, why_elsewhere);
  std::error_code ignored;
  if (run.state != RunState::interrupted) throw not_now(run, what, "it was not interrupted");
  const bool has_done_some =
      fs::exists(run.folder / run_state_name, ignored) || fs::exists(run.folder / "summary.json", ignored);
  if (!has_done_some) throw not_now(run, what, "no rock was done");
  unqueue(*entry);
  queue_.push_back({entry, Task::write_what_is_done});
  news_.notify_all();
  return run;
}

void RunStore::remove(const std::string& id) {
  const std::lock_guard lock(mutex_);
  const auto entry = entry_of(id);
  const Run& run = entry->run;
  if (run.is_elsewhere) throw not_now(run, "cannot be removed", why_elsewhere);
  if (run.is_at_work) throw not_now(run, "cannot be removed", "it is under way", "Stop it first");
  const auto refuse = [&](const char* what, const std::error_code& error) {
    return BadInput(Problem{.file = run.folder.string(), .what = what, .why = error.message()});
  };
  std::error_code error;
  // First what makes it a run: if the rest cannot be removed, it does not come back.
  fs::remove(run.folder / run_file_name, error);
  if (error) throw refuse("cannot remove this folder", error);
  unqueue(*entry);
  entries_.erase(id);
  events_.publish("removed", id, {{"id", id}});
  fs::remove_all(run.folder, error);
  if (error) throw refuse("cannot remove all of this folder", error);
  std::error_code ignored;
  for (const fs::path& above : {run.folder.parent_path(), run.folder.parent_path().parent_path()})
    fs::remove(above, ignored);  // where it is empty now
}

void RunStore::unqueue(const Entry& entry) {
  std::erase_if(queue_, [&](const Job& job) { return job.entry.get() == &entry; });
}

void RunStore::changed(Entry& entry) {
  try {
    keep(entry.run);
  } catch (const BadInput& bad) {
    // A full disk: the run goes on to say so itself, and here its state is known anyway.
    for (const Json& problem : as_json(bad.problems())) entry.run.problems.push_back(problem);
  }
  events_.publish("run", entry.run.id, json_of(entry.run));
}

void RunStore::close() {
  {
    const std::lock_guard lock(mutex_);
    is_closed_ = true;
    if (under_way_) under_way_->stop = true;
    for (const Job& job : queue_) {
      if (job.task == Task::write_what_is_done) continue;  // it stays as it is
      job.entry->run.state = RunState::stopped;
      changed(*job.entry);
    }
    queue_.clear();
    news_.notify_all();
  }
  if (worker_.joinable()) worker_.join();
}

void RunStore::work() {
  lower_priority_of_this_thread();
  LowPriorityArena arena;
  for (;;) {
    Job job;
    {
      std::unique_lock lock(mutex_);
      news_.wait(lock, [&] { return is_closed_ || !queue_.empty(); });
      if (is_closed_) return;
      job = queue_.front();
      queue_.pop_front();
      under_way_ = job.entry;
      job.entry->run.is_at_work = true;
      job.entry->stop = false;
      if (job.task == Task::write_what_is_done) {
        events_.publish("run", job.entry->run.id, json_of(job.entry->run));
      } else {
        job.entry->run.state = RunState::running;
        changed(*job.entry);
      }
    }
    do_job(job, arena);
    std::shared_ptr<BuiltProject> let_go;  // outside of the lock: a large model takes its time
    const std::lock_guard lock(mutex_);
    let_go.swap(job.entry->built);
  }
}

void RunStore::finish(Entry& entry) {
  under_way_.reset();
  entry.run.is_at_work = false;
  entry.run.was_killed = false;
  entry.run.rate.reset();
  changed(entry);
}

void RunStore::fail(Entry& entry, const Problems& problems) {
  const std::lock_guard lock(mutex_);
  entry.run.state = entry.before.value_or(RunState::failed);
  for (const Json& problem : as_json(seen_from(workplace_.folder(), problems))) entry.run.problems.push_back(problem);
  finish(entry);
}

std::shared_ptr<BuiltProject> RunStore::built(const std::string& text, const fs::path& file,
                                              const project::Overrides& overrides) const {
  return *reading_.read<std::shared_ptr<BuiltProject>>(
      "", [=] { return std::make_shared<BuiltProject>(build(text, file, overrides)); });
}

void RunStore::do_job(const Job& job, LowPriorityArena& arena) {
  keep_memory_reserve();
  try {
    simulate_rocks(job, arena);
  } catch (const BadInput& bad) {
    fail(*job.entry, bad.problems());
  } catch (const Stopped&) {
    const std::lock_guard lock(mutex_);
    Entry& entry = *job.entry;
    if (job.task != Task::write_what_is_done) entry.run.state = entry.before.value_or(RunState::stopped);
    finish(entry);
  } catch (const std::exception& error) {
    Problems problems;
    problems.add(Problem{.what = "the run failed", .why = error.what()});
    fail(*job.entry, problems);
  }
}

void RunStore::simulate_rocks(const Job& job, LowPriorityArena& arena) {
  Entry& entry = *job.entry;
  Run run;  // as it is now: no other thread changes what is needed of it
  {
    const std::lock_guard lock(mutex_);
    run = entry.run;
  }
  const auto folder_lock = FolderLock::take(run.folder);
  if (!folder_lock) throw BadInput(Problem{.file = run.folder.string(), .what = "cannot be run", .why = why_elsewhere});
  if (!entry.built) {
    const std::string text = project::text_of_file(run.folder / run_project_name);
    const StopScope scope(&entry.stop);
    entry.built = built(text, workplace_.at(run.file), overrides_of(run));
  }
  {
    const std::lock_guard lock(mutex_);
    entry.run.problems = as_json(seen_from(workplace_.folder(), entry.built->warnings));
  }
  std::error_code ignored;
  const bool goes_on = job.task != Task::begin;
  const fs::path state = run.folder / run_state_name;
  const double seconds_before = goes_on && fs::exists(state, ignored) ? read_run_state_header(state).seconds : 0;

  project::RunOptions options;
  options.campaign.stop = &entry.stop;
  options.lock = &*folder_lock;
  options.resume = goes_on;
  options.only_results = job.task == Task::write_what_is_done;
  options.checkpoint_every = checkpoint_every;
  std::optional<std::uint64_t> done_before;
  Clock::time_point begun, published_at;
  options.campaign.progress = [&](std::uint64_t done) {
    const auto now = Clock::now();
    if (!done_before) {
      done_before = done;
      begun = now;
    }
    const std::lock_guard lock(mutex_);
    entry.before.reset();
    const double seconds = std::chrono::duration<double>(now - begun).count();
    entry.run.done = done;
    entry.run.seconds = seconds_before + seconds;
    if (seconds > 0) entry.run.rate = static_cast<double>(done - *done_before) / seconds;
    if (now - published_at < between_events) return;
    published_at = now;
    events_.publish("run", entry.run.id, json_of(entry.run));
  };
  const project::RunResult result = arena.execute([&] {
    return project::run_into(run.folder, entry.built->project, entry.built->model, entry.built->warnings, options);
  });

  const std::lock_guard lock(mutex_);
  for (const Json& problem : as_json(seen_from(workplace_.folder(), result.warnings)))
    entry.run.problems.push_back(problem);
  if (!result.was_complete) {
    entry.run.done = result.summary.done;
    entry.run.seconds = seconds_before + result.outcome.seconds;
  } else {
    entry.run.done = entry.run.rocks;
  }
  if (!result.outcome.interrupted && result.has_results) {
    entry.run.state = RunState::done;
  } else if (job.task != Task::write_what_is_done) {
    entry.run.state = RunState::stopped;
  }
  if (!result.has_results && !result.outcome.interrupted) entry.run.problems.push_back(stopped_before_its_results());
  finish(entry);
  // Whoever stopped it waits no longer, and gets its results when they are there.
  const bool wants_results = !result.has_results && result.outcome.interrupted && entry.run.state == RunState::stopped;
  if (wants_results && !is_closed_ && job.task != Task::write_what_is_done)
    queue_.push_front({job.entry, Task::write_what_is_done});
}

}  // namespace talus::server
