// `talus validate`: field experiments, each half predicted from the other.

#include <fmt/format.h>

#include <memory>
#include <optional>

#include "answer.hpp"
#include "command_options.hpp"
#include "commands.hpp"
#include "exit_codes.hpp"
#include "load.hpp"
#include "progress.hpp"
#include "standard_streams.hpp"
#include "stop_signals.hpp"
#include "talus/calibration/experiments.hpp"
#include "talus/calibration/validation_results.hpp"
#include "talus/campaign/thread_supply.hpp"
#include "talus/core/stop.hpp"
#include "talus/files/output_file.hpp"

namespace talus::cli {

namespace {

struct ValidateOptions {
  std::vector<std::string> experiments;  // names or folders; empty: all that are built in
  std::filesystem::path folder;          // empty: out/validation
  int threads = 0;
  bool quiet = false;
  std::optional<std::int64_t> rocks, draws;  // instead of the studies' own
};

using validation::Experiment;
using validation::ModelResult;
using validation::SitePrediction;

void print_results(const std::vector<ModelResult>& models) {
  fmt::print("{:<16} {:<12} {:>15} {:>15} {:>17} {:>9}  {:>22}  {:>15}\n", "model", "predicted", "observed, m",
             "predicted, m", "90 % of its mean", "in 90 %", "score: post, prior, c", "error, constant");
  for (const ModelResult& model : models) {
    for (const SitePrediction& site : model.sites) {
      fmt::print("{:<16} {:<12} {:>15} {:>15} {:>17} {:>9}  {:>22}  {:>15}\n", model.model, site.site,
                 fmt::format("{:.1f} +- {:.1f}", site.observed.mean, site.observed.std_dev),
                 fmt::format("{:.1f} +- {:.1f}", site.predicted.mean, site.predicted.std_dev),
                 fmt::format("{:.1f} to {:.1f}", site.mean_90.low, site.mean_90.high),
                 fmt::format("{} of {}", site.in_90.count, site.runs.size()),
                 fmt::format("{:.1f}, {:.1f}, {:.1f}", site.posterior.runout, site.prior.runout, site.constant.runout),
                 fmt::format("{:.1f}, {:.1f}", site.rmse, site.rmse_constant));
    }
  }
  fmt::print(
      "Runouts on plan. score: mean CRPS of the runout [m] of posterior, prior and constant, the runouts of the "
      "other runs; error: root mean square of single runs [m]\n");
}

void validate_one(Experiment experiment, const std::filesystem::path& folder, const ValidateOptions& options) {
  make_output_folder(folder);
  if (!options.quiet) {
    fmt::print("{}\n", experiment.title);
    for (const std::string& limit : experiment.limits) fmt::print("{}\n", limit);
    flush_output();
  }
  std::vector<ModelResult> models;
  for (std::size_t k = 0; k < experiment.models.size(); ++k) {
    calibration::Study& study = experiment.studies[k];
    study.rocks = options.rocks.value_or(study.rocks);
    study.draws = options.draws.value_or(study.draws);
    std::optional<Progress> progress;
    if (!options.quiet) progress.emplace(static_cast<std::uint64_t>(study.draws) * study.sites.size(), "sets");
    validation::PredictionOptions how{.threads = options.threads};
    if (progress) how.progress = [&](std::size_t done, std::size_t) { (*progress)(done); };
    models.push_back({experiment.models[k].name, predict_sites(study, how)});
    progress.reset();
    for (const SitePrediction& site : models.back().sites) print_warnings(site.warnings);
  }
  write_results(folder, experiment, models);
  if (options.quiet) return;
  print_results(models);
  fmt::print("Results are in {}; open report.html to view them\n", folder.string());
  flush_output();
}

int validate(const ValidateOptions& options) {
  take_threads(options.threads);
  const std::filesystem::path results =
      options.folder.empty() ? std::filesystem::path("out") / "validation" : options.folder;
  std::vector<std::string> words;
  std::vector<std::filesystem::path> folders;
  for (const std::string& each : options.experiments) {
    std::error_code none;
    if (std::filesystem::is_directory(each, none)) {
      folders.emplace_back(each);
    } else {
      words.push_back(each);
    }
  }
  std::vector<std::string> built_in;
  if (!words.empty() || folders.empty()) built_in = validation::chosen_experiments(words);
  for (const std::string& name : built_in) {
    // Its files come with their licence, and can be changed and validated again as a folder.
    folders.push_back(results / name / "experiment");
    validation::unpack(name, folders.back());
  }
  Problems warnings;
  std::vector<Experiment> experiments;
  for (const std::filesystem::path& folder : folders) {
    experiments.push_back(validation::read_experiment(folder, warnings));
  }
  print_warnings(warnings);
  catch_stop_signals();
  const StopScope scope(&stop_wanted());
  try {
    for (std::size_t k = 0; k < experiments.size(); ++k) {
      const std::size_t own = folders.size() - built_in.size();
      const std::string name = k < own ? experiments[k].name : built_in[k - own];
      validate_one(experiments[k], results / name, options);
    }
    return done;
  } catch (const Stopped&) {
    to_stderr("stopped; experiments that were not finished have no results\n");
    return stopped;
  }
}

}  // namespace

Command add_validate(CLI::App& app) {
  const auto options = std::make_shared<ValidateOptions>();
  CLI::App* command = app.add_subcommand(
      "validate", "Predict each half of a field experiment from the other half, and compare with what was observed");
  command
      ->add_option("experiments", options->experiments,
                   "Names of built-in experiments, or folders with an experiment.toml (default: all built-in ones)")
      ->type_name("EXPERIMENT");
  add_output_folder(*command, options->folder,
                    "Folder for the results, one folder in it for each experiment (default: out/validation)");
  command->add_option("--rocks", options->rocks, "Rocks of each set of parameters, instead of the studies'")
      ->transform(number_of_rocks())
      ->type_name("N");
  command->add_option("--draws", options->draws, "Sets of parameters, instead of the studies'")
      ->check(CLI::Range(50, 1000000))
      ->type_name("N");
  add_threads(*command, options->threads);
  add_quiet(*command, options->quiet);
  return {command, [options] { return validate(*options); }};
}

}  // namespace talus::cli
