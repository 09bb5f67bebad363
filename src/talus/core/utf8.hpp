#pragma once
// Names of files are bytes; what is written in JSON is UTF-8.

#include <string>
#include <string_view>

namespace talus {

/// The text with U+FFFD in the place of every byte that is not part of UTF-8 (Unicode 15, table 3-7).
[[nodiscard]] std::string as_utf8(std::string_view text);

}  // namespace talus
