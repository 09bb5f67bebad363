#pragma once
// What becomes of a command that fails.

#include <functional>

namespace talus::cli {

/// The exit code that the work gives; or, where it throws, says why on standard error and gives the code for that.
int answer(const std::function<int()>& work);

}  // namespace talus::cli
