#include "talus/run/checkpoint.hpp"

#include <fmt/format.h>

#include <system_error>
#include <utility>

#include "talus/run/finished_run.hpp"

namespace talus::project {

namespace {

constexpr int least_time_between = 20;  // in multiples of the time that writing took

bool is_present(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::exists(file, ignored);
}

/// Of runs with the same inputs.
std::optional<std::string> difference_of_programs(const RunDescription& then, const RunDescription& now) {
  if (then.sample != now.sample) {
    return "the same rocks take other paths: another build of talus, another processor or other libraries";
  }
  if (then.maps.has_value() != now.maps.has_value()) return "one was made by a talus without GDAL, without maps";
  return std::nullopt;
}

}  // namespace

Checkpoints::Checkpoints(const std::filesystem::path& folder, RunStateHeader begun, const RunDescription& description,
                         RunSums& sums, TableFiles& tables, double every)
    : file_(folder / run_state_name),
      header_(std::move(begun)),
      description_(saved(description)),
      seconds_before_(header_.seconds),
      sums_(sums),
      tables_(tables),
      every_(every) {}

double Checkpoints::seconds() const {
  return seconds_before_ + std::chrono::duration<double>(Clock::now() - begin_).count();
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
  header_.done = next;
  header_.seconds = seconds();
  header_.tables = tables_.sync();
  const auto observers = sums_.observers();
  write_run_state(file_, header_, description_, observers);
  last_ = header_.rocks();
  tables_.keep_parts();
  written_ = Clock::now();
  cost_ = written_ - begin;
}

std::optional<std::string> difference(const RunDescription& then, const RunDescription& now) {
  if (auto changed = difference_of_inputs(inputs_of(then), inputs_of(now))) return changed;
  return difference_of_programs(then, now);
}

Found find_checkpoint(const std::filesystem::path& folder, const RunDescription& description, const RockRange& range,
                      const std::optional<Shard>& shard) {
  const std::filesystem::path file = folder / run_state_name;
  if (!is_present(file)) {
    const FinishedRun finished = find_finished_run(folder, description, range, shard);
    return {std::nullopt, !shard && finished.is_whole, finished.lacks};
  }
  Found found{read_run_state_header(file), false, ""};
  const RunStateHeader& state = *found.state;
  const RunDescription& begun = state.description;
  if (auto changed = difference_of_inputs(inputs_of(begun), inputs_of(description))) {
    if (begun.project == description.project && begun.paths_revision != description.paths_revision)
      refuse_other_program(file, std::move(*changed));
    refuse_to_resume(file, "the project is not the one that this run began with", std::move(*changed));
  }
  if (auto changed = difference_of_programs(begun, description)) refuse_other_program(file, std::move(*changed));
  if (state.range != range || state.shard != shard) {
    refuse_to_resume(file, fmt::format("this is the state of {}", name_of(state.range, state.shard)),
                     fmt::format("expected {}", name_of(range, shard)));
  }
  found.is_complete = shard && state.is_complete() && find_finished_run(folder, description, range, shard).is_whole;
  return found;
}

}  // namespace talus::project
