#include "talus/io/rock_rows.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <optional>
#include <system_error>

#include "talus/core/check.hpp"
#include "talus/io/csv_reader.hpp"

namespace talus::io {

namespace {

constexpr std::uint64_t little = 1u << 16u;  // bytes that are read rather than searched further

/// The rock of the row with which a text begins, if it begins with a row.
std::optional<std::uint64_t> rock_at(std::string_view text, std::size_t column) {
  for (; column > 0; --column) {
    if (text.starts_with('"')) {
      std::size_t end = 1;
      while (end < text.size() && (text[end] != '"' || text.substr(end + 1).starts_with('"')))
        end += text[end] == '"' ? 2 : 1;
      text.remove_prefix(std::min(end, text.size()));
    }
    const std::size_t comma = text.find_first_of(",\n");
    if (comma == std::string_view::npos || text[comma] == '\n') return std::nullopt;
    text.remove_prefix(comma + 1);
  }
  std::uint64_t rock = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), rock);
  if (error != std::errc() || end == text.data() + text.size() || *end != ',') return std::nullopt;
  return rock;
}

/// Where a row begins that has no row of the rock before it; 0: the file's beginning. By bisection.
std::uint64_t begin_before(const std::filesystem::path& file, std::size_t column, std::uint64_t rock) {
  std::error_code error;
  std::uint64_t low = 0, high = std::filesystem::file_size(file, error);
  if (error) return 0;
  std::ifstream stream(file, std::ios::binary);
  std::string part;
  while (high - low > little) {
    const std::uint64_t middle = low + (high - low) / 2;
    part.resize(std::min<std::uint64_t>(little, high - middle));
    stream.seekg(static_cast<std::streamoff>(middle));
    if (!stream.read(part.data(), static_cast<std::streamsize>(part.size()))) return low;
    // Not every line begins a row: a name in quotes may hold a line's end.
    std::optional<std::uint64_t> found;
    std::size_t begin = part.find('\n');
    for (; begin != std::string::npos && !found; begin = part.find('\n', begin + 1))
      if ((found = rock_at(std::string_view(part).substr(begin + 1), column))) break;
    if (!found) return low;
    if (*found < rock) {
      low = middle + begin + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

}  // namespace

std::vector<std::vector<std::string>> rows_of_rock(const std::filesystem::path& file,
                                                   std::span<const std::string_view> columns, std::uint64_t rock) {
  const auto found = std::find(columns.begin(), columns.end(), "rock");
  TALUS_PROMISE(found != columns.end(), "the table has rocks");
  const auto column = static_cast<std::size_t>(found - columns.begin());
  CsvReader row(file, columns);
  if (const std::uint64_t begin = begin_before(file, column, rock); begin > 0) row.go_to(begin);
  std::vector<std::vector<std::string>> rows;
  while (row.next()) {
    const auto current = static_cast<std::uint64_t>(row.whole_number(column));
    if (current > rock) break;
    if (current < rock) continue;
    std::vector<std::string>& texts = rows.emplace_back();
    for (std::size_t k = 0; k < columns.size(); ++k) texts.emplace_back(row.text(k));
  }
  return rows;
}

}  // namespace talus::io
