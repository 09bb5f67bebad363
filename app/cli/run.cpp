#include "talus/run/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "answer.hpp"
#include "command_options.hpp"
#include "commands.hpp"
#include "exit_codes.hpp"
#include "load.hpp"
#include "outcome.hpp"
#include "progress.hpp"
#include "standard_streams.hpp"
#include "stop_signals.hpp"
#include "talus/campaign/campaign.hpp"
#include "talus/campaign/ranks.hpp"
#include "talus/campaign/thread_supply.hpp"
#include "talus/core/stop.hpp"
#include "talus/run/run_on_ranks.hpp"

namespace talus::cli {

namespace {

struct RunOptions {
  ProjectOptions project;
  std::filesystem::path folder;  // empty: named after the project, next to its file
  int threads = 0;
  bool quiet = false;
  std::string shard;  // "2/7"; empty: the whole campaign
  bool resume = false;
  double checkpoint_every = 20;   // [s]; 0: never
  bool alone = false;             // even if a launcher started several processes
  std::uint64_t maps_memory = 0;  // [bytes]; 0: half of the available memory
};

std::string shard_name(const RunOptions& options, const project::RunResult& result) {
  const RockRange& range = result.range;
  if (options.shard.empty()) return "";
  if (range.count() == 0) return fmt::format(", shard {} (no rocks)", options.shard);
  return fmt::format(", shard {} (rocks {} to {})", options.shard, range.first, range.last - 1);
}

void print_outcome(const Loaded& loaded, const RunOptions& options, const project::RunResult& result,
                   const std::filesystem::path& folder) {
  const Summary& summary = result.summary;
  const CampaignOutcome& outcome = result.outcome;
  const std::uint64_t now = summary.done - result.done_before;
  fmt::print(
      "{}{}: {} rocks in {:.2f} s ({:.0f} rocks/s on {} {}{})\n", loaded.project.name, shard_name(options, result), now,
      outcome.seconds, static_cast<double>(now) / std::max(outcome.seconds, 1e-9), outcome.threads,
      outcome.threads == 1 ? "thread" : "threads", outcome.ranks > 1 ? fmt::format(" of {} ranks", outcome.ranks) : "");
  if (result.done_before > 0) fmt::print("  {} rocks including the earlier ones\n", summary.done);
  std::vector<std::string> barriers;
  for (const Barrier& barrier : loaded.model.barriers) barriers.push_back(barrier.name);
  print_summary(summary, barriers);
  print_stored(result.trajectories);
  if (!options.shard.empty()) {
    fmt::print("The shard is in {}; combine all shards with `talus merge`\n", folder.string());
  } else {
    fmt::print("Results are in {}{}\n", folder.string(),
               loaded.project.output.report ? "; open report.html to view them" : "");
  }
}

std::optional<Shard> shard_of(const RunOptions& options) {
  if (options.shard.empty()) return std::nullopt;
  if (const auto shard = shard_from(options.shard)) return shard;
  throw BadInput(Problem{.where = "--shard",
                         .what = fmt::format("\"{}\" is not a shard", options.shard),
                         .why = "expected i/n with i from 1 to n",
                         .hint = "For example --shard 2/7"});
}

void check_time_between_checkpoints(const RunOptions& options) {
  if (!std::isnan(options.checkpoint_every)) return;
  throw BadInput(
      Problem{.where = "--checkpoint-every", .what = "nan is not a time", .why = "expected seconds, 0 or more"});
}

/// Next to the project file, named after the project and the shard.
std::filesystem::path default_folder(const Loaded& loaded, const std::optional<Shard>& shard) {
  const std::filesystem::path folder = loaded.project.file.parent_path() / loaded.project.name;
  if (!shard) return folder;
  return folder.string() + fmt::format("-shard-{}-of-{}", shard->number, shard->of);
}

project::RunOptions run_options(const RunOptions& options, const std::optional<Shard>& shard) {
  return {.campaign = {options.threads, &stop_wanted(), {}},
          .shard = shard,
          .resume = options.resume,
          .checkpoint_every = options.checkpoint_every,
          .maps_memory = options.maps_memory};
}

/// Runs in this process alone, or as rank 0 of several.
int run_here(const RunOptions& options, Ranks* ranks) {
  const std::optional<Shard> shard = shard_of(options);
  check_time_between_checkpoints(options);
  if (ranks == nullptr) take_threads(options.threads);
  const Loaded loaded = load(options.project);
  print_warnings(loaded.warnings);
  const std::filesystem::path folder = options.folder.empty() ? default_folder(loaded, shard) : options.folder;

  catch_stop_signals();
  project::RunOptions how = run_options(options, shard);
  how.ranks = ranks;
  std::optional<Progress> progress;
  if (!options.quiet) {
    if (!loaded.model.terrain_report.empty()) fmt::print("{}\n", loaded.model.terrain_report);
    if (!loaded.model.seeder_report.empty()) fmt::print("{}\n", loaded.model.seeder_report);
    const std::uint64_t all = loaded.model.rocks();
    const RockRange rocks = shard ? rocks_of(*shard, all) : RockRange{0, all};
    const StopScope scope(&stop_wanted());
    print_if_large(loaded, rocks, threads_for(options.threads), &stop_wanted());
    progress.emplace(rocks.count());
    how.campaign.progress = [&](std::uint64_t done) { (*progress)(done); };
    how.say = [](const std::string& text) {
      fmt::print("{}\n", text);
      flush_output();
    };
  }
  const project::RunResult result = project::run_into(folder, loaded.project, loaded.model, loaded.warnings, how);
  progress.reset();
  if (result.was_complete) {
    if (!options.quiet) fmt::print("{} is already complete in {}\n", loaded.project.name, folder.string());
    return done;
  }
  print_warnings(result.warnings);
  if (!result.has_results) {
    to_stderr(
        "stopped after {} of {} rocks, before their results were written; the rocks are kept in {}, and --resume "
        "continues from there\n",
        result.summary.done, result.range.count(), folder.string());
    return stopped;
  }
  if (!options.quiet) print_outcome(loaded, options, result, folder);
  if (result.outcome.interrupted) {
    to_stderr("stopped after {} of {} rocks; the results so far are in {}{}\n", result.summary.done,
              result.range.count(), folder.string(),
              options.checkpoint_every > 0 || shard ? ", and --resume continues from there" : "");
    return stopped;
  }
  return done;
}

int run_or_stop(const RunOptions& options, Ranks* ranks) {
  try {
    return run_here(options, ranks);
  } catch (const Stopped&) {
    to_stderr("stopped before the first rock was finished\n");
    return stopped;
  }
}

/// Runs as a rank other than 0. Only rank 0 prints.
int help_rank_0(const RunOptions& options, Ranks& ranks) {
  try {
    const project::RunOptions how = run_options(options, shard_of(options));
    const Loaded loaded = load(options.project);
    catch_stop_signals();
    return project::help_run(ranks, loaded.project, loaded.model, loaded.warnings, how);
  } catch (const BadInput& bad) {
    return project::cannot_help(ranks, bad.problems().text(), bad_input);
  } catch (const std::exception& error) {
    return project::cannot_help(ranks, error.what(), internal_error);
  }
}

int run(const RunOptions& options) {
  std::unique_ptr<Ranks> ranks;
  try {
    if (!options.alone) ranks = join_ranks();
  } catch (const BadInput&) {
    // All processes get this error; only the first one reports it.
    if (find_launch()->rank > 0) return done;
    throw;
  }
  if (!ranks) return run_or_stop(options, nullptr);
  if (ranks->rank() > 0) return help_rank_0(options, *ranks);
  const int code = answer([&] { return run_or_stop(options, ranks.get()); });
  std::fflush(nullptr);  // once another rank ends, the launcher may end this one
  project::dismiss_ranks(*ranks, code);
  return code;
}

}  // namespace

Command add_run(CLI::App& app) {
  const auto options = std::make_shared<RunOptions>();
  CLI::App* command = app.add_subcommand("run", "Run a project, and write tables and a report");
  add_project(*command, options->project);
  add_output_folder(*command, options->folder,
                    "Folder for the results (default: named after the project, next to its file)");
  add_threads(*command, options->threads,
              "Number of threads per process (default: all cores, shared among the processes)");
  add_quiet(*command, options->quiet);
  command
      ->add_option("--shard", options->shard,
                   "Run only part i of n of the campaign (i from 1 to n); `talus merge` combines the parts")
      ->check(not_empty("\"\" is not a shard; expected i/n with i from 1 to n, for example 2/7"))
      ->type_name("i/n");
  command->add_flag("--resume", options->resume, "Continue from the last checkpoint in the folder");
  command
      ->add_option("--checkpoint-every", options->checkpoint_every,
                   "Time between checkpoints, from which --resume continues; 0: no checkpoints")
      ->check(CLI::Range(0.0, 1e9))
      ->capture_default_str()
      ->type_name("SECONDS");
  add_maps_memory(*command, options->maps_memory);
  command->add_flag("--alone", options->alone, "Run all rocks in this process, even if mpirun or srun started several");
  return {command, [options] { return run(*options); }};
}

}  // namespace talus::cli
