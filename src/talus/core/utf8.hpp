#pragma once
// File names are bytes, but JSON text is UTF-8.

#include <string>
#include <string_view>

namespace talus {

/// The text with every byte that is not part of valid UTF-8 replaced by U+FFFD (Unicode 15, table 3-7).
[[nodiscard]] std::string as_utf8(std::string_view text);

}  // namespace talus
