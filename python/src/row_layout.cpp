#include "row_layout.hpp"

#include <fmt/format.h>

#include "talus/core/utf8.hpp"

namespace talus::python {

std::u32string code_points(std::string_view text) {
  const auto is_ascii = [](char c) { return (static_cast<unsigned char>(c) & 0x80U) == 0; };
  if (std::all_of(text.begin(), text.end(), is_ascii)) return {text.begin(), text.end()};
  const std::string valid = as_utf8(text);
  std::u32string points;
  for (std::size_t k = 0; k < valid.size();) {
    const auto first = static_cast<unsigned char>(valid[k]);
    const std::size_t length = first < 0x80 ? 1 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
    char32_t point = length == 1 ? first : first & (0x7fU >> length);
    for (std::size_t i = 1; i < length; ++i) point = point << 6U | (static_cast<unsigned char>(valid[k + i]) & 0x3fU);
    points.push_back(point);
    k += length;
  }
  return points;
}

std::string utf8(std::u32string_view text) {
  std::string out;
  const auto put = [&](char32_t byte) { out.push_back(static_cast<char>(byte)); };
  for (const char32_t point : text) {
    if (point < 0x80) {
      put(point);
    } else if (point < 0x800) {
      put(0xc0 | point >> 6U);
      put(0x80 | (point & 0x3fU));
    } else if (point < 0x10000) {
      put(0xe0 | point >> 12U);
      put(0x80 | (point >> 6U & 0x3fU));
      put(0x80 | (point & 0x3fU));
    } else {
      put(0xf0 | point >> 18U);
      put(0x80 | (point >> 12U & 0x3fU));
      put(0x80 | (point >> 6U & 0x3fU));
      put(0x80 | (point & 0x3fU));
    }
  }
  return out;
}

std::size_t width_of(std::span<const std::string> texts) {
  constexpr std::size_t most = 250;
  std::size_t width = 1;
  for (const std::string& text : texts) {
    width = std::max(width, code_points(text).size());
    if (width <= most) continue;
    throw BadInput(Problem{.where = fmt::format("\"{}...\"", as_utf8(text.substr(0, 40))),
                           .what = fmt::format("this name has {} characters", width),
                           .why = fmt::format("tables in memory hold names of up to {}", most),
                           .hint = "Give it a shorter name"});
  }
  return width;
}

void RowLayout::add(std::string name, std::string format, std::size_t width) {
  const std::size_t alignment = format.starts_with("<U") ? sizeof(char32_t) : sizeof(double);
  const std::size_t offset = (size + alignment - 1) / alignment * alignment;
  fields.push_back({std::move(name), std::move(format), offset, width});
  size = offset + width;
}

}  // namespace talus::python
