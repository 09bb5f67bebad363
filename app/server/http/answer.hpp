#pragma once
// Answers of the server, and refusals with their reasons.

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "talus/core/problems.hpp"

namespace talus::server {

using Json = nlohmann::ordered_json;

struct Answer {
  int status = 200;
  // The charset keeps the library from compressing the body, which costs more than it saves on one machine.
  std::string type = "application/json; charset=utf-8";
  std::string body;
  std::vector<std::pair<std::string, std::string>> headers{};
};

[[nodiscard]] Answer json_answer(const Json& json, int status = 200);

/// Each problem with its parts, and its text in one line. Of very many the first ones, and how many more there are.
[[nodiscard]] Json as_json(const Problems& problems);

/// A refused request with its HTTP status. BadInput, which the engine throws, is answered with 422.
class Refusal : public std::runtime_error {
 public:
  Refusal(int status, Problem problem);
  Refusal(int status, std::string where, std::string what, std::string why = {}, std::string hint = {});
  [[nodiscard]] int status() const { return status_; }
  [[nodiscard]] const Problem& problem() const { return problem_; }

 private:
  int status_;
  Problem problem_;
};

}  // namespace talus::server
