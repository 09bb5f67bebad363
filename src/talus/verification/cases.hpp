#pragma once
// The case folders as they were when the program was built (cmake/embed_cases.cmake), so that `talus verify` needs no
// files; or as they are in a folder.

#include <filesystem>

#include "talus/verification/case.hpp"

namespace talus::verification {

[[nodiscard]] Files embedded_cases();

/// All .toml and .csv files of the folders in `folder`. Throws BadInput where there is no case.
[[nodiscard]] Files cases_in(const std::filesystem::path& folder);

/// The names of all cases, in their order.
[[nodiscard]] std::vector<std::string> case_names(const Files& files);

/// The cases that the words mean: a name, or the beginning of one or several. Without words, all. Throws BadInput that
/// names the nearest where a word means none.
[[nodiscard]] std::vector<std::string> chosen_cases(const Files& files, const std::vector<std::string>& words);

}  // namespace talus::verification
