#pragma once
// Signals that end long work, whose results so far are kept.

#include <atomic>

namespace talus::cli {

/// Set by the first signal after catch_stop_signals().
[[nodiscard]] const std::atomic<bool>& stop_wanted();

/// The first of SIGINT, SIGTERM, SIGUSR1 and the hangup of the terminal sets stop_wanted(); another one at least two
/// seconds later ends the program. mpirun forwards SIGUSR1 to the program, whereas it kills the program on the others.
/// Batch systems can send SIGUSR1 before the time limit.
void catch_stop_signals();

}  // namespace talus::cli
