#pragma once
// What the server says: answers, and refusals with their reasons.

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
  // Named with its charset, the library does not compress it, which costs more here than it saves.
  std::string type = "application/json; charset=utf-8";
  std::string body;
  std::vector<std::pair<std::string, std::string>> headers{};
};

[[nodiscard]] Answer json_answer(const Json& json, int status = 200);

/// Each problem with its parts, and the whole in one line.
[[nodiscard]] Json as_json(const Problems& problems);

/// A request that is not done, with its HTTP status. BadInput, which the engine throws, is one with 422.
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
