#include "talus/core/utf8.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace talus {

namespace {

/// The number of bytes of the first character; 0 if the text does not begin with one.
std::size_t letter_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xC2 && first <= 0xDF   ? 2
                             : first >= 0xE0 && first <= 0xEF ? 3
                             : first >= 0xF0 && first <= 0xF4 ? 4
                                                              : 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return 0;
  }
  // Overlong, half of a surrogate pair, or beyond U+10FFFF.
  const bool is_bad = (first == 0xE0 && byte(1) < 0xA0) || (first == 0xED && byte(1) > 0x9F) ||
                      (first == 0xF0 && byte(1) < 0x90) || (first == 0xF4 && byte(1) > 0x8F);
  return is_bad ? 0 : length;
}

/// The code point of the letter with which the text begins.
std::uint32_t code_of_letter(std::string_view letter) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(letter[i]); };
  if (letter.size() == 1) return byte(0);
  std::uint32_t code = byte(0) & (0xFFU >> (letter.size() + 1));
  for (std::size_t i = 1; i < letter.size(); ++i) code = (code << 6U) | (byte(i) & 0x3FU);
  return code;
}

/// Whether a terminal would do something else than to show the character: control characters, marks of direction, line
/// separators.
bool is_control(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7F && code <= 0x9F) || (code >= 0x200B && code <= 0x200F) ||
         (code >= 0x2028 && code <= 0x202E) || (code >= 0x2060 && code <= 0x206F) || code == 0xFEFF;
}

/// Calls `take` with each letter of valid UTF-8.
template <class Take>
void for_each_letter(std::string_view text, Take&& take) {
  while (!text.empty()) {
    const std::size_t length = std::max<std::size_t>(1, letter_length(text));
    take(text.substr(0, length));
    text.remove_prefix(length);
  }
}

}  // namespace

std::string from_utf8_or_latin1(std::string_view text) {
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t length = letter_length(rest);
    if (length > 0) {
      rest.remove_prefix(length);
      continue;
    }
    std::string out;
    for (const char c : text) {
      const auto byte = static_cast<unsigned char>(c);
      if (byte >= 0x80) out += static_cast<char>(byte < 0xC0 ? 0xC2 : 0xC3);
      out += static_cast<char>(byte < 0xC0 ? byte : byte - 0x40);
    }
    return out;
  }
  return std::string(text);
}

std::string for_message(std::string_view text, std::size_t longest) {
  std::string out;
  std::size_t letters = 0;
  for_each_letter(from_utf8_or_latin1(text), [&](std::string_view letter) {
    if (++letters <= longest) out += is_control(code_of_letter(letter)) ? std::string_view("?") : letter;
  });
  return letters > longest ? out + "..." : out;
}

std::string in_ascii(std::string_view text) {
  // U+00C0 to U+00FF, as German and its neighbours write them without umlauts.
  static constexpr std::array<std::string_view, 64> letters{
      "A", "A", "A", "A", "Ae", "A", "Ae", "C", "E", "E", "E", "E", "I",  "I", "I",  "I",   //
      "D", "N", "O", "O", "O",  "O", "Oe", "",  "O", "U", "U", "U", "Ue", "Y", "Th", "ss",  //
      "a", "a", "a", "a", "ae", "a", "ae", "c", "e", "e", "e", "e", "i",  "i", "i",  "i",   //
      "d", "n", "o", "o", "o",  "o", "oe", "",  "o", "u", "u", "u", "ue", "y", "th", "y"};
  constexpr std::uint32_t first = 0xC0, diaeresis = 0x308, first_mark = 0x300, last_mark = 0x36F;
  std::string out;
  for_each_letter(from_utf8_or_latin1(text), [&](std::string_view letter) {
    const std::uint32_t code = code_of_letter(letter);
    if (code >= first && code < first + letters.size()) {
      out += letters[code - first];
    } else if (code >= first_mark && code <= last_mark) {  // an accent by itself, after its letter
      if (code == diaeresis) out += 'e';
    } else {
      out += letter;
    }
  });
  return out;
}

std::string as_utf8(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t length = letter_length(text);
    out += length == 0 ? std::string_view("\xEF\xBF\xBD") : text.substr(0, length);
    text.remove_prefix(std::max<std::size_t>(1, length));
  }
  return out;
}

}  // namespace talus
