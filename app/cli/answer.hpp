#pragma once
// What becomes of a command that fails.

#include <functional>

namespace talus::cli {

/// The exit code that the work gives; or, where it throws, says why on standard error and gives the code for that.
int answer(const std::function<int()>& work);

/// Sends on what was printed so far, for a log that is read meanwhile; output_taken() says what failed.
void show_now();

/// Sends on what is still to be printed: the exit code of the work, or, where a full disk did not take all of what was
/// printed, that of bad input, and standard error says why.
int output_taken(int code);

}  // namespace talus::cli
