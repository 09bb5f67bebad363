#pragma once
// Standard error, and protection against standard streams that are closed or full.

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace talus::cli {

/// Prints to standard error. A closed or full standard error does not end the run.
void to_stderr(std::string_view text);

template <class... Values>
void to_stderr(fmt::format_string<Values...> format, Values&&... values) {
  to_stderr(std::string_view(fmt::format(format, std::forward<Values>(values)...)));
}

/// Call before opening any file. Connects closed standard streams to /dev/null: otherwise the next file opened would
/// get the stream's descriptor and receive the printed text. Ignores SIGPIPE and SIGXFSZ, so that writing to a closed
/// pipe or beyond the file size limit fails instead of ending the program.
void make_streams_safe();

/// Ends the program by SIGPIPE, as is usual for programs whose output pipe was closed.
[[noreturn]] void end_by_closed_pipe();

/// Handles SIGHUP, unless the program was started with SIGHUP ignored, as by `nohup`.
void catch_hangup(void (*handler)(int));

}  // namespace talus::cli
