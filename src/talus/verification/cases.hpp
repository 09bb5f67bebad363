#pragma once
// The case folders as they were when the program was built (cmake/embed_cases.cmake), so that `talus verify` needs no
// files; or as they are in a folder.

#include <filesystem>

#include "talus/verification/case.hpp"

namespace talus::verification {

[[nodiscard]] Files embedded_cases();

/// All .toml and .csv files of the folders in `folder`. Throws BadInput where there is no case.
[[nodiscard]] Files cases_in(const std::filesystem::path& folder);

}  // namespace talus::verification
