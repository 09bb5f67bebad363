#include "run.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

#include "talus/archive/run_state.hpp"
#include "talus/files/folder_lock.hpp"
#include "talus/files/json_file.hpp"
#include "talus/files/output_file.hpp"

namespace talus::server {

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::pair<RunState, const char*>, 6> states{{{RunState::waiting, "waiting"},
                                                                  {RunState::running, "running"},
                                                                  {RunState::done, "done"},
                                                                  {RunState::stopped, "stopped"},
                                                                  {RunState::interrupted, "interrupted"},
                                                                  {RunState::failed, "failed"}}};

constexpr const char* calibration_word = "calibration";

const char* name(RunKind kind) { return kind == RunKind::calibration ? calibration_word : "run"; }

const char* name(RunState state) {
  return std::find_if(states.begin(), states.end(), [&](const auto& known) { return known.first == state; })->second;
}

constexpr const char* hint = "The run's other files may be intact";

[[noreturn]] void refuse(const fs::path& file, std::string where, std::string what, std::string why) {
  refuse_json_file(file, std::move(where), std::move(what), std::move(why), hint);
}

/// The value of a key; refused if it is missing or of another type.
template <class Value>
Value value_of(const Json& json, const char* key, const fs::path& file) {
  const auto found = json.find(key);
  if (found == json.end()) refuse(file, key, "is missing", "every run.json has it");
  bool fits = false;
  if constexpr (std::is_same_v<Value, std::string>) {
    fits = found->is_string();
  } else if constexpr (std::is_floating_point_v<Value>) {
    fits = found->is_number();
  } else if constexpr (std::is_unsigned_v<Value>) {
    fits = found->is_number_unsigned();
  } else {
    fits = found->is_number_integer();
  }
  if (!fits) refuse(file, key, fmt::format("has the wrong type, {}", found->type_name()), "");
  return found->get<Value>();
}

template <class Value>
std::optional<Value> value_if_any(const Json& json, const char* key, const fs::path& file) {
  if (!json.contains(key) || json.at(key).is_null()) return std::nullopt;
  return value_of<Value>(json, key, file);
}

void read_into(Run& run, const fs::path& file) {
  constexpr std::uintmax_t most_bytes = 16U << 20U;  // much more than any run.json has
  const Json json = read_json_object<Json>(file, hint, most_bytes);
  run.name = value_of<std::string>(json, "name", file);
  run.project = value_of<std::string>(json, "project", file);
  const std::string state = value_of<std::string>(json, "state", file);
  const auto known =
      std::find_if(states.begin(), states.end(), [&](const auto& entry) { return entry.second == state; });
  if (known == states.end()) refuse(file, "state", fmt::format("\"{}\" is not a state of a run", state), "");
  run.state = known->first;
  run.dimension = value_of<int>(json, "dimension", file) == 2 ? 2 : 3;
  run.rocks = value_of<std::uint64_t>(json, "rocks", file);
  run.done = value_of<std::uint64_t>(json, "done", file);
  run.seconds = value_of<double>(json, "seconds", file);
  run.begun = value_of<std::string>(json, "begun", file);
  if (json.contains("problems") && json.at("problems").is_array()) run.problems = json.at("problems");
  if (json.contains("study")) {
    run.kind = RunKind::calibration;
    run.study = value_of<std::string>(json, "study", file);
    if (fs::path(run.study).filename() != run.study) refuse(file, "study", "is not a file name", "");
  }
  run.asked_rocks = value_if_any<std::int64_t>(json, "asked_rocks", file);
  run.asked_seed = value_if_any<std::uint64_t>(json, "asked_seed", file);
  const std::string project_file = value_of<std::string>(json, "file", file);
  if (fs::path(project_file).filename() != project_file) refuse(file, "file", "is not a file name", "");
  run.file = (fs::path(run.file) / project_file).generic_string();
}

/// Sets the progress of a killed run to its last checkpoint.
void read_checkpoint(Run& run) {
  run.done = 0;
  run.seconds = 0;
  const fs::path file = run.folder / run_state_name;
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return;
  const RunStateHeader header = read_run_state_header(file);
  run.done = header.rocks().count();
  run.seconds = header.seconds;
}

/// About a run that was in progress when its server ended without stopping it.
Json ended_with_its_server() {
  Problems problems;
  problems.add({.severity = Severity::warning,
                .what = "the server ended while this run was in progress",
                .why = "it was killed, or this run made it fail",
                .hint = "Resume the run. If the server ends again, please report it with the run's folder"});
  return as_json(problems)[0];
}

std::string iso(std::chrono::system_clock::time_point time) {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::chrono::system_clock::to_time_t(time)));
}

}  // namespace

