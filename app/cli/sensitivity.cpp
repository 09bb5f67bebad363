#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "answer.hpp"
#include "command_options.hpp"
#include "commands.hpp"
#include "exit_codes.hpp"
#include "load.hpp"
#include "progress.hpp"
#include "standard_streams.hpp"
#include "stop_signals.hpp"
#include "talus/campaign/thread_supply.hpp"
#include "talus/core/stop.hpp"
#include "talus/sensitivity/analysis.hpp"
#include "talus/sensitivity/output.hpp"

namespace talus::cli {

namespace {

struct SensitivityOptions {
  std::filesystem::path study;
  std::filesystem::path folder;  // empty: named after the study, next to its file
  int threads = 0;
  bool quiet = false;
};

void print_effects(const sensitivity::Study& study, const sensitivity::Analysis& analysis) {
  const bool is_morris = study.method == sensitivity::Method::morris;
  for (const sensitivity::ResultEffects& result : analysis.results) {
    const std::string unit = result.unit.empty() ? "" : fmt::format(" [{}]", result.unit);
    fmt::print("{}{}\n", result.title, unit);
    std::vector<std::size_t> order;
    for (std::size_t k = 0; k < result.of_inputs.size(); ++k) {
      if (result.of_inputs[k].size()) order.push_back(k);
    }
    std::ranges::stable_sort(order, std::ranges::greater(),
                             [&](std::size_t k) { return result.of_inputs[k].size()->value; });
    for (const std::size_t k : order) {
      const Estimate size = *result.of_inputs[k].size();
      fmt::print("  {:<44} {} {:.3g} ({:.3g} to {:.3g})", analysis.inputs[k].name, is_morris ? "effect" : "total",
                 size.value, size.low.value_or(size.value), size.high.value_or(size.value));
      if (!is_morris) fmt::print(", alone {:.3g}", result.of_inputs[k].index->first.value);
      fmt::print("\n");
    }
  }
}

int analyse(const SensitivityOptions& options) {
  take_threads(options.threads);
  catch_stop_signals();
  const StopScope scope(&stop_wanted());
  const auto [study, doubts] = sensitivity::read_study(options.study);
  Problems warnings = doubts;
  const sensitivity::PreparedStudy prepared(study, warnings);
  print_warnings(warnings);
  const std::filesystem::path folder = options.folder.empty() ? sensitivity::usual_folder(study) : options.folder;
  std::optional<Progress> progress;
  sensitivity::AnalysisOptions how{.threads = options.threads};
  const auto rocks = static_cast<std::uint64_t>(study.rocks);
  if (!options.quiet) {
    const std::size_t sites = study.sites.size();
    fmt::print("{}: {} runs of {} rocks{}\n", study.name, prepared.runs(), rocks,
               sites > 1 ? fmt::format(" at each of {} sites", sites) : "");
    flush_output();
    progress.emplace(prepared.runs() * sites * rocks);
    how.progress = [&](std::uint64_t done) { (*progress)(done * rocks); };
  }
  const sensitivity::Analysis analysis = sensitivity::analyse_into(folder, study, prepared, how);
  progress.reset();
  print_warnings(analysis.warnings);
  if (!options.quiet) {
    print_effects(study, analysis);
    fmt::print("Results are in {}; open report.html to view them\n", folder.string());
  }
  return done;
}

int sensitivity(const SensitivityOptions& options) {
  try {
    return analyse(options);
  } catch (const Stopped&) {
    to_stderr("stopped; finished runs are kept, and the same command continues from there\n");
    return stopped;
  }
}

}  // namespace

Command add_sensitivity(CLI::App& app) {
  const auto options = std::make_shared<SensitivityOptions>();
  CLI::App* command = app.add_subcommand("sensitivity", "Find which inputs of a project its results depend on");
  add_study(*command, options->study);
  add_output_folder(*command, options->folder,
                    "Folder for the results (default: named after the study, next to its file)");
  add_threads(*command, options->threads);
  add_quiet(*command, options->quiet);
  return {command, [options] { return sensitivity(*options); }};
}

}  // namespace talus::cli
