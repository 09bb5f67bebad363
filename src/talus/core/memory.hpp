#pragma once
// How much memory there is to work with.

#include <cstdint>

namespace talus {

/// What this process may use at most: of the machine, of its container (control groups, versions 1 and 2), by its own
/// limits (ulimit -v) [bytes]. What others use of it is not counted.
[[nodiscard]] std::uint64_t usable_memory();

}  // namespace talus
