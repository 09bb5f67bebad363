#pragma once
// A sensitivity study as given in its file, STUDY.toml: which projects, which of their numbers vary, which results are
// looked at. The keys are declared in study_settings.cpp.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/project/settings.hpp"
#include "talus/results/run_figures.hpp"
#include "talus/study/study_file.hpp"

namespace talus::sensitivity {

enum class Method { morris, sobol };
[[nodiscard]] std::string_view name(Method method);

/// [[result]]
struct StudyResult {
  std::string name;                // default: made from the others
  std::string quantity;            // one of figure_quantities
  double percentile = 95;          // [%]
  std::string at;                  // a collector or barrier, for quantities at a line
  FigureOf of = FigureOf::runout;  // the quantity
  std::vector<std::string> sites;  // empty: all
  int line = 0;
};

struct Study : study::StudyFile {
  std::string method_word = "morris";
  Method method = Method::morris;
  std::int64_t trajectories = 20;  // of a screening
  std::int64_t rows = 256;         // of Sobol indices
  double confidence = 0.95;
  std::vector<StudyResult> results;
};

/// The tables of a study file, in the order of the reference.
[[nodiscard]] const std::vector<project::Table>& study_tables();

struct StudyReading {
  Study study;
  Problems warnings;
};

/// Throws BadInput with every problem of the study file, in its order. The projects are not read.
[[nodiscard]] StudyReading read_study(const std::filesystem::path& file);
/// Overload for the text of a file of this name.
[[nodiscard]] StudyReading read_study_text(std::string_view text, const std::filesystem::path& file);

}  // namespace talus::sensitivity
