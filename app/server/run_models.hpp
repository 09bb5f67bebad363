#pragma once
// Models of runs, built again from their projects when somebody looks at their results, and kept for a while.

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
  /// Keeps models of so many bytes, or one that is larger.
  RunModels(const Workplace& workplace, ModelReading& reading, std::size_t most_bytes)
      : workplace_(workplace), reading_(reading), most_bytes_(most_bytes) {}

  /// The model with which the run's rocks were thrown; nothing where it cannot be had any more: the project's files
  /// have changed since.
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
  std::deque<std::shared_ptr<const Kept>> kept_;  // the last used in front
};

}  // namespace talus::server