std::string time_now() { return iso(std::chrono::system_clock::now()); }

bool has_results(const Run& run) {
  if (run.state == RunState::waiting || run.state == RunState::running || run.is_active) return false;
  if (run.was_killed) return false;  // its files may be incomplete
  // Regular files only: a link may lead out of the folder, and reading a pipe may never end.
  std::error_code ignored;
  return fs::symlink_status(run.folder / "summary.json", ignored).type() == fs::file_type::regular;
}

Json json_of(const Run& run, const fs::path& base) {
  const bool is_running = run.state == RunState::running;
  std::optional<double> rate = run.rate;
  if (!is_running && run.seconds > 0 && run.done > 0) rate = static_cast<double>(run.done) / run.seconds;
  Json json{{"id", run.id},
            {"name", run.name},
            {"kind", name(run.kind)},
            {"study", run.kind == RunKind::calibration ? Json(run.study) : Json()},
            {"file", run.file},
            {"project", run.project},
            {"state", name(run.state)},
            {"dimension", run.dimension},
            {"rocks", run.rocks},
            {"done", run.done},
            {"rate", rate ? Json(*rate) : Json()},
            {"seconds", run.seconds},
            {"seconds_left", nullptr},
            {"has_results", has_results(run)},
            {"begun", run.begun},
            {"problems", run.problems},
            {"folder", run.folder.lexically_relative(base).generic_string()}};
  if (is_running && rate.value_or(0) > 0) json["seconds_left"] = static_cast<double>(run.rocks - run.done) / *rate;
  return json;
}

void save(const Run& run) {
  Json json{{"name", run.name},           {"file", fs::path(run.file).filename().string()},
            {"project", run.project},     {"state", name(run.state)},
            {"dimension", run.dimension}, {"rocks", run.rocks},
            {"done", run.done},           {"seconds", run.seconds},
            {"begun", run.begun},         {"problems", run.problems}};
  if (run.kind == RunKind::calibration) json["study"] = run.study;
  if (run.asked_rocks) json["asked_rocks"] = *run.asked_rocks;
  if (run.asked_seed) json["asked_seed"] = *run.asked_seed;
  OutputFile file(run.folder / run_file_name);
  file.write(json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
  file.commit();
}

Run read_run(const fs::path& folder, const fs::path& base) {
  Run run;
  run.id = run.name = folder.filename().string();
  run.folder = folder;
  // The folder is DIR/runs/PROJECT/ID, the project DIR/FILE.
  run.file = folder.parent_path().parent_path().parent_path().lexically_relative(base).generic_string();
  if (run.file == ".") run.file.clear();
  run.project = folder.parent_path().filename().string();
  const fs::path file = folder / run_file_name;
  std::error_code ignored;
  const auto written = fs::last_write_time(file, ignored);
  if (!ignored)
    run.begun = iso(
        std::chrono::time_point_cast<std::chrono::system_clock::duration>(std::chrono::file_clock::to_sys(written)));
  try {
    read_into(run, file);
  } catch (const BadInput& bad) {
    run.state = RunState::failed;
    run.is_damaged = true;
    run.problems = as_json(bad.problems());
  }
  if (run.state != RunState::running && run.state != RunState::waiting) return run;
  run.is_elsewhere = !FolderLock::take(folder);
  if (run.is_elsewhere) return run;
  run.was_killed = true;
  if (run.state == RunState::running) run.problems.push_back(ended_with_its_server());
  run.state = RunState::interrupted;
  try {
    read_checkpoint(run);
  } catch (const BadInput& bad) {
    run.state = RunState::failed;
    run.problems = as_json(bad.problems());
  }
  return run;
}

}  // namespace talus::server
