#pragma once
// The runs of the folder that is worked in: found there, thrown one after the other, kept.

#include <condition_variable>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "events.hpp"
#include "low_priority.hpp"
#include "model_reading.hpp"
#include "run.hpp"
#include "run_model.hpp"
#include "workplace.hpp"

namespace talus::server {

/// What somebody wants to have run.
struct RunOrder {
  std::string file;  // the project's, relative to the folder that is worked in
  std::string text;  // of the project
  std::string name;  // of the run; empty: the project's
  std::optional<std::int64_t> rocks;
  std::optional<std::uint64_t> seed;
};

/// Every function may be called by any thread. An id that is none is refused with 404, what a run's state does not
/// allow with 409.
class RunStore {
 public:
  /// Finds the runs of earlier servers. Nothing of them is read but what they say of themselves: a folder may come from
  /// anywhere, and nobody has asked for its runs yet.
  RunStore(const Workplace& workplace, EventHub& events, ModelReading& reading);
  RunStore(const RunStore&) = delete;
  RunStore& operator=(const RunStore&) = delete;
  ~RunStore() { close(); }

  /// Newest first.
  [[nodiscard]] std::vector<Run> list();
  [[nodiscard]] Run find(const std::string& id);
  [[nodiscard]] Json json_of(const Run& run) const { return server::json_of(run, workplace_.folder()); }
  /// The project's file, which need not be there any more.
  [[nodiscard]] std::filesystem::path project_file(const Run& run) const { return workplace_.at(run.file); }

  /// Throws BadInput with all problems of the project and its model. Refuses (503) once the store is closed.
  Run begin(const RunOrder& order);
  Run rename(const std::string& id, const std::string& name);
  /// What is done is kept. Of one that is under way rocks are left at once, and results that take long follow it.
  Run stop(const std::string& id);
  /// Refuses (503) once the store is closed.
  Run resume(const std::string& id);
  /// Writes the results of a run whose server was killed, as far as its last checkpoint. Refuses (503) once the store
  /// is closed.
  Run write_what_is_done(const std::string& id);
  /// Throws BadInput where its folder cannot be removed; if only a part of it can, the run is gone all the same.
  void remove(const std::string& id);

  /// Stops the run under way and waits for it. None begins any more.
  void close();

 private:
  struct Entry {
    Run run;
    std::atomic<bool> stop{false};
    std::shared_ptr<BuiltProject> built;  // where it is at hand
    // What it was before it was to go on, as long as no rock is thrown: its results are still there.
    std::optional<RunState> before;
  };
  enum class Task { begin, resume, write_what_is_done };
  struct Job {
    std::shared_ptr<Entry> entry;
    Task task;
  };

  void find_runs();
  void work();
  void do_job(const Job& job, LowPriorityArena& arena);
  void simulate_rocks(const Job& job, LowPriorityArena& arena);
  void fail(Entry& entry, const Problems& problems);
  [[nodiscard]] std::shared_ptr<BuiltProject> built(const std::string& text, const std::filesystem::path& file,
                                                    const project::Overrides& overrides) const;
  /// The worker is done with a run, whose state is its last. Expects the lock.
  void finish(Entry& entry);
  /// Keeps a run that has changed, and tells it. Expects the lock.
  void changed(Entry& entry);
  [[nodiscard]] std::shared_ptr<Entry> entry_of(const std::string& id);
  /// Takes a run's jobs out of the queue. Expects the lock.
  void unqueue(const Entry& entry);

  const Workplace& workplace_;
  EventHub& events_;
  ModelReading& reading_;
  std::mutex mutex_;
  std::condition_variable news_;
  std::map<std::string, std::shared_ptr<Entry>> entries_;
  std::deque<Job> queue_;
  std::shared_ptr<Entry> under_way_;
  bool is_closed_ = false;
  std::thread worker_;
};

}  // namespace talus::server
