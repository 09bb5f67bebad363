#pragma once
// The runs of the folder that is served: found at the start, added, run, stopped, resumed and removed by requests.

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "events.hpp"
#include "model_reading.hpp"
#include "run.hpp"
#include "run_entry.hpp"
#include "run_worker.hpp"
#include "workplace.hpp"

namespace talus::server {

/// A request for a new run.
struct RunOrder {
  std::string file;  // of the project, relative to the folder that is served
  std::string text;  // of the project
  std::string name;  // of the run; empty: the project's
  std::optional<std::int64_t> rocks;
  std::optional<std::uint64_t> seed;
};

/// A request for a calibration.
struct CalibrationOrder {
  std::string file;      // of the study, relative to the folder that is served; its name ends in .study.toml
  std::string text;      // of the study
  bool replace = false;  // the file, if it exists
};

/// All functions may be called by any thread. They refuse an unknown id (404) and what a run's state does not allow
/// (409).
class RunStore {
 public:
  /// Finds the runs of earlier servers by their run.json. Reads nothing else of them: the folder may come from
  /// anywhere.
  RunStore(const Workplace& workplace, EventHub& events, ModelReading& reading);
  RunStore(const RunStore&) = delete;
  RunStore& operator=(const RunStore&) = delete;

  /// Newest first.
  [[nodiscard]] std::vector<Run> list();
  [[nodiscard]] Run find(const std::string& id);
  /// What a run in progress has found so far. Refuses (404) a run that is not in progress, and calibrations.
  [[nodiscard]] std::shared_ptr<const RunWatch> watch(const std::string& id);
  [[nodiscard]] Json json_of(const Run& run) const { return server::json_of(run, workplace_.folder()); }
  /// The project's file, which may no longer exist.
  [[nodiscard]] std::filesystem::path project_file(const Run& run) const { return workplace_.at(run.file); }

  /// Throws BadInput with all problems of the project and its model. Refuses (503) once the store is closed.
  Run begin(const RunOrder& order);
  /// Writes the study file. Its first site's project must be beside it. Throws BadInput with all problems of the study,
  /// its observations and its projects; refuses (409) to replace another text unasked.
  Run begin(const CalibrationOrder& order);
  Run rename(const std::string& id, const std::string& name);
  /// Keeps the rocks that are finished. A run in progress abandons the others at once; results that take long to write
  /// follow later.
  Run stop(const std::string& id);
  /// Refuses (503) once the store is closed.
  Run resume(const std::string& id);
  /// Writes the results of a run whose server was killed, up to its last checkpoint. Refuses (503) once the store is
  /// closed.
  Run write_results(const std::string& id);
  /// Throws BadInput if the folder cannot be removed. If only a part of it is left, the run is gone nevertheless.
  void remove(const std::string& id);

  // Of a project whose files are moved or deleted with its runs. `move` does this while no run can begin. They refuse
  // (409) if one is waiting or running. `file` and `to` are relative to the folder that is served, and are in one
  // folder there.

  /// `move` gets the folders of its calibrations, whose studies name the project.
  void move_project(const std::string& file, const std::string& to,
                    const std::function<void(const std::vector<std::filesystem::path>&)>& move);
  /// `move` gets the number of its runs.
  void remove_project(const std::string& file, const std::function<void(std::size_t)>& move);
  /// Finds the runs of a project that is in its place again.
  void add_project(const std::string& file);

  /// Stops the current run and waits for it. Later runs are refused.
  void close() { worker_.close(); }

 private:
  using Entries = std::map<std::string, std::shared_ptr<RunEntry>>;

  /// Expects the lock.
  [[nodiscard]] std::shared_ptr<RunEntry> entry_of(const std::string& id);
  /// The runs of a project. Refuses (409) if one is waiting or running. Expects the lock.
  [[nodiscard]] std::vector<std::shared_ptr<RunEntry>> idle_runs_of(const std::string& file, const char* what);
  /// Puts a run with its texts into a new folder and into the queue.
  Run queue(const std::shared_ptr<RunEntry>& entry, const std::string& project, const std::string& study);
  /// Saves and publishes a run. Expects the lock.
  void changed(Run& run) { save_and_publish(run, workplace_.folder(), events_); }

  const Workplace& workplace_;
  EventHub& events_;
  ModelReading& reading_;
  std::mutex mutex_;
  Entries entries_;
  RunWorker worker_;
};

}  // namespace talus::server
