#pragma once
// Models of runs, built again from their projects when somebody looks at their results, and kept for a while.

#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "model_reading.hpp"
#include "run.hpp"
#include "run_model.hpp"
#include "workplace.hpp"

namespace talus::server {

class RunModels {
 public:
  RunModels(const Workplace& workplace, ModelReading& reading) : workplace_(workplace), reading_(reading) {}

  /// The model with which the run's rocks were thrown; nothing where it cannot be had any more: the project's files
  /// have changed since.
  [[nodiscard]] std::shared_ptr<const BuiltProject> find(const Run& run);

 private:
  static constexpr std::size_t most_kept = 2;

  const Workplace& workplace_;
  ModelReading& reading_;
  std::mutex mutex_;
  std::deque<std::pair<std::string, std::shared_ptr<const BuiltProject>>> kept_;  // by id; the last used in front
};

}  // namespace talus::server
