#include "talus/project/decimal_comma.hpp"

#include <algorithm>

namespace talus::project {

namespace {

bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }

bool is_all_digits(std::string_view text) { return !text.empty() && std::ranges::all_of(text, is_digit); }

}  // namespace

std::string with_decimal_point(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) return "";
  const std::string_view sign = text.substr(0, text.starts_with('-') || text.starts_with('+') ? 1 : 0);
  const std::string_view before = text.substr(sign.size(), comma - sign.size()), after = text.substr(comma + 1);
  if (!is_all_digits(before) || !is_all_digits(after)) return "";
  std::string number = std::string(text);
  number[comma] = '.';
  if (after.size() == 3 && before.front() != '0') number += " or " + std::string(sign).append(before).append(after);
  return number;
}

std::string first_with_decimal_point(std::string_view line) {
  for (std::size_t at = line.find('='); at != std::string_view::npos; at = line.find('=', at + 1)) {
    const std::size_t begin = line.find_first_not_of(" \t", at + 1);
    if (begin == std::string_view::npos) return "";
    std::string_view value = line.substr(begin);
    value = value.substr(0, value.find_first_not_of("+-0123456789,"));
    if (value.ends_with(',')) value.remove_suffix(1);  // before the next part of a table
    if (std::string number = with_decimal_point(value); !number.empty()) return number;
  }
  return "";
}

}  // namespace talus::project
