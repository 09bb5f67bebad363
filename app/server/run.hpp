#pragma once
// A run: what the API reports of it, and what its folder keeps in run.json.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "http/answer.hpp"
#include "talus/project/read.hpp"

namespace talus::server {

enum class RunState {
  waiting,  // for earlier runs
  running,
  done,
  stopped,      // by request; can be resumed
  interrupted,  // its server was killed; can be resumed
  failed
};

enum class RunKind { run, calibration };

/// Of a calibration, `rocks` and `done` count sets of parameters, and `rate` sets per second.
struct Run {
  std::string id, name;
  RunKind kind = RunKind::run;
  std::string study;    // of a calibration: its study file, beside the project
  std::string file;     // of the project, relative to the folder that is served
  std::string project;  // the project's name
  RunState state = RunState::waiting;
  int dimension = 3;
  std::uint64_t rocks = 0, done = 0;
  double seconds = 0;          // spent on the finished rocks
  std::optional<double> rate;  // [rocks/s]
  std::string begun;           // time of the request: ISO 8601, UTC
  Json problems = Json::array();
  std::filesystem::path folder;
  bool is_active = false;     // the worker is writing files in its folder
  bool was_killed = false;    // it was waiting or running when its server ended, and its files are unchanged since
  bool is_damaged = false;    // its run.json cannot be read
  bool is_elsewhere = false;  // another server is running it

  // Settings of the request that override the project's text.
  std::optional<std::int64_t> asked_rocks;
  std::optional<std::uint64_t> asked_seed;
};

/// Whether its results can be read: all are written, and none is being written.
[[nodiscard]] bool has_results(const Run& run);

/// A run in answers of the API. `base`: the folder that is served.
[[nodiscard]] Json json_of(const Run& run, const std::filesystem::path& base);

inline constexpr const char* run_file_name = "run.json";
inline constexpr const char* run_project_name = "project.toml";
inline constexpr const char* run_study_name = "study.toml";  // of a calibration

/// Writes FOLDER/run.json. Throws BadInput if that fails.
void save(const Run& run);
/// Reads the run of a folder. A waiting or running one is interrupted, unless another server is running it. If run.json
/// is damaged the state is `failed`, with the reasons, and members are filled in as far as possible. `base`: the folder
/// that is served.
[[nodiscard]] Run read_run(const std::filesystem::path& folder, const std::filesystem::path& base);

[[nodiscard]] inline project::Overrides overrides_of(const Run& run) {
  return {.settings = {}, .rocks = run.asked_rocks, .seed = run.asked_seed};
}

/// The current time in UTC: 2026-11-21T16:55:12Z.
[[nodiscard]] std::string time_now();

}  // namespace talus::server
