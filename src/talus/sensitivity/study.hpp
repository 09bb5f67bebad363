#pragma once
// A sensitivity study as given in its file, STUDY.toml: the project, which of its numbers vary, which results are
// looked at. The keys are declared in study_settings.cpp.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/project/settings.hpp"
#include "talus/results/run_figures.hpp"
#include "talus/sampling/distribution.hpp"

namespace talus::sensitivity {

enum class Method { morris, sobol };
[[nodiscard]] std::string_view name(Method method);

/// [[parameter]]
struct StudyInput {
  std::string path;                   // in the project, as in `--set`
  std::vector<double> range;          // two numbers; or
  std::optional<Distribution> prior;  // in the form of a project's distributions
  int line = 0;
};

/// [[result]]
struct StudyResult {
  std::string name;                // default: made from the others
  std::string quantity;            // one of figure_quantities
  double percentile = 95;          // [%]
  std::string at;                  // a collector or barrier, for quantities at a line
  FigureOf of = FigureOf::runout;  // the quantity
  int line = 0;
};

struct Study {
  std::filesystem::path file;     // as the user named it
  std::string name;               // default: the file's stem
  std::filesystem::path project;  // as written in the file; relative to the study file
  std::vector<std::string> set;   // `table.key=value`, as `--set`
  std::string method_word = "morris";
  Method method = Method::morris;
  std::uint64_t seed = 1;
  std::int64_t rocks = 200;        // of each run
  std::int64_t trajectories = 20;  // of a screening
  std::int64_t rows = 256;         // of Sobol indices
  double confidence = 0.95;
  std::vector<StudyInput> inputs;
  std::vector<StudyResult> results;

  /// Runs of the whole study: each has one set of values of all inputs.
  [[nodiscard]] std::uint64_t runs() const;
};

/// The tables of a study file, in the order of the reference.
[[nodiscard]] const std::vector<project::Table>& study_tables();

/// Throws BadInput with every problem of the study file, in its order. The project is not read.
[[nodiscard]] Study read_study(const std::filesystem::path& file);
/// Overload for the text of a file of this name.
[[nodiscard]] Study read_study_text(std::string_view text, const std::filesystem::path& file);

}  // namespace talus::sensitivity
