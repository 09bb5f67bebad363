#include "talus/verification/printed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "talus/core/problems.hpp"

namespace talus::verification {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The digits before an exponent, from the first that is not zero: 3 for `-0.0260`.
int significant_digits(std::string_view text) {
  int digits = 0;
  for (const char c : text.substr(0, text.find_first_of("eE"))) {
    if (is_digit(c) && (digits > 0 || c != '0')) ++digits;
  }
  return digits;
}

std::vector<std::string> split(std::string_view line) {
  std::vector<std::string> fields(1);
  for (const char c : line) {
    if (c == ',') {
      fields.emplace_back();
    } else {
      fields.back() += c;
    }
  }
  return fields;
}

std::optional<std::size_t> place(const std::vector<std::string>& names, std::string_view name) {
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names.begin());
}

}  // namespace

std::optional<Printed> printed(std::string_view text) {
  double value = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, value);
  if (error != std::errc{} || end != last || !std::isfinite(value)) return std::nullopt;
  const std::size_t exponent_at = text.find_first_of("eE");
  const std::string_view digits = text.substr(0, exponent_at);
  int power = 0;  // of ten
  if (exponent_at != std::string_view::npos) {
    std::string_view exponent = text.substr(exponent_at + 1);
    if (exponent.starts_with('+')) exponent.remove_prefix(1);
    std::from_chars(exponent.data(), exponent.data() + exponent.size(), power);
  }
  if (const std::size_t point = digits.find('.'); point != std::string_view::npos) {
    power -= static_cast<int>(digits.size() - point - 1);
  }
  return Printed{std::string(text), value, std::pow(10.0, power)};
}

PublishedTable::PublishedTable(std::string_view text, std::string file) : file_(std::move(file)) {
  int line_number = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    ++line_number;
    if (line.empty()) continue;
    std::vector<std::string> fields = split(line);
    if (line_number == 1) {
      columns_.assign(fields.begin() + 1, fields.end());
      continue;
    }
    if (fields.size() != columns_.size() + 1) {
      throw BadInput(Problem{.file = file_,
                             .line = line_number,
                             .where = {},
                             .what = fmt::format("the row has {} values", fields.size()),
                             .why = fmt::format("the first line names {} columns", columns_.size() + 1),
                             .hint = {}});
    }
    rows_.push_back(fields.front());
    for (std::size_t k = 1; k < fields.size(); ++k) {
      numbers_.push_back(printed(fields[k]));
      texts_.push_back(std::move(fields[k]));
    }
  }
  if (columns_.empty() || rows_.empty()) {
    throw BadInput(Problem{.file = file_,
                           .where = {},
                           .what = "the table is empty",
                           .why = "its first line names the columns, and rows follow",
                           .hint = {}});
  }
  find_units();
}

void PublishedTable::find_units() {
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    int most_digits = 0;
    double unit = 0;
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      const auto& number = numbers_[r * columns_.size() + c];
      if (!number) continue;
      const int digits = significant_digits(number->text);
      if (digits > most_digits) unit = 0;
      if (digits >= most_digits) unit = std::max(unit, number->unit);
      most_digits = std::max(most_digits, digits);
    }
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      auto& number = numbers_[r * columns_.size() + c];
      if (number && unit > 0) number->unit = std::min(number->unit, unit);
    }
  }
}

std::optional<std::size_t> PublishedTable::column(std::string_view name) const { return place(columns_, name); }
std::optional<std::size_t> PublishedTable::row(std::string_view name) const { return place(rows_, name); }

}  // namespace talus::verification
