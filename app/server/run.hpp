#pragma once
// A run as the server knows it: what the page is told, and what lies in the run's folder as run.json.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "http/answer.hpp"
#include "talus/project/read.hpp"

namespace talus::server {

enum class RunState {
  waiting,  // for those before it
  running,
  done,
  stopped,      // somebody wished so; it can go on
  interrupted,  // its server was killed; it can go on
  failed
};

struct Run {
  std::string id, name;
  std::string file;     // the project's, relative to the folder that is worked in
  std::string project;  // its name
  RunState state = RunState::waiting;
  int dimension = 3;
  std::uint64_t rocks = 0, done = 0;
  double seconds = 0;          // spent on those that are done
  std::optional<double> rate;  // [rocks/s]
  std::string begun;           // when it was asked for: ISO 8601, UTC
  Json problems = Json::array();
  std::filesystem::path folder;
  bool is_at_work = false;    // files are being written in its folder
  bool was_killed = false;    // it was under way, or waiting, when its server ended, and nothing was written since
  bool is_damaged = false;    // its run.json cannot be read
  bool is_elsewhere = false;  // another server is throwing its rocks

  // What the request said differently from the project's text.
  std::optional<std::int64_t> asked_rocks;
  std::optional<std::uint64_t> asked_seed;
};

/// Whether its results can be looked at: all are written, and none is being written.
[[nodiscard]] bool has_results(const Run& run);

/// As the page is told; `base` is the folder that is worked in.
[[nodiscard]] Json json_of(const Run& run, const std::filesystem::path& base);

inline constexpr const char* run_file_name = "run.json";
inline constexpr const char* run_project_name = "project.toml";

/// Writes FOLDER/run.json. Throws BadInput where that fails.
void keep(const Run& run);
/// Reads the run of a folder. One that was under way or waiting is interrupted, unless another server has it; of one
/// whose run.json is damaged what can be known is given, with the state `failed` and the reasons. `base`: the folder
/// that is worked in.
[[nodiscard]] Run find_run(const std::filesystem::path& folder, const std::filesystem::path& base);

[[nodiscard]] inline project::Overrides overrides_of(const Run& run) {
  return {.settings = {}, .rocks = run.asked_rocks, .seed = run.asked_seed};
}

/// Now, in UTC: 2026-11-21T16:55:12Z.
[[nodiscard]] std::string time_now();

}  // namespace talus::server
