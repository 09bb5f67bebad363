#include "run_worker.hpp"

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "talus/archive/run_state.hpp"
#include "talus/calibration/result_files.hpp"
#include "talus/core/memory_reserve.hpp"
#include "talus/core/stop.hpp"
#include "talus/project/document.hpp"

namespace talus::server {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr double checkpoint_every = 5;  // [s]
constexpr auto between_events = std::chrono::milliseconds(100);

Json stopped_before_its_results() {
  Problems problems;
  problems.add({.severity = Severity::warning,
                .what = "the run was stopped before its results were written",
                .why = "all its rocks are kept",
                .hint = "Resume it to write them"});
  return as_json(problems)[0];
}

}  // namespace

RunWorker::RunWorker(const Workplace& workplace, EventHub& events, ModelReading& reading, std::mutex& mutex)
    : workplace_(workplace), events_(events), reading_(reading), mutex_(mutex) {
  thread_ = std::thread([this] { work(); });
}

void RunWorker::enqueue(std::shared_ptr<RunEntry> entry, Task task) {
  queue_.push_back({std::move(entry), task});
  changed_.notify_all();
}

void RunWorker::unqueue(const RunEntry& entry) {
  std::erase_if(queue_, [&](const Job& job) { return job.entry.get() == &entry; });
}

void RunWorker::close() {
  {
    const std::lock_guard lock(mutex_);
    is_closed_ = true;
    if (current_) current_->stop = true;
    for (const Job& job : queue_) {
      if (job.task == Task::write_results) continue;  // remains interrupted
      job.entry->run.state = RunState::stopped;
      save_and_publish(job.entry->run, workplace_.folder(), events_);
    }
    queue_.clear();
    changed_.notify_all();
  }
  if (thread_.joinable()) thread_.join();
}

void RunWorker::work() {
  lower_priority_of_this_thread();
  LowPriorityArena arena;
  for (;;) {
    Job job;
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [&] { return is_closed_ || !queue_.empty(); });
      if (is_closed_) return;
      job = queue_.front();
      queue_.pop_front();
      current_ = job.entry;
      Run& run = job.entry->run;
      run.is_active = true;
      job.entry->stop = false;
      if (job.task == Task::write_results) {
        events_.publish("run", run.id, json_of(run, workplace_.folder()));
      } else {
        run.state = RunState::running;
        save_and_publish(run, workplace_.folder(), events_);
      }
    }
    do_job(job, arena);
    std::shared_ptr<BuiltProject> released;  // destroyed after the lock: freeing a large model takes a while
    std::shared_ptr<PreparedCalibration> released_study;
    const std::lock_guard lock(mutex_);
    released.swap(job.entry->built);
    released_study.swap(job.entry->calibration);
  }
}

void RunWorker::finish(RunEntry& entry) {
  current_.reset();
  entry.watch.reset();
  entry.run.is_active = false;
  entry.run.was_killed = false;
  entry.run.rate.reset();
  save_and_publish(entry.run, workplace_.folder(), events_);
}

void RunWorker::add_problems(Run& run, const Problems& problems) const {
  for (const Json& problem : as_json(seen_from(workplace_.folder(), problems))) run.problems.push_back(problem);
}

void RunWorker::fail(RunEntry& entry, const Problems& problems) {
  const std::lock_guard lock(mutex_);
  entry.run.state = entry.state_before.value_or(RunState::failed);
  add_problems(entry.run, problems);
  finish(entry);
}

void RunWorker::do_job(const Job& job, LowPriorityArena& arena) {
  keep_memory_reserve();
  try {
    if (job.entry->run.kind == RunKind::calibration) {
      calibrate(job, arena);
    } else {
      simulate(job, arena);
    }
  } catch (const BadInput& bad) {
    fail(*job.entry, bad.problems());
  } catch (const Stopped&) {
    const std::lock_guard lock(mutex_);
    RunEntry& entry = *job.entry;
    if (job.task != Task::write_results) entry.run.state = entry.state_before.value_or(RunState::stopped);
    finish(entry);
  } catch (const std::exception& error) {
    Problems problems;
    problems.add(Problem{.what = "the run failed", .why = error.what()});
    fail(*job.entry, problems);
  }
}

void RunWorker::load_model(RunEntry& entry, const Run& run) const {
  if (!entry.built) {
    const std::string text = project::text_of_file(run.folder / run_project_name);
    const StopScope scope(&entry.stop);
    entry.built = build_for_run(reading_, text, workplace_.at(run.file), overrides_of(run));
  }
  const std::lock_guard lock(mutex_);
  entry.run.problems = Json::array();
  add_problems(entry.run, entry.built->warnings);
}

