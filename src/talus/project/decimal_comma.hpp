#pragma once
// Numbers with a decimal comma, which TOML does not accept.

#include <string>
#include <string_view>

namespace talus::project {

/// How to write a number with one comma between digits, `-0,8` or `1,000`: "-0.8", or "1.000 or 1000" if the comma may
/// be a thousands separator. Empty for any other text.
[[nodiscard]] std::string with_decimal_point(std::string_view text);

/// The same for the first such number that is a value in a line, such as `roughness_deg = 0,8`.
[[nodiscard]] std::string first_with_decimal_point(std::string_view line);

}  // namespace talus::project
