#include "talus/files/grouped_digits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace talus {

namespace {

constexpr std::string_view digits = "0123456789";

/// Whether the digits before and after the mark are those of thousands: one to three that do not begin with 0, then
/// three.
bool is_grouped(std::string_view text, std::size_t mark) {
  const std::size_t sign = text.starts_with('-') || text.starts_with('+') ? 1 : 0;
  const std::string_view before = text.substr(sign, mark - sign), after = text.substr(mark + 1);
  return !before.empty() && before.size() <= 3 && before.front() != '0' && after.size() == 3 &&
         before.find_first_not_of(digits) == std::string_view::npos &&
         after.find_first_not_of(digits) == std::string_view::npos;
}

}  // namespace

void GroupedDigits::add(std::string_view text, double value, int line) {
  if (!may_be_) return;
  const std::size_t mark = text.find_first_of(",.");
  value = std::abs(value);
  constexpr double thousand = 1000;
  if (mark == std::string_view::npos) {
    may_be_ = value < thousand;
    if (value > plain_largest_) {
      plain_largest_ = value;
      plain_ = text;
    }
    return;
  }
  may_be_ = is_grouped(text, mark) && (mark_ == 0 || mark_ == text[mark]);
  if (mark_ == 0) {
    mark_ = text[mark];
    first_ = text;
    line_ = line;
  }
  largest_ = std::max(largest_, value);
}

std::optional<Problem> GroupedDigits::problem() const {
  constexpr double near_thousand = 100, far_smaller = 0.1;
  if (!may_be_ || mark_ == 0 || plain_largest_ < near_thousand || largest_ > far_smaller * plain_largest_)
    return std::nullopt;
  std::string whole = first_;
  std::erase(whole, mark_);
  const char* const marks = mark_ == ',' ? "commas" : "points";
  return Problem{
      .line = line_,
      .where = {},
      .what = fmt::format("\"{}\" seems to be {}", first_, whole),
      .why = fmt::format("other numbers of the column, such as {}, have no {}: {} seem to separate thousands", plain_,
                         mark_ == ',' ? "comma" : "point", marks),
      .hint = "Write numbers without separators of thousands"};
}

}  // namespace talus
