#include "talus/project/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <ctime>

#include "commands.hpp"
#include "load.hpp"
#include "progress.hpp"

namespace talus::cli {

namespace {

std::atomic<bool> stop_wanted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may only touch lock-free atomics");

// The first signal asks the campaign to stop and keep what it has. One that comes two seconds later or more ends the
// program; until then it is taken for the same wish, since some callers signal a program and its group.
volatile std::sig_atomic_t stop_asked_at = 0;
extern "C" void ask_to_stop(int signal) {
  const auto now = static_cast<std::sig_atomic_t>(std::time(nullptr));
  if (stop_wanted.exchange(true) && now - stop_asked_at >= 2) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  } else if (stop_asked_at == 0) {
    stop_asked_at = now;
  }
}

void print_outcome(const Loaded& loaded, const project::RunResult& result, const std::filesystem::path& folder) {
  const Summary& summary = result.summary;
  const CampaignOutcome& outcome = result.outcome;
  fmt::print("{}: {} rocks in {:.2f} s ({:.0f} rocks/s on {} {})\n", loaded.project.name, summary.done, outcome.seconds,
             static_cast<double>(summary.done) / std::max(outcome.seconds, 1e-9), outcome.threads,
             outcome.threads == 1 ? "thread" : "threads");
  for (int k = 0; k < end_reason_count; ++k) {
    const auto count = summary.ends[static_cast<std::size_t>(k)];
    if (count > 0) fmt::print("  {:<22}{:>10}\n", name(static_cast<EndReason>(k)), count);
  }
  const Descriptive way = summary.runout_plan.describe();
  if (way.mean && way.maximum)
    fmt::print("  runout on plan: mean {:.2f} m, greatest {:.2f} m\n", *way.mean, *way.maximum);
  for (std::size_t b = 0; b < summary.barriers.size(); ++b) {
    const BarrierTally& tally = summary.barriers[b];
    const Descriptive energy = tally.total_energy.describe(), height = tally.height.describe();
    fmt::print("  {}: {} rocks hit it, {} passed above", loaded.model.barriers[b].name, tally.rocks_hit,
               tally.rocks_passed_above);
    if (energy.maximum) fmt::print("; at most {:.1f} kJ, {:.2f} m high", *energy.maximum / 1000, *height.maximum);
    fmt::print("\n");
  }
  fmt::print("Results are in {}{}\n", folder.string(), loaded.project.output.report ? ", to look at: report.html" : "");
}

}  // namespace

int run(const RunOptions& options) {
  const Loaded loaded = load(options.project);
  print_warnings(loaded.warnings);
  const std::filesystem::path folder =
      options.folder.empty() ? options.project.file.parent_path() / loaded.project.name : options.folder;

  std::signal(SIGINT, ask_to_stop);
  std::signal(SIGTERM, ask_to_stop);
  CampaignOptions campaign{options.threads, &stop_wanted, {}};
  std::optional<Progress> progress;
  if (!options.quiet) {
    if (!loaded.model.terrain_report.empty()) fmt::print("{}\n", loaded.model.terrain_report);
    progress.emplace(loaded.model.rocks());
    campaign.progress = [&](std::uint64_t done) { (*progress)(done); };
  }
  const project::RunResult result = project::run_into(folder, loaded.project, loaded.model, loaded.warnings, campaign);
  progress.reset();
  print_warnings(result.warnings);
  if (!options.quiet) print_outcome(loaded, result, folder);
  if (result.outcome.interrupted) {
    fmt::print(stderr, "stopped after {} of {} rocks; what is done is in {}\n", result.summary.done,
               loaded.model.rocks(), folder.string());
    return stopped;
  }
  return done;
}

}  // namespace talus::cli
