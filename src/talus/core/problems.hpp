#pragma once
// What is wrong with something that came from outside: collected, so that a user sees all of it at once.

#include <stdexcept>
#include <string>
#include <vector>

namespace talus {

enum class Severity { warning, error };

/// One message. Printed as `file:line: where: problem (why). hint with option`, each part only where there is one.
struct Problem {
  Severity severity = Severity::error;
  std::string file;    // as the user named it
  int line = 0;        // 1-based; 0 where no line can be named
  std::string where;   // the key or the thing, for example `material "Type One"`
  std::string what;    // the problem
  std::string why;     // why it is one, with what was expected
  std::string hint;    // what would fix it
  std::string path;    // of the setting of a project, for programs: `material.0.roughness_deg`; no part of the text
  std::string option;  // of the command line by which the hint is followed, for example `-o`
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
  /// Those of this file first, by line, then the others as they came.
  [[nodiscard]] Problems in_order_of(const std::string& file) const;

 private:
  std::vector<Problem> list_;
};

/// Bad input that stops the work; carries every problem found. The program answers it with exit code 2.
class BadInput : public std::runtime_error {
 public:
  explicit BadInput(Problems problems) : std::runtime_error(problems.text()), problems_(std::move(problems)) {}
  explicit BadInput(Problem problem);
  [[nodiscard]] const Problems& problems() const { return problems_; }

 private:
  Problems problems_;
};

}  // namespace talus
