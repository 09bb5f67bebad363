#pragma once
// Numbers whose commas or points separate thousands, but would be read as decimal: 1,004 beside 998.

#include <optional>
#include <string>
#include <string_view>

#include "talus/core/problems.hpp"

namespace talus {

/// Looks at the numbers of one column of a table. One number alone may be either; a column has grouped digits if all
/// its numbers with a comma (or point) have three digits after it, those without are less than 1000, and the former
/// would otherwise be far smaller than the latter.
class GroupedDigits {
 public:
  /// A number as in the file, and its value if the mark is decimal.
  void add(std::string_view text, double value, int line);
  /// An error about the first number with grouped digits, without its file; nullopt if there is none.
  [[nodiscard]] std::optional<Problem> problem() const;

 private:
  bool may_be_ = true;
  std::string first_;  // with a mark
  int line_ = 0;       // of the first
  char mark_ = 0;
  std::string plain_;                       // the largest without
  double largest_ = 0, plain_largest_ = 0;  // with a mark, as decimals; without
};

}  // namespace talus
