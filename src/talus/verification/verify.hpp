#pragma once
// Runs a case and lays what Talus gets beside what was published.

#include <optional>
#include <string>
#include <vector>

#include "talus/verification/case.hpp"

namespace talus::verification {

enum class Verdict {
  agrees,
  differs,
  left_out,  // the case says why
  shown      // not tested: nothing was published, or the statistic follows from others
};
[[nodiscard]] const char* name(Verdict verdict);

/// One number beside the published one.
struct Line {
  std::string row, quantity;
  std::string published;  // as printed; empty where nothing was
  std::optional<double> ours;
  std::optional<double> difference;  // ours less the published one
  std::string allowed;               // how far it may be away, or between what the published number must lie
  Verdict verdict = Verdict::shown;
  std::string why;  // it was left out or has a tolerance of its own
};

/// One table with one run.
struct TableResult {
  std::string title, manual, run, why;
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

/// Throws BadInput where a project of the case cannot be run.
[[nodiscard]] CaseResult verify(const Case& published, const Files& files);

}  // namespace talus::verification
