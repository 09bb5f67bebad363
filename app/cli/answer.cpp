#include "answer.hpp"

#include <fmt/format.h>

#include <cstdio>

#include "commands.hpp"
#include "talus/core/problems.hpp"

namespace talus::cli {

int answer(const std::function<int()>& work) {
  try {
    return work();
  } catch (const BadInput& bad) {
    fmt::print(stderr, "{}\n", bad.problems().text());
    return bad_input;
  } catch (const std::exception& error) {
    fmt::print(stderr, "talus: internal error: {}\n", error.what());
    return internal_error;
  }
}

}  // namespace talus::cli
