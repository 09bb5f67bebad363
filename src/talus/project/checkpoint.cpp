#include "talus/project/checkpoint.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <system_error>
#include <utility>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/io/output_file.hpp"

namespace talus::project {

namespace {

using Json = nlohmann::ordered_json;

constexpr int least_time_between = 20;  // times what writing took

std::string shortened(const Json& value) {
  constexpr std::size_t most = 40;
  std::string text = value.dump();
  if (text.size() > most) text = value.is_structured() ? "another" : text.substr(0, most - 3) + "...";
  return text;
}

/// The settings that differ, up to three of them.
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

[[noreturn]] void refuse(const std::filesystem::path& file, std::string what, std::string why) {
  throw BadInput(Problem{.file = file.string(),
                         .what = std::move(what),
                         .why = std::move(why),
                         .hint = "Undo the change to go on, or run without --resume to begin anew"});
}

std::string name_of(const RockRange& range, const std::optional<Shard>& shard) {
  if (range.count() == 0) return "no rocks";
  const std::string rocks = fmt::format("rocks {} to {}", range.first, range.last - 1);
  return shard ? fmt::format("shard {}/{} with {}", shard->number, shard->of, rocks) : rocks;
}

bool is_there(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::exists(file, ignored);
}

/// Whether the folder holds the whole results of just this run: no table is in the making, and the summary, which is
/// written after them, is its own.
bool has_results(const std::filesystem::path& folder, const io::RunDescription& description,
                 const std::optional<Shard>& shard) {
  for (const char* table : {"endpoints.csv", "barriers.csv", "paths.csv"}) {
    if (!is_there(folder / table) || is_there(OutputFile::part_of(folder / table))) return false;
  }
  std::ifstream file(folder / "summary.json");
  const Json summary = Json::parse(file, nullptr, false);
  if (!summary.is_object()) return false;
  const Json other_shard = summary.contains("shard") ? summary.at("shard") : Json();
  const bool is_same_shard = shard ? other_shard.is_object() && other_shard.value("number", Json()) == shard->number &&
                                         other_shard.value("of", Json()) == shard->of
                                   : other_shard.is_null();
  const Json::json_pointer version("/talus/version");
  return is_same_shard && summary.value("fingerprint", Json()) == description.fingerprint &&
         summary.contains(version) && summary.at(version) == TALUS_VERSION &&
         summary.value("interrupted", Json()) == false;
}

}  // namespace

Checkpoints::Checkpoints(const std::filesystem::path& folder, io::RunStateHeader begun, RunSums& sums,
                         io::TableFiles& tables, double every)
    : file_(folder / io::run_state_name), begun_(std::move(begun)), sums_(sums), tables_(tables), every_(every) {}

double Checkpoints::seconds() const {
  return begun_.seconds + std::chrono::duration<double>(Clock::now() - begin_).count();
}

bool Checkpoints::is_due() const {
  if (every_ <= 0) return false;
  const auto since = Clock::now() - written_;
  return std::chrono::duration<double>(since).count() >= every_ && since >= least_time_between * cost_;
}

void Checkpoints::after(std::uint64_t next) {
  if (is_due()) write(next);
}

void Checkpoints::write(std::uint64_t next, Clock::time_point begin) {
  io::RunStateHeader header = begun_;
  header.done = next;
  header.seconds = seconds();
  header.tables = tables_.sync();
  const auto observers = sums_.observers();
  io::write_run_state(file_, header, observers);
  last_ = std::move(header);
  tables_.keep_parts();
  written_ = Clock::now();
  cost_ = written_ - begin;
}

std::optional<std::string> difference(const io::RunDescription& then, const io::RunDescription& now) {
  const std::vector<std::string> settings = changed_settings(then.project, now.project);
  if (!settings.empty()) return fmt::format("{}", fmt::join(settings, "; "));
  if (then.fingerprint != now.fingerprint) {
    return "all settings are the same, but not what the files hold that they name, of terrain, ground or releases";
  }
  if (then.sample != now.sample) {
    return "the same rocks take other paths: another build of talus, another processor or other libraries";
  }
  if (then.maps.has_value() != now.maps.has_value()) return "one was made by a talus without GDAL, without maps";
  return std::nullopt;
}

Found find_checkpoint(const std::filesystem::path& folder, const io::RunDescription& description,
                      const RockRange& range, const std::optional<Shard>& shard) {
  const std::filesystem::path file = folder / io::run_state_name;
  if (!is_there(file)) return {std::nullopt, !shard && has_results(folder, description, shard)};
  Found found{io::read_run_state_header(file), false};
  const io::RunStateHeader& state = *found.state;
  if (const auto changed = difference(state.description, description)) {
    refuse(file, "the project is not the one that this run began with", *changed);
  }
  if (state.range != range || state.shard != shard) {
    refuse(file, fmt::format("this is the state of {}", name_of(state.range, state.shard)),
           fmt::format("expected {}", name_of(range, shard)));
  }
  found.is_complete = shard && state.is_complete() && has_results(folder, description, shard);
  return found;
}

}  // namespace talus::project
