#pragma once
// The project that `talus new` writes: the slope of RocFall2's first tutorial, with comments, ready to run.

#include <string>

namespace talus::project {

[[nodiscard]] std::string starter();

}  // namespace talus::project
