#include "http/answer.hpp"

#include <string_view>

namespace talus::server {

Answer json_answer(const Json& json, int status) {
  // Names of files may be no UTF-8; they are shown with a mark instead of failing.
  return {.status = status, .body = json.dump(-1, ' ', false, Json::error_handler_t::replace)};
}

namespace {

/// Hints for a command line name its option for the folder, which a page does not have.
Problem for_the_page(Problem problem) {
  constexpr std::string_view option = " with -o", of_results = "output ";
  if (!problem.hint.ends_with(option)) return problem;
  problem.hint.resize(problem.hint.size() - option.size());
  if (const auto at = problem.hint.find(of_results); at != std::string::npos) problem.hint.erase(at, of_results.size());
  return problem;
}

}  // namespace

Json as_json(const Problems& problems) {
  Json list = Json::array();
  for (const Problem& told : problems.list()) {
    const Problem problem = for_the_page(told);
    list.push_back({{"severity", problem.severity == Severity::error ? "error" : "warning"},
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
    : Refusal(status, Problem{.where = std::move(where),
                              .what = std::move(what),
                              .why = std::move(why),
                              .hint = std::move(hint)}) {}

}  // namespace talus::server
