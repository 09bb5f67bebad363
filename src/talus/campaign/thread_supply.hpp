#pragma once
// How many threads the system lets this program have: a limit of processes or of memory may leave it one.

#include <system_error>

namespace talus {

struct ThreadSupply {
  int threads = 1;      // that there can be at a time, this one included; at most as many as were wanted
  std::error_code why;  // there are no more
};

/// By trying. 0: as many as there are cores for this process.
[[nodiscard]] ThreadSupply try_threads(int wanted);

/// Whatever is computed from now on, to the end of the program, is computed by at most so many. With one, none is asked
/// of the system.
void limit_threads(int most);

/// Limits them to those wanted; throws BadInput that names the option where they cannot be had.
void take_threads(int wanted);

/// Makes do with what there is, up to a thread a core.
void take_available_threads();

}  // namespace talus
