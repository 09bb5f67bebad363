#pragma once
// Runs a case and compares the results of Talus with the published ones.

#include <optional>
#include <string>
#include <vector>

#include "talus/verification/case.hpp"

namespace talus::verification {

enum class Verdict {
  agrees,
  differs,
  left_out,  // with a reason in the case
  shown      // not tested: nothing is published, or the statistic follows from others
};
[[nodiscard]] const char* name(Verdict verdict);

/// One number next to the published one.
struct Line {
  std::string row, quantity;
  std::string published;  // as printed; empty if nothing is published
  std::optional<double> ours;
  std::optional<double> difference;  // ours minus the published one
  std::string allowed;               // the allowed difference, or the interval for the published number
  Verdict verdict = Verdict::shown;
  std::string why;  // why it is left out or has its own tolerance
};

/// The comparison of one table with one run.
struct TableResult {
  std::string title, source, run, why;
  std::vector<Line> lines;
  [[nodiscard]] std::size_t count(Verdict verdict) const;
};

struct CaseResult {
  std::string name, title;
  std::vector<TableResult> tables;
  double seconds = 0;
  [[nodiscard]] std::size_t count(Verdict verdict) const;
  [[nodiscard]] bool passes() const { return count(Verdict::differs) == 0; }
};

/// Throws BadInput if a project of the case cannot be run.
[[nodiscard]] CaseResult verify(const Case& published, const Files& files);

}  // namespace talus::verification
