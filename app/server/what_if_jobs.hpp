#pragma once
// What if, beside finished runs: one job at a time, in the background at low priority. A new one stops the last.

#include <atomic>
#include <chrono>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "asked_runs.hpp"
#include "http/answer.hpp"
#include "talus/lines/what_if.hpp"

namespace talus::server {

/// A request about a run.
struct WhatIfOrder {
  std::shared_ptr<OpenRun> run;
  Json question;                             // as it was asked, for the answer
  Json overrides;                            // `rocks` and `seed` of the run's request, or null
  std::unique_ptr<what_if::WhatIf> what_if;  // of run->built
  Problems warnings;
  what_if::RunOptions options;
};

/// Thread-safe.
class WhatIfJobs {
 public:
  WhatIfJobs() = default;
  WhatIfJobs(const WhatIfJobs&) = delete;
  WhatIfJobs& operator=(const WhatIfJobs&) = delete;
  ~WhatIfJobs() { close(); }

  /// Begins a job, which replaces the run's last one, and returns its state. Refuses (503) once closed.
  Json begin(WhatIfOrder order);
  /// Of the last job of a run; null if it has none, or if later ones have pushed it out.
  [[nodiscard]] Json state_of(const std::string& run) const;
  /// Stops the job of a run; what is done is kept. Refuses (404) if it has none.
  Json stop(const std::string& run);
  /// Stops the job in progress, and waits for it. Later ones are refused.
  void close();

 private:
  static constexpr std::size_t most_jobs = 10;
  struct Job;

  void work(Job& job) const;
  [[nodiscard]] Json json_of(const Job& job) const;
  /// Null: none. Expects `mutex_`.
  [[nodiscard]] std::shared_ptr<Job> job_of(const std::string& run) const;
  /// Stops the thread, if there is one. Expects `starting_`.
  void end_thread();

  std::mutex starting_;                    // held while a job is replaced
  mutable std::mutex mutex_;               // of what follows, and of the states of the jobs
  std::deque<std::shared_ptr<Job>> jobs_;  // newest first; only this one may be running
  std::thread thread_;
  bool is_closed_ = false;
};

}  // namespace talus::server
