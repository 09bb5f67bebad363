#pragma once
// A run with the state that the store and its worker share.

#include <atomic>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "events.hpp"
#include "model_reading.hpp"
#include "run.hpp"
#include "run_model.hpp"
#include "run_watch.hpp"
#include "talus/calibration/calibrate.hpp"

namespace talus::server {

inline constexpr const char* why_elsewhere = "another program is using its folder";
inline constexpr const char* why_closing = "the server is shutting down";

struct PreparedCalibration {
  calibration::PreparedStudy study;
  Problems warnings;
};

struct RunEntry {
  Run run;
  std::atomic<bool> stop{false};
  std::shared_ptr<BuiltProject> built;               // null: built when its turn comes
  std::shared_ptr<PreparedCalibration> calibration;  // likewise, of a calibration
  std::shared_ptr<RunWatch> watch;                   // of a run in progress; null: nothing to watch yet
  // Of a resumed run, its state before, until the first rock is finished: until then its earlier results remain.
  std::optional<RunState> state_before;
};

/// Writes run.json and publishes the run. If writing fails, adds the problems to the run instead of throwing.
void save_and_publish(Run& run, const std::filesystem::path& base, EventHub& events);

/// Reads the observations of a study, and builds the models of its projects. Throws BadInput with all problems, and as
/// ModelReading::read().
[[nodiscard]] std::shared_ptr<PreparedCalibration> prepare_calibration(ModelReading& reading,
                                                                       const calibration::StudyReading& study);

/// Builds the model of a project's text. Throws BadInput with all problems, and as ModelReading::read().
[[nodiscard]] std::shared_ptr<BuiltProject> build_for_run(ModelReading& reading, const std::string& text,
                                                          const std::filesystem::path& file,
                                                          const project::Overrides& overrides);

}  // namespace talus::server
