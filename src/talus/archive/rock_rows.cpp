#include "talus/archive/rock_rows.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <optional>
#include <system_error>

namespace talus {

namespace {

constexpr std::uint64_t direct_read_bytes = 1u << 16u;  // bytes that are read without further bisection

/// The rock of the row in a line; nullopt if the line is not a whole row, which happens if a quoted name contains a
/// line end.
std::optional<std::uint64_t> rock_in(std::string_view line, std::size_t column, std::size_t columns) {
  std::optional<std::uint64_t> rock;
  for (std::size_t k = 0;; ++k) {
    std::size_t end = 0;
    if (line.starts_with('"')) {
      for (end = 1; end < line.size() && (line[end] != '"' || line.substr(end + 1).starts_with('"'));)
        end += line[end] == '"' ? 2 : 1;
      if (end >= line.size()) return std::nullopt;
    }
    end = std::min(line.find(',', end), line.size());
    if (k == column) {
      std::uint64_t number = 0;
      const auto [last, error] = std::from_chars(line.data(), line.data() + end, number);
      if (error == std::errc() && last == line.data() + end) rock = number;
    }
    if (end == line.size()) return k + 1 == columns ? rock : std::nullopt;
    line.remove_prefix(end + 1);
  }
}

/// The beginning of a row before which the rock has none, found by bisection; 0: the beginning of the file.
std::uint64_t begin_before(const std::filesystem::path& file, std::size_t column, std::size_t columns,
                           std::uint64_t rock) {
  std::error_code error;
  std::uint64_t low = 0, high = std::filesystem::file_size(file, error);
  if (error) return 0;
  std::ifstream stream(file, std::ios::binary);
  std::string part;
  while (high - low > direct_read_bytes) {
    const std::uint64_t middle = low + (high - low) / 2;
    part.resize(std::min<std::uint64_t>(direct_read_bytes, high - middle));
    stream.seekg(static_cast<std::streamoff>(middle));
    if (!stream.read(part.data(), static_cast<std::streamsize>(part.size()))) return low;
    std::optional<std::uint64_t> found;
    std::size_t begin = part.find('\n');
    while (begin != std::string::npos && !found) {
      const std::size_t end = part.find('\n', ++begin);
      if (end == std::string::npos) break;
      found = rock_in(std::string_view(part).substr(begin, end - begin), column, columns);
      if (!found) begin = end;
    }
    if (!found) return low;
    if (*found < rock) {
      low = middle + begin;
    } else {
      high = middle;
    }
  }
  return low;
}

}  // namespace

void go_near_rock(CsvReader& row, const std::filesystem::path& file, std::size_t column, std::uint64_t rock) {
  if (const std::uint64_t begin = begin_before(file, column, row.columns().size(), rock); begin > 0) row.go_to(begin);
}

}  // namespace talus
