#include "talus/core/problems.hpp"

#include <algorithm>

namespace talus {

std::string_view word(ProblemKind kind) {
  switch (kind) {
    case ProblemKind::mostly_on_ground:
      return "mostly_on_ground";
    case ProblemKind::height_below_block:
      return "height_below_block";
    case ProblemKind::kit_below_block:
      return "kit_below_block";
    case ProblemKind::beyond_ends:
      return "beyond_ends";
    case ProblemKind::models_disagree:
      return "models_disagree";
    case ProblemKind::other:
      break;
  }
  return "";
}

std::string Problem::text() const {
  std::string out;
  if (!file.empty()) {
    out += file;
    if (line > 0) out += ':' + std::to_string(line);
    out += ": ";
  }
  if (severity == Severity::warning) out += "warning: ";
  if (!where.empty()) out += where + ": ";
  out += what;
  if (!why.empty()) out += " (" + why + ")";
  if (!hint.empty()) out += ". " + hint;
  if (!option.empty()) out += " with " + option;
  return out;
}

bool Problems::has_errors() const {
  return std::any_of(list_.begin(), list_.end(), [](const Problem& p) { return p.severity == Severity::error; });
}

std::string Problems::text() const {
  std::string out;
  for (const Problem& problem : list_) {
    if (!out.empty()) out += '\n';
    out += problem.text();
  }
  return out;
}

Problems Problems::in_order_of(const std::string& file) const {
  Problems sorted = *this;
  std::ranges::stable_sort(sorted.list_, [&](const Problem& a, const Problem& b) {
    const bool a_elsewhere = a.file != file, b_elsewhere = b.file != file;
    return a_elsewhere != b_elsewhere ? b_elsewhere : !a_elsewhere && a.line < b.line;
  });
  return sorted;
}

static Problems only(Problem problem) {
  Problems problems;
  problems.add(std::move(problem));
  return problems;
}

BadInput::BadInput(Problem problem) : BadInput(only(std::move(problem))) {}

}  // namespace talus
