#pragma once
// The memory available to this process.

#include <cstdint>

namespace talus {

/// The maximum that this process may use [bytes]: the least of the machine's memory, the container's (control groups,
/// versions 1 and 2) and its own limits (ulimit -v). Memory in use by others is not subtracted.
[[nodiscard]] std::uint64_t usable_memory();

}  // namespace talus
