#pragma once
// Standard error, and what the program does about streams that are closed or full.

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace talus::cli {

/// To standard error, as far as it takes it: that nobody can be told is no reason for the work to end.
void to_stderr(std::string_view text);

template <class... Values>
void to_stderr(fmt::format_string<Values...> format, Values&&... values) {
  to_stderr(std::string_view(fmt::format(format, std::forward<Values>(values)...)));
}

/// To be called before any file is opened. A standard stream that was closed is one that takes everything and gives
/// nothing: a file would be given its number, and would get what is printed. Writing into a pipe that nobody reads, and
/// beyond the largest file that is allowed, fails instead of ending the program.
void make_streams_safe();

/// Ends the program as others end that print into a pipe which nobody reads.
[[noreturn]] void end_by_closed_pipe();

/// Has SIGHUP handled, but where the program was started with it ignored, as `nohup` does.
void catch_hangup(void (*handler)(int));

}  // namespace talus::cli
