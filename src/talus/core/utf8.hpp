#pragma once
// File names are bytes, but JSON text is UTF-8; text files are UTF-8 or Latin-1, and do not say which.

#include <cstddef>
#include <string>
#include <string_view>

namespace talus {

/// The text with every byte that is not part of valid UTF-8 replaced by U+FFFD (Unicode 15, table 3-7).
[[nodiscard]] std::string as_utf8(std::string_view text);

/// The text as it is if it is UTF-8; otherwise read as Latin-1 (ISO 8859-1), in which every byte is a character.
[[nodiscard]] std::string from_utf8_or_latin1(std::string_view text);

/// A text of a file as a message quotes it: UTF-8 or Latin-1 as above, `?` for what does not print, and the first
/// `longest` characters with `...` for the others.
[[nodiscard]] std::string for_message(std::string_view text, std::size_t longest);

/// Letters of Latin-1 without umlauts and accents: `Höhe` is `Hoehe`. Other characters are kept.
[[nodiscard]] std::string in_ascii(std::string_view text);

}  // namespace talus
