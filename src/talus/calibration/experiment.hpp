#pragma once
// A field experiment, as declared in its folder under validation/: experiment.toml beside the studies that it names.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "talus/calibration/study.hpp"
#include "talus/core/problems.hpp"
#include "talus/project/settings.hpp"

namespace talus::validation {

/// [[model]]: a study whose sites are predicted from each other.
struct ExperimentModel {
  std::string name;
  std::filesystem::path study;  // in the experiment's folder
  int line = 0;
};

/// [[published]]: what another program reached on the same experiment.
struct PublishedResult {
  std::string name, source;
  double observed_mean_m = 0, predicted_mean_m = 0;  // runout
  std::optional<double> mean_abs_error_m;            // of the runout of single runs
  int line = 0;
};

struct Experiment {
  std::filesystem::path file;
  std::string name;  // of its folder
  std::string title, summary, licence, split;
  std::vector<std::string> citations, limits, sought, not_sought;
  std::vector<ExperimentModel> models;
  std::vector<PublishedResult> published;
  std::vector<calibration::Study> studies;  // of the models, in their order
};

/// The tables of an experiment file.
[[nodiscard]] const std::vector<project::Table>& experiment_tables();

inline constexpr const char* experiment_file = "experiment.toml";

/// Throws BadInput with every problem of experiment.toml and of the studies; doubts are added to `warnings`.
[[nodiscard]] Experiment read_experiment(const std::filesystem::path& folder, Problems& warnings);

}  // namespace talus::validation
