#pragma once
// Models of runs, rebuilt from their projects when results need them, and cached.

#include <deque>
#include <memory>
#include <mutex>
#include <string>

#include "model_reading.hpp"
#include "run.hpp"
#include "run_model.hpp"
#include "workplace.hpp"

namespace talus::server {

class RunModels {
 public:
  /// Caches models of `most_bytes` in total, or a single larger one.
  RunModels(const Workplace& workplace, ModelReading& reading, std::size_t most_bytes)
      : workplace_(workplace), reading_(reading), most_bytes_(most_bytes) {}

  /// The model with which the run was simulated; null if it can no longer be built, because the project's files have
  /// changed.
  [[nodiscard]] std::shared_ptr<const BuiltProject> find(const Run& run);

 private:
  struct Kept {
    std::string run;  // its id
    std::shared_ptr<const BuiltProject> built;
    std::size_t bytes;
  };

  const Workplace& workplace_;
  ModelReading& reading_;
  std::mutex mutex_;
  std::size_t most_bytes_;
  std::deque<std::shared_ptr<const Kept>> kept_;  // most recently used first
};

}  // namespace talus::server
