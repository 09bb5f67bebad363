#pragma once
// The number of threads that the system grants this program: limits on processes or memory may leave it only one.

#include <system_error>

namespace talus {

struct ThreadSupply {
  int threads = 1;      // available at a time, this one included; at most the number requested
  std::error_code why;  // why there are no more
};

/// Finds out by starting threads. 0: as many as there are cores for this process.
[[nodiscard]] ThreadSupply try_threads(int requested);

/// Limits all later work of the program to this many threads. With one, no thread is requested from the system.
void limit_threads(int most);

/// Limits threads to the number requested. Throws BadInput, naming the option, if they are not available.
void take_threads(int requested);

/// Limits threads to those available, up to one per core.
void take_available_threads();

}  // namespace talus
