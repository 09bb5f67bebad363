#pragma once
// The queue of runs, and the thread that simulates them one after the other at low priority.

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "events.hpp"
#include "low_priority.hpp"
#include "model_reading.hpp"
#include "run_entry.hpp"
#include "talus/files/folder_lock.hpp"
#include "talus/run/run.hpp"
#include "workplace.hpp"

namespace talus::server {

class RunWorker {
 public:
  enum class Task { begin, resume, write_results };

  /// `mutex` guards the runs of all entries and the queue. Functions that expect the lock are marked; the others take
  /// it themselves.
  RunWorker(const Workplace& workplace, EventHub& events, ModelReading& reading, std::mutex& mutex);
  RunWorker(const RunWorker&) = delete;
  RunWorker& operator=(const RunWorker&) = delete;
  ~RunWorker() { close(); }

  /// Expects the lock.
  void enqueue(std::shared_ptr<RunEntry> entry, Task task);
  /// Removes a run's jobs from the queue. Expects the lock.
  void unqueue(const RunEntry& entry);
  /// No run is in progress or queued. Expects the lock.
  [[nodiscard]] bool is_idle() const { return current_ == nullptr && queue_.empty(); }
  /// Expects the lock.
  [[nodiscard]] bool is_closed() const { return is_closed_; }

  /// Stops the current run and those in the queue, and waits for the thread to end.
  void close();

 private:
  struct Job {
    std::shared_ptr<RunEntry> entry;
    Task task;
  };

  void work();
  void do_job(const Job& job, LowPriorityArena& arena);
  void simulate(const Job& job, LowPriorityArena& arena);
  void calibrate(const Job& job, LowPriorityArena& arena);
  /// Builds the model if it is not in memory, and stores its warnings in the run.
  void load_model(RunEntry& entry, const Run& run) const;
  /// The callback of a campaign: updates the run and publishes it at most ten times a second.
  [[nodiscard]] std::function<void(std::uint64_t)> progress_of(RunEntry& entry, double seconds_before);
  /// Stores the outcome in the run, and queues the writing of results that are missing.
  void record(const Job& job, const project::RunResult& result, double seconds_before);
  void fail(RunEntry& entry, const Problems& problems);
  /// Adds problems to the run. Expects the lock.
  void add_problems(Run& run, const Problems& problems) const;
  /// Ends the current run, whose state is final. Expects the lock.
  void finish(RunEntry& entry);

  const Workplace& workplace_;
  EventHub& events_;
  ModelReading& reading_;
  std::mutex& mutex_;
  std::condition_variable changed_;  // the queue, or is_closed_
  std::deque<Job> queue_;
  std::shared_ptr<RunEntry> current_;
  bool is_closed_ = false;
  std::thread thread_;
};

}  // namespace talus::server
