// `talus calibrate`: the parameters that agree with observed rocks.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "answer.hpp"
#include "command_options.hpp"
#include "commands.hpp"
#include "exit_codes.hpp"
#include "load.hpp"
#include "progress.hpp"
#include "standard_streams.hpp"
#include "stop_signals.hpp"
#include "talus/calibration/best_set.hpp"
#include "talus/calibration/calibrate_models.hpp"
#include "talus/calibration/result_files.hpp"
#include "talus/calibration/study.hpp"
#include "talus/campaign/thread_supply.hpp"
#include "talus/core/stop.hpp"
#include "talus/project/values.hpp"

namespace talus::cli {

namespace {

struct CalibrateOptions {
  std::filesystem::path study;
  std::filesystem::path folder;  // empty: named after the study, next to its file
  int threads = 0;
  bool quiet = false;
};

using calibration::CalibrationResult;
using calibration::PreparedStudy;
using calibration::SetResult;
using calibration::Study;
using calibration::StudyModel;

void print_posterior(const PreparedStudy& study, const CalibrationResult& result) {
  std::vector<double> weights;
  for (const SetResult& set : result.sets) weights.push_back(set.weight);
  std::size_t longest = 0;
  for (const study::Parameter& parameter : study.parameters()) longest = std::max(longest, parameter.name.size());
  fmt::print("{:{}}  {:>10} {:>10} {:>10}   {:>10}\n", "", longest, "5 %", "median", "95 %", "best set");
  for (std::size_t k = 0; k < study.parameters().size(); ++k) {
    std::vector<double> values;
    for (const SetResult& set : result.sets) values.push_back(set.values[k]);
    const auto q = [&](double share) { return calibration::weighted_quantile(values, weights, share); };
    fmt::print("{:{}}  {:>10.4g} {:>10.4g} {:>10.4g}   {:>10.4g}\n", study.parameters()[k].name, longest, q(0.05),
               q(0.5), q(0.95), result.sets[result.best].values[k]);
  }
  if (const std::string why = calibration::why_best_is_outside(study, result); !why.empty()) fmt::print("{}\n", why);
  fmt::print("The posterior is as accurate as {}\n",
             project::counted(static_cast<std::size_t>(std::lround(result.effective_sets)), "independent set",
                              "independent sets"));
  if (const auto score = calibration::held_out_score(result)) {
    fmt::print("Held-out score {:.3f}; with the prior {:.3f}\n", score->posterior, score->prior);
  }
}

CalibrationResult run_one(const Study& study, const StudyModel* model, const std::filesystem::path& folder,
                          const CalibrateOptions& options) {
  const StopScope scope(&stop_wanted());
  Problems warnings;
  const PreparedStudy prepared(study, model, warnings);
  print_warnings(warnings);
  std::optional<Progress> progress;
  if (!options.quiet) progress.emplace(static_cast<std::uint64_t>(study.draws), "sets");
  calibration::FolderOptions how{.threads = options.threads};
  if (progress) {
    how.progress = [&](std::size_t done, std::size_t all) {
      progress->set_total(all);
      (*progress)(done);
    };
    how.phase = [&](const std::string& what) { progress->say(what); };
  }
  CalibrationResult result = calibration::calibrate_into(folder, prepared, how);
  progress.reset();
  print_warnings(result.warnings);
  if (!options.quiet) {
    if (model != nullptr) fmt::print("Model {}\n", model->name);
    print_posterior(prepared, result);
    fmt::print("Results are in {}; open report.html to view them\n", folder.string());
    flush_output();
  }
  return result;
}

int calibrate(const CalibrateOptions& options) {
  take_threads(options.threads);
  const calibration::StudyReading reading = calibration::read_study(options.study);
  print_warnings(reading.warnings);
  const Study& study = reading.study;
  const std::filesystem::path folder = options.folder.empty() ? calibration::usual_folder(study) : options.folder;
  catch_stop_signals();
  try {
    if (study.models.empty()) {
      static_cast<void>(run_one(study, nullptr, folder, options));
      return done;
    }
    const std::string table = calibration::calibrate_models_into(
        folder, study, [&](const StudyModel& model, const std::filesystem::path& own) {
          return run_one(study, &model, own, options);
        });
    if (!options.quiet) fmt::print("\n{}", table);
    return done;
  } catch (const Stopped&) {
    to_stderr("stopped; finished sets are kept in {}, and the same command continues from there\n", folder.string());
    return stopped;
  }
}

}  // namespace

Command add_calibrate(CLI::App& app) {
  const auto options = std::make_shared<CalibrateOptions>();
  CLI::App* command = app.add_subcommand(
      "calibrate", "Find the parameters that agree with observed rocks, and how well they are known");
  add_study(*command, options->study);
  add_output_folder(
      *command, options->folder,
      "Folder for the results (default: named after the study, next to its file). Sets of parameters that "
      "are finished there are not run again");
  add_threads(*command, options->threads);
  add_quiet(*command, options->quiet);
  return {command, [options] { return calibrate(*options); }};
}

}  // namespace talus::cli
