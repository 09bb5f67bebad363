#include "http/answer.hpp"

#include <fmt/format.h>

namespace talus::server {

Answer json_answer(const Json& json, int status) {
  // File names may not be UTF-8: invalid bytes are replaced instead of failing.
  return {.status = status, .body = json.dump(-1, ' ', false, Json::error_handler_t::replace)};
}

namespace {

/// No page shows more; each takes kilobytes.
constexpr std::size_t max_problems = 1000;

/// All problems, or the first ones, errors before warnings, and how many more there are.
Problems first_of(const Problems& problems) {
  if (problems.list().size() <= max_problems) return problems;
  Problems first;
  std::size_t count = 0;
  for (const Severity severity : {Severity::error, Severity::warning}) {
    for (const Problem& problem : problems.list()) {
      if (problem.severity == severity && count++ < max_problems) first.add(problem);
    }
  }
  first.add({.severity = problems.has_errors() ? Severity::error : Severity::warning,
             .what = fmt::format("there are {} more problems", problems.list().size() - max_problems),
             .why = fmt::format("only {} are listed", max_problems)});
  return first;
}

}  // namespace

Json as_json(const Problems& all) {
  Json list = Json::array();
  const Problems problems = first_of(all);
  for (Problem problem : problems.list()) {
    problem.option.clear();  // a page has no command line
    list.push_back({{"severity", problem.severity == Severity::error ? "error" : "warning"},
                    {"kind", word(problem.kind)},
                    {"file", problem.file},
                    {"line", problem.line},
                    {"path", problem.path},
                    {"where", problem.where},
                    {"what", problem.what},
                    {"why", problem.why},
                    {"hint", problem.hint},
                    {"text", problem.text()}});
  }
  return list;
}

Refusal::Refusal(int status, Problem problem)
    : std::runtime_error(problem.text()), status_(status), problem_(std::move(problem)) {}

Refusal::Refusal(int status, std::string where, std::string what, std::string why, std::string hint)
    : Refusal(
          status,
          Problem{.where = std::move(where), .what = std::move(what), .why = std::move(why), .hint = std::move(hint)}) {
}

}  // namespace talus::server
