#pragma once
// Numbers with a comma where TOML has a point: half the world writes them so.

#include <string>
#include <string_view>

namespace talus::project {

/// How to write a number that has one comma and digits around it, `-0,8` or `1,000`: "0.8", or "1.000 or 1000" where
/// the comma may have been meant to part thousands. Empty for every other text.
[[nodiscard]] std::string with_point(std::string_view text);

/// The same for the first such number that is a value in a line, `roughness_deg = 0,8`.
[[nodiscard]] std::string first_with_point(std::string_view line);

}  // namespace talus::project
