#include "http/answer.hpp"

namespace talus::server {

Answer json_answer(const Json& json, int status) {
  // File names may not be UTF-8: invalid bytes are replaced instead of failing.
  return {.status = status, .body = json.dump(-1, ' ', false, Json::error_handler_t::replace)};
}

Json as_json(const Problems& problems) {
  Json list = Json::array();
  for (Problem problem : problems.list()) {
    problem.option.clear();  // a page has no command line
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
    : Refusal(
          status,
          Problem{.where = std::move(where), .what = std::move(what), .why = std::move(why), .hint = std::move(hint)}) {
}

}  // namespace talus::server
