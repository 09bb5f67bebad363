#include "talus/import/mesh_text.hpp"

#include <charconv>
#include <cmath>

#include "talus/core/stop.hpp"

namespace talus {

std::optional<std::string_view> Lines::next() {
  if (rest_.empty()) return std::nullopt;
  stop_point(number_);
  const std::size_t end = rest_.find('\n');
  std::string_view line = rest_.substr(0, end);
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  ++number_;
  return line;
}

static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

std::string_view take_word(std::string_view& line) {
  std::size_t begin = 0;
  while (begin < line.size() && is_blank(line[begin])) ++begin;
  std::size_t end = begin;
  while (end < line.size() && !is_blank(line[end])) ++end;
  const std::string_view word = line.substr(begin, end - begin);
  line.remove_prefix(end);
  return word;
}

std::string lower(std::string_view word) {
  std::string out{word};
  for (char& c : out) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return out;
}

// from_chars does not accept a plus sign, which some programs write.
static std::string_view without_plus(std::string_view word) {
  return word.size() > 1 && word[0] == '+' && word[1] != '-' && word[1] != '+' ? word.substr(1) : word;
}

std::optional<double> read_coordinate(std::string_view word, MeshProblems& problems, const MeshPlace& place) {
  const std::string_view digits = without_plus(word);
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  const bool whole_word = end == digits.data() + digits.size();
  if (error == std::errc::result_out_of_range && whole_word) {
    problems.refuse(place, in_quotes(word) + " is out of range for a 64-bit number", "expected a coordinate in metres");
  } else if (error != std::errc() || !whole_word) {
    problems.refuse(place, in_quotes(word) + " is not a number", "expected a coordinate in metres",
                    word.find(',') == std::string_view::npos ? "" : "Write decimals with a point");
  } else if (!std::isfinite(value)) {
    problems.refuse(place, in_quotes(word) + " is not a finite number", "expected a coordinate in metres");
  } else {
    return value;
  }
  return std::nullopt;
}

std::optional<std::int64_t> whole_number(std::string_view word) {
  const std::string_view digits = without_plus(word);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return value;
}

}  // namespace talus
