#pragma once
// A calibration as given in its file, STUDY.toml: which projects, what was observed, which parameters are sought. The
// keys are declared in study_settings.cpp, with units, ranges and meanings.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/project/project.hpp"
#include "talus/project/settings.hpp"
#include "talus/sampling/distribution.hpp"

namespace talus::calibration {

/// [[site]]
struct StudySite {
  std::string name;               // default: "site N"
  std::filesystem::path project;  // as written in the file; relative to the study file
  std::vector<std::string> set;   // `table.key=value`, as `--set` of the command line
  int line = 0;
};

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
};

/// [[parameter]]
struct StudyParameter {
  std::string path;
  std::vector<double> range;          // two numbers; or
  std::optional<Distribution> prior;  // in the form of a project's distributions
  std::vector<std::string> sites;     // empty: all, which share one value
  bool each_site = false;             // every site has its own value
  int line = 0;
};

/// [[model]]
struct StudyModel {
  std::string name;
  std::vector<std::string> set;  // `table.key=value`, for all sites
  int line = 0;
};

struct Study {
  std::filesystem::path file;  // as the user named it
  std::string name;            // default: the file's stem
  std::uint64_t seed = 1;
  std::int64_t rocks = 200;   // of each set, at each site
  std::int64_t draws = 1200;  // sets of parameters in all
  std::int64_t rounds = 3;
  std::int64_t folds = 0;
  bool hold_out_sites = false;
  std::vector<StudySite> sites;
  std::vector<StudyObservations> observations;
  std::vector<StudyParameter> parameters;
  std::vector<StudyModel> models;  // empty: the projects as they are
  std::vector<project::NamedFile> named_files;
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
