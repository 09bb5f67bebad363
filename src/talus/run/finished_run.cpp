#include "talus/run/finished_run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <system_error>
#include <utility>
#include <vector>

#include "talus/archive/run_summary.hpp"
#include "talus/core/problems.hpp"
#include "talus/project/echo.hpp"
#include "talus/run/result_files.hpp"

namespace talus::project {

namespace {

using Json = nlohmann::ordered_json;

std::string shortened(const Json& value) {
  constexpr std::size_t most = 40;
  std::string text = value.dump();
  if (text.size() > most) text = value.is_structured() ? "another" : text.substr(0, most - 3) + "...";
  return text;
}

/// The first three settings that differ, in words.
std::vector<std::string> changed_settings(const Json& then, const Json& now) {
  constexpr std::size_t most = 3;
  std::vector<std::string> changes;
  for (const Json& step : Json::diff(then, now)) {
    if (changes.size() == most) {
      changes.emplace_back("and more");
      break;
    }
    const std::string pointer = step.at("path");
    const Json::json_pointer place(pointer);
    std::string key = pointer.substr(1);
    std::ranges::replace(key, '/', '.');
    const auto at = [&](const Json& json) { return json.contains(place) ? shortened(json.at(place)) : "not set"; };
    changes.push_back(fmt::format("{} was {} and is {}", key, at(then), at(now)));
  }
  return changes;
}

/// nullopt if there is no summary, or it cannot be read.
std::optional<RunIdentity> run_in(const std::filesystem::path& folder) {
  try {
    return read_run_identity(folder / "summary.json");
  } catch (const BadInput&) {
    return std::nullopt;
  }
}

RunInputs inputs_of(const RunIdentity& run) {
  return {*run.project, run.fingerprint, run.talus.paths_revision.value_or(0)};
}

/// The rocks of a run, in words.
std::string rocks_of(const RunIdentity& run) {
  if (!run.shard) return name_of({0, run.rocks.planned}, std::nullopt);
  const std::uint64_t first = run.shard->first_rock;
  return name_of({first, first + run.shard->rocks}, Shard{run.shard->number, run.shard->of});
}

}  // namespace

void remove_finished_summary(const std::filesystem::path& folder) {
  const auto run = run_in(folder);
  if (run && run->interrupted) return;
  std::error_code ignored;
  std::filesystem::remove(folder / "summary.json", ignored);
}

std::string name_of(const RockRange& range, const std::optional<Shard>& shard) {
  if (range.count() == 0) return "no rocks";
  const std::string rocks = fmt::format("rocks {} to {}", range.first, range.last - 1);
  return shard ? fmt::format("shard {}/{} with {}", shard->number, shard->of, rocks) : rocks;
}

void refuse_to_resume(const std::filesystem::path& file, std::string what, std::string why) {
  throw BadInput(Problem{.file = file.string(),
                         .what = std::move(what),
                         .why = std::move(why),
                         .hint = "Undo the change to resume, or run without --resume to start over"});
}

void refuse_other_program(const std::filesystem::path& file, std::string why) {
  throw BadInput(Problem{.file = file.string(),
                         .what = "this run was begun by another talus",
                         .why = std::move(why),
                         .hint = "Use that program to resume, or run without --resume to start over"});
}

RunInputs inputs_of(const RunDescription& description) {
  return {description.project, description.fingerprint, description.paths_revision};
}

std::optional<std::string> difference_of_inputs(const RunInputs& then, const RunInputs& now) {
  const std::vector<std::string> settings =
      changed_settings(without_presentation(then.project), without_presentation(now.project));
  if (!settings.empty()) return fmt::format("{}", fmt::join(settings, "; "));
  if (then.fingerprint == now.fingerprint) return std::nullopt;
  if (then.paths_revision != now.paths_revision) {
    return fmt::format("rocks may take other paths: the revision of its laws was {} and is {}",
                       then.paths_revision == 0 ? "not stated" : std::to_string(then.paths_revision),
                       now.paths_revision);
  }
  return "all settings are the same, but the contents of their files (terrain, ground or releases) are not";
}

std::optional<std::string> replaced_results(const std::filesystem::path& folder, const RunDescription& now) {
  const auto run = run_in(folder);
  if (!run) return std::nullopt;
  const auto difference = difference_of_inputs(inputs_of(*run), inputs_of(now));
  return fmt::format("{}{}", rocks_of(*run), difference ? fmt::format(" ({})", *difference) : "");
}

FinishedRun find_finished_run(const std::filesystem::path& folder, const RunDescription& description,
                              const RockRange& range, const std::optional<Shard>& shard) {
  const auto run = run_in(folder);
  if (!run) return {};
  const std::filesystem::path file = folder / "summary.json";
  if (run->talus.version != TALUS_VERSION) {
    refuse_to_resume(file, "these are the results of another version of talus",
                     fmt::format("it was {} and is {}", run->talus.version, TALUS_VERSION));
  }
  if (run->fingerprint != description.fingerprint) {
    const RunInputs then = inputs_of(*run), now = inputs_of(description);
    std::string why = difference_of_inputs(then, now).value_or("");
    if (then.project == now.project && then.paths_revision != now.paths_revision)
      refuse_other_program(file, std::move(why));
    refuse_to_resume(file, "these are the results of another project", std::move(why));
  }
  if (const std::string theirs = rocks_of(*run), ours = name_of(range, shard); theirs != ours)
    refuse_to_resume(file, fmt::format("these are the results of {}", theirs), fmt::format("expected {}", ours));
  if (run->interrupted) return {};
  const auto lacks = lacking_file(folder, description, shard);
  return {!lacks, lacks.value_or("")};
}

}  // namespace talus::project
