#pragma once
// Exit codes and messages of commands that fail.

#include <functional>

namespace talus::cli {

/// Returns the exit code of `work`. If it throws, prints the reason to standard error and returns the matching code.
int answer(const std::function<int()>& work);

/// Flushes standard output, so that a log can be followed. Failures are reported by finish_output().
void flush_output();

/// Flushes standard output and returns `code`. If the output could not be written completely (a full disk), prints the
/// reason to standard error and returns the code of bad input instead.
int finish_output(int code);

}  // namespace talus::cli
