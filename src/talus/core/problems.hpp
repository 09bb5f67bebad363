#pragma once
// Errors and warnings about input: collected, so that a user sees all of them at once.

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace talus {

enum class Severity { warning, error };

/// Problems that programs tell from others, beside those of the settings, which have a path.
enum class ProblemKind : std::uint8_t {
  other,
  mostly_on_ground,    // most of the way of a run's rocks was slid or rolled
  height_below_block,  // a fence of the height that the check asks for is lower than the largest block at its line
  kit_below_block,     // a kit is lower than that block
  beyond_ends,         // rocks pass beyond the ends of an asked line
  models_disagree,     // another rock model gives figures that differ by more than chance
};
/// For files and programs: the name above; empty for others.
[[nodiscard]] std::string_view word(ProblemKind kind);

/// One message. Printed as `file:line: where: problem (why). hint with option`, without the parts that are empty.
struct Problem {
  Severity severity = Severity::error;
  std::string file;    // as the user named it
  int line = 0;        // 1-based; 0: unknown
  std::string where;   // the key or object, for example `material "Type One"`
  std::string what;    // the problem
  std::string why;     // the reason, with what was expected
  std::string hint;    // what would fix it
  std::string path;    // of the setting in a project, for programs: `material.0.roughness_deg`; not part of the text
  std::string option;  // of the command line with which to follow the hint, for example `-o`
  ProblemKind kind = ProblemKind::other;  // for programs
  [[nodiscard]] std::string text() const;
};

/// A list of problems in the order in which they were found.
class Problems {
 public:
  void add(Problem problem) { list_.push_back(std::move(problem)); }
  void append(const Problems& others) { list_.insert(list_.end(), others.list_.begin(), others.list_.end()); }
  [[nodiscard]] const std::vector<Problem>& list() const { return list_; }
  [[nodiscard]] bool has_errors() const;
  [[nodiscard]] std::string text() const;  // one line each
  /// Those of this file first, by line, then the others in their order.
  [[nodiscard]] Problems in_order_of(const std::string& file) const;

 private:
  std::vector<Problem> list_;
};

/// Bad input that stops the work, with every problem found. The program ends with exit code 2.
class BadInput : public std::runtime_error {
 public:
  explicit BadInput(Problems problems) : std::runtime_error(problems.text()), problems_(std::move(problems)) {}
  explicit BadInput(Problem problem);
  [[nodiscard]] const Problems& problems() const { return problems_; }

 private:
  Problems problems_;
};

}  // namespace talus
