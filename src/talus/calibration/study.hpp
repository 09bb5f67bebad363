#pragma once
// A calibration as given in its file, STUDY.toml: which projects, what was observed, which parameters are sought. The
// keys are declared in study_settings.cpp, with units, ranges and meanings.

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/project/settings.hpp"
#include "talus/study/study_file.hpp"

namespace talus::calibration {

/// [[observations]]: exactly one of stops, marks, values and zones.
struct StudyObservations {
  std::string name;                // default: the kind and the file's name
  std::string site;                // default: the only site
  std::filesystem::path stops;     // where rocks came to rest
  std::filesystem::path marks;     // where rocks struck the ground
  std::filesystem::path values;    // of rocks at a line
  std::filesystem::path zones;     // what came to rest in each of several areas
  std::string at;                  // a collector or barrier of the project, for values
  std::string layer;               // of a GIS file
  double accuracy_m = 0.5;         // standard deviation of observed coordinates and heights
  std::optional<double> released;  // all that was released, in the unit of the zones: m3 or rocks
  std::optional<double> blocks;    // rocks of which zones hold volumes or shares
  double relative_accuracy = 0.2;  // standard deviation of an observed volume or share over itself
  double weight = 1;
  int line = 0;

  [[nodiscard]] const std::filesystem::path& file() const {
    return !stops.empty() ? stops : !marks.empty() ? marks : !values.empty() ? values : zones;
  }
  /// By which the file is named.
  [[nodiscard]] const char* key() const {
    return !stops.empty() ? "stops" : !marks.empty() ? "marks" : !values.empty() ? "values" : "zones";
  }
};

/// [[model]]
struct StudyModel {
  std::string name;
  std::vector<std::string> set;  // `table.key=value`, for all sites
  int line = 0;
};

struct Study : study::StudyFile {
  std::int64_t draws = 1200;  // sets of parameters in all
  std::int64_t rounds = 3;
  std::optional<std::int64_t>
      most_draws;  // in further rounds, where the posterior stands on too few; three times draws
  std::int64_t folds = 0;
  bool hold_out_sites = false;
  std::vector<StudyObservations> observations;
  std::vector<StudyModel> models;  // empty: the projects as they are

  /// `most_draws`, or its default.
  [[nodiscard]] std::size_t most_sets() const {
    return static_cast<std::size_t>(std::max(draws, most_draws.value_or(3 * draws)));
  }
};

/// The tables of a study file, in the order of the reference.
[[nodiscard]] const std::vector<project::Table>& study_tables();

struct StudyReading {
  Study study;
  Problems warnings;
};

/// Throws BadInput with every problem of the study file, in its order. The files that it names are not read.
[[nodiscard]] StudyReading read_study(const std::filesystem::path& file);
/// Overload for the text of a file of this name.
[[nodiscard]] StudyReading read_study_text(std::string_view text, const std::filesystem::path& file);

}  // namespace talus::calibration
