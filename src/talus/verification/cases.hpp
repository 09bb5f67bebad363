#pragma once
// The case folders embedded when the program was built (cmake/embed_cases.cmake), so that `talus verify` needs no
// files, or those of a folder.

#include <filesystem>

#include "talus/verification/case.hpp"

namespace talus::verification {

[[nodiscard]] Files embedded_cases();

/// All .toml and .csv files of the folders in `folder`. Throws BadInput if there is no case.
[[nodiscard]] Files cases_in(const std::filesystem::path& folder);

/// The names of all cases, in order.
[[nodiscard]] std::vector<std::string> case_names(const Files& files);

/// The cases whose names begin with one of the words; all without words. Throws BadInput, with the nearest name, if a
/// word matches none.
[[nodiscard]] std::vector<std::string> chosen_cases(const Files& files, const std::vector<std::string>& words);

}  // namespace talus::verification
