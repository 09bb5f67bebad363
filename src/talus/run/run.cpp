#include "talus/run/run.hpp"

#include <fmt/format.h>

#include <new>
#include <system_error>
#include <utility>

#include "talus/archive/run_state.hpp"
#include "talus/archive/table_files.hpp"
#include "talus/core/memory_reserve.hpp"
#include "talus/core/stop.hpp"
#include "talus/files/output_file.hpp"
#include "talus/run/checkpoint.hpp"
#include "talus/run/finished_run.hpp"
#include "talus/run/other_model.hpp"
#include "talus/run/report_inputs.hpp"
#include "talus/run/result_files.hpp"
#include "talus/run/run_on_ranks.hpp"

namespace talus::project {

namespace {

/// Rethrows `bad`, to be called where it was caught; if there is a checkpoint on the disk, with a hint to resume.
[[noreturn]] void throw_with_way_on(const BadInput& bad, const Checkpoints& checkpoints) {
  std::error_code ignored;
  const auto& last = checkpoints.last();
  if (!last || !std::filesystem::exists(checkpoints.file(), ignored)) throw;
  Problems problems;
  for (Problem problem : bad.problems().list()) {
    if (problem.severity == Severity::error) {
      const std::string hint = std::move(problem.hint);
      problem.hint = fmt::format("The first {} of {} rocks are kept: with --resume the run continues from there{}{}",
                                 last->count(), checkpoints.range().count(), hint.empty() ? "" : ". ", hint);
    }
    problems.add(std::move(problem));
  }
  throw BadInput(std::move(problems));
}

/// Called between blocks, when sums and tables are consistent: writes a checkpoint before memory is exhausted.
void stop_if_memory_is_short(std::uint64_t done, const RunOptions& options, const RunSums& sums,
                             Checkpoints& checkpoints) {
  if (!memory_is_short() && !sums.lacking_memory()) return;
  if (options.checkpoint_every > 0 || options.shard) checkpoints.write(done);
  throw std::bad_alloc();
}

/// Throws OutOfMemory, with a hint to resume if there is a checkpoint.
[[noreturn]] void throw_out_of_memory(const RunSums& sums, const Checkpoints& checkpoints) {
  std::error_code ignored;
  const auto& last = checkpoints.last();
  const auto of_maps = sums.lacking_memory();
  std::string text = of_maps.value_or("not enough memory for this run");
  if (!last || !std::filesystem::exists(checkpoints.file(), ignored)) {
    text += "; none of its rocks are kept";
  } else {
    text += fmt::format("; the first {} of {} rocks are kept: with --resume it continues from there", last->count(),
                        checkpoints.range().count());
    if (of_maps) text += ", if given more";
  }
  if (of_maps) {
    text +=
        ". Maps take less with larger cells (output.raster_cell_m), fewer quantities (output.maps, output.bands) or no "
        "percentiles (output.percentiles = [])";
  }
  throw OutOfMemory(text);
}

/// Removes the state, and one that was being written when its run was killed.
void remove_state(const std::filesystem::path& file) {
  std::error_code ignored;
  std::filesystem::remove(file, ignored);
  std::filesystem::remove(OutputFile::part_of(file), ignored);
}

/// Where a run begins: at its first rock, or after those of the run that it resumes.
struct Start {
  RunStateHeader state;
  bool resumes = false;      // from the state on the disk
  bool is_complete = false;  // all rocks are done
};

Start find_start(const std::filesystem::path& folder, const RunDescription& description, const RunOptions& options) {
  Start start;
  start.state.shard = options.shard;
  start.state.range = options.shard ? rocks_of(*options.shard, description.rocks) : RockRange{0, description.rocks};
  start.state.done = start.state.range.first;
  if (!options.resume) return start;
  const Found found = find_checkpoint(folder, description, start.state.range, options.shard);
  start.is_complete = found.is_complete;
  start.resumes = found.state.has_value();
  if (found.state) start.state = *found.state;
  start.state.description = {};  // it is the same
  if (start.is_complete || !options.say) return start;
  if (start.resumes) {
    options.say(fmt::format("resuming after {} of {} rocks", start.state.rocks().count(), start.state.range.count()));
  } else {
    const std::string lacks = found.lacks.empty() ? "there is no checkpoint in " : found.lacks + " is incomplete in ";
    options.say(fmt::format("{}{}: the run starts over", lacks, folder.string()));
  }
  return start;
}

/// Simulates the remaining rocks in this process.
CampaignOutcome simulate_rocks(const Model& model, const RunOptions& options, const RockRange& all, std::uint64_t next,
                               RunSums& sums, TableFiles& tables, Checkpoints& checkpoints) {
  std::vector<Observer*> observers = tables.observers();
  for (SummingObserver* observer : sums.observers()) observers.push_back(observer);
  if (options.watch != nullptr) observers.push_back(options.watch);
  CampaignOptions campaign = options.campaign;
  campaign.rocks = RockRange{next, options.only_results ? next : all.last};
  campaign.progress = [&](std::uint64_t done) {
    if (options.campaign.progress) options.campaign.progress(done - all.first);
    if (options.so_far) options.so_far(sums.summary());
    if (done == all.last) return;
    stop_if_memory_is_short(done, options, sums, checkpoints);
    checkpoints.after(done);
  };
  CampaignOutcome outcome = run_campaign(model, observers, campaign);
  outcome.interrupted = outcome.done < all.last;
  return outcome;
}

}  // namespace

RunResult run_into(const std::filesystem::path& folder, const Project& project, const Model& model,
                   const Problems& warnings, const RunOptions& options) {
  check_that_inputs_are_kept(folder, project);
  make_output_folder(folder);
  std::optional<FolderLock> lock;
  if (options.lock == nullptr) lock.emplace(lock_output_folder(folder));
  std::optional<StopScope> beginning(std::in_place, options.campaign.stop);
  RunDescription description = describe_run(project, model, warnings, options.shard);
  const Start start = find_start(folder, description, options);
  const RunStateHeader& begun = start.state;
  if (start.is_complete) return {.summary = Summary(0, 0), .range = begun.range, .was_complete = true};
  if (!start.resumes && options.say) {
    if (const auto earlier = replaced_results(folder, description)) {
      options.say(fmt::format("replacing the results in {}: {}", folder.string(), *earlier));
    }
  }
  Problems doubts;
  if (const auto found = compare_models(project, model, options.campaign.threads)) warn_of_other_model(*found, doubts);
  for (const Problem& doubt : doubts.list()) description.warnings.add(doubt, doubt.text());
  // Before anything of an earlier run is changed.
  check_that_results_have_room(folder, description, options.shard);
  description.inputs = report_inputs(project);
  const std::vector<int> threads =
      options.ranks != nullptr ? meet_ranks(*options.ranks, description, options.campaign.threads) : std::vector<int>();

  const std::filesystem::path state_file = folder / run_state_name;
  RunSums sums(description, project, model);
  sums.limit_maps_memory(options.maps_memory);
  TableFiles tables(folder, TableContext::of(model), table_rocks(project, model.rocks()));
  Checkpoints checkpoints(folder, begun, description, sums, tables, options.checkpoint_every);
  if (start.resumes) {
    const auto observers = sums.observers();
    merge_run_state(state_file, observers);
    tables.resume(begun.tables);
    checkpoints.begin_with(begun);
  } else {
    remove_state(state_file);
    tables.begin();
  }
  try {
    beginning.reset();  // from here on the campaign handles a stop
    RunCourse course{begun.range, begun.shard};
    if (options.campaign.progress) options.campaign.progress(begun.done - begun.range.first);
    if (begun.done < begun.range.last && sums.lacking_memory()) throw std::bad_alloc();
    const CampaignOutcome outcome =
        options.ranks != nullptr
            ? simulate_on_ranks(*options.ranks, threads, project, model, options, begun, sums, tables, checkpoints)
            : simulate_rocks(model, options, begun.range, begun.done, sums, tables, checkpoints);
    // Keep the state on the disk where it may be needed: of a shard for merging, of a run that was stopped or has taken
    // long for resuming.
    const bool may_be_resumed =
        options.checkpoint_every > 0 && (outcome.interrupted || checkpoints.last() || memory_is_short());
    if (options.shard || may_be_resumed) checkpoints.write(outcome.done);
    course.interrupted = outcome.interrupted;
    course.seconds = begun.seconds + outcome.seconds;
    course.threads = outcome.threads;
    remove_finished_summary(folder);
    tables.finish();
    RunResult result{
        .outcome = outcome, .summary = sums.summary(), .range = begun.range, .done_before = begun.rocks().count()};
    const bool was_asked = is_requested(options.campaign.stop);
    const TimeLimit limit{std::chrono::duration<double>(options.closing_seconds)};
    try {
      const StopScope closing(was_asked ? nullptr : options.campaign.stop, was_asked ? &limit : nullptr);
      auto [found, trajectories] = write_results(folder, description, sums, course);
      result.warnings = doubts;
      result.warnings.append(found);
      result.trajectories = trajectories;
    } catch (const std::bad_alloc&) {
      if (options.checkpoint_every > 0 || options.shard) checkpoints.write(outcome.done);
      throw;
    } catch (const Stopped&) {
      checkpoints.write(outcome.done);
      std::error_code ignored;
      std::filesystem::remove(folder / "summary.json", ignored);  // of an earlier part of the run
      result.has_results = false;
      return result;
    }
    if (!outcome.interrupted && !options.shard) remove_state(state_file);
    return result;
  } catch (const BadInput& bad) {
    throw_with_way_on(bad, checkpoints);
  } catch (const std::bad_alloc&) {
    throw_out_of_memory(sums, checkpoints);
  }
}

}  // namespace talus::project
