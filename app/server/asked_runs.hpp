#pragma once
// Runs that lines are asked of, with their models and stores of trajectories; and selections of rocks for filters.

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "http/router.hpp"
#include "run_models.hpp"
#include "talus/lines/asked_run.hpp"

namespace talus::server {

/// A run with its model and the trajectories of its rocks. Valid while it is held.
struct OpenRun {
  std::string id, stamp;  // of the run; the size and time of its store
  std::shared_ptr<const BuiltProject> built;
  std::unique_ptr<const AskedRun> asked;
  std::mutex asking;  // one answer at a time: it uses all cores
};

/// Thread-safe.
class AskedRuns {
 public:
  explicit AskedRuns(RunModels& models) : models_(models) {}

  /// Throws BadInput if the run has no trajectories or its project's files have changed.
  [[nodiscard]] std::shared_ptr<OpenRun> open(const Run& run);

  /// Where the run's rocks are released. Throws BadInput if its project's files have changed.
  [[nodiscard]] std::shared_ptr<const ReleaseSpots> releases(const Run& run);

  /// Remembers rocks, ascending, under a name for filters.
  [[nodiscard]] std::string remember(const std::string& run, std::vector<std::uint64_t> rocks);
  /// The rocks of a selection. Refuses (404) one that is unknown, of another run or no longer kept.
  [[nodiscard]] std::shared_ptr<const std::vector<std::uint64_t>> selection(const std::string& run,
                                                                            const std::string& name) const;

  /// Requests of one drag come in order of their numbers. False if a later one has been seen.
  [[nodiscard]] bool is_latest(const std::string& drag, std::uint64_t number);

 private:
  static constexpr std::size_t most_open = 2, most_selections = 200, most_drags = 100;
  struct Selection {
    std::string name, run;
    std::shared_ptr<const std::vector<std::uint64_t>> rocks;
  };
  struct Drag {
    std::string id;
    std::uint64_t latest;
  };

  RunModels& models_;
  mutable std::mutex mutex_;
  std::deque<std::shared_ptr<OpenRun>> open_;  // most recently used first
  std::deque<Selection> selections_;           // latest last
  std::deque<Drag> drags_;
  std::string released_;  // the run of releases_
  std::shared_ptr<const ReleaseSpots> releases_;
  std::uint64_t count_ = 0;  // of selections so far
};

/// Which rocks pass the filters `crossing` and `release` of a request; empty: all. Refuses what the run does not have.
[[nodiscard]] std::function<bool(std::uint64_t rock)> rocks_passing(const Call& call, const Run& run, AskedRuns& asked);

}  // namespace talus::server