std::function<void(std::uint64_t)> RunWorker::progress_of(RunEntry& entry, double seconds_before) {
  struct Start {
    std::uint64_t done;
    Clock::time_point time;
  };
  struct State {  // shared by copies of the function
    std::optional<Start> start;
    Clock::time_point published_at;
  };
  return [this, &entry, seconds_before, state = std::make_shared<State>()](std::uint64_t done) {
    const auto now = Clock::now();
    if (!state->start) state->start = Start{done, now};
    const std::lock_guard lock(mutex_);
    entry.state_before.reset();
    const double seconds = std::chrono::duration<double>(now - state->start->time).count();
    entry.run.done = done;
    entry.run.seconds = seconds_before + seconds;
    if (seconds > 0) entry.run.rate = static_cast<double>(done - state->start->done) / seconds;
    if (now - state->published_at < between_events) return;
    state->published_at = now;
    events_.publish("run", entry.run.id, json_of(entry.run, workplace_.folder()));
  };
}

void RunWorker::simulate(const Job& job, LowPriorityArena& arena) {
  RunEntry& entry = *job.entry;
  Run run;  // a copy: no other thread changes the members that are used here
  {
    const std::lock_guard lock(mutex_);
    run = entry.run;
  }
  const auto folder_lock = FolderLock::take(run.folder);
  if (!folder_lock) throw BadInput(Problem{.file = run.folder.string(), .what = "cannot be run", .why = why_elsewhere});
  load_model(entry, run);

  const bool resumes = job.task != Task::begin;
  const fs::path state = run.folder / run_state_name;
  std::error_code ignored;
  const double seconds_before = resumes && fs::exists(state, ignored) ? read_run_state_header(state).seconds : 0;

  const auto watch = std::make_shared<RunWatch>(entry.built->model);
  {
    const std::lock_guard lock(mutex_);
    entry.watch = watch;
  }
  project::RunOptions options;
  options.watch = watch.get();
  options.so_far = [&](const Summary& summary) { watch->take(summary); };
  options.campaign.stop = &entry.stop;
  options.campaign.progress = progress_of(entry, seconds_before);
  options.lock = &*folder_lock;
  options.resume = resumes;
  options.only_results = job.task == Task::write_results;
  options.checkpoint_every = checkpoint_every;
  const project::RunResult result = arena.execute([&] {
    return project::run_into(run.folder, entry.built->project, entry.built->model, entry.built->warnings, options);
  });
  record(job, result, seconds_before);
}

void RunWorker::calibrate(const Job& job, LowPriorityArena& arena) {
  RunEntry& entry = *job.entry;
  Run run;  // a copy: no other thread changes the members that are used here
  {
    const std::lock_guard lock(mutex_);
    run = entry.run;
  }
  if (!entry.calibration) {
    const std::string text = project::text_of_file(run.folder / run_study_name);
    const fs::path file = workplace_.at((fs::path(run.file).parent_path() / run.study).generic_string());
    const StopScope scope(&entry.stop);
    entry.calibration = prepare_calibration(reading_, calibration::read_study_text(text, file));
  }
  {
    const std::lock_guard lock(mutex_);
    entry.run.problems = Json::array();
    add_problems(entry.run, entry.calibration->warnings);
  }
  const auto progress = progress_of(entry, 0);
  const calibration::CalibrationResult result = arena.execute([&] {
    const StopScope scope(&entry.stop);
    return calibration::calibrate_into(run.folder, entry.calibration->study,
                                       {.progress = [&](std::size_t done, std::size_t all) {
                                         {
                                           const std::lock_guard lock(mutex_);
                                           entry.run.rocks = all;
                                         }
                                         progress(done);
                                       }});
  });
  const std::lock_guard lock(mutex_);
  add_problems(entry.run, result.warnings);
  entry.run.done = entry.run.rocks = result.sets.size();
  entry.run.state = RunState::done;
  finish(entry);
}

void RunWorker::record(const Job& job, const project::RunResult& result, double seconds_before) {
  const std::lock_guard lock(mutex_);
  Run& run = job.entry->run;
  const bool is_interrupted = result.outcome.interrupted;
  add_problems(run, result.warnings);
  if (!result.was_complete) {
    run.done = result.summary.done;
    run.seconds = seconds_before + result.outcome.seconds;
  } else {
    run.done = run.rocks;
  }
  if (!is_interrupted && result.has_results) {
    run.state = RunState::done;
  } else if (job.task != Task::write_results) {
    run.state = RunState::stopped;
  }
  if (!result.has_results && !is_interrupted) run.problems.push_back(stopped_before_its_results());
  finish(*job.entry);
  // The run is reported as stopped at once; its results are written next.
  const bool lacks_results = !result.has_results && is_interrupted && run.state == RunState::stopped;
  if (lacks_results && !is_closed_ && job.task != Task::write_results)
    queue_.push_front({job.entry, Task::write_results});
}

}  // namespace talus::server
