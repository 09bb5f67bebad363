#pragma once
// The exit codes of the program and their meanings.

#include <array>

namespace talus::cli {

enum ExitCode { done = 0, check_failed = 1, bad_input = 2, stopped = 3, internal_error = 4 };

struct ExitMeaning {
  ExitCode code;
  const char* meaning;
};
inline constexpr std::array exit_meanings{
    ExitMeaning{done, "done"}, ExitMeaning{check_failed, "a check failed"}, ExitMeaning{bad_input, "bad input"},
    ExitMeaning{stopped, "stopped by a signal (results so far kept)"}, ExitMeaning{internal_error, "internal error"}};

}  // namespace talus::cli
