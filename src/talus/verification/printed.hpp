#pragma once
// Published numbers as they were printed: the text says how many digits there are, and so how well it can be met.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace talus::verification {

/// One printed number.
struct Printed {
  std::string text;
  double value = 0;
  double unit = 1;  // one unit of the last printed digit
};

/// A number from its text: `-0.0260` has the unit 0.0001, `3.97E-05` 1e-7, `57` 1. Nothing where it is not a number.
[[nodiscard]] std::optional<Printed> printed(std::string_view text);

/// A published table: comma-separated, names of the columns first, the name of each row in the first column.
///
/// Programs print 15.4900 as 15.49 and 0.00000 as 0. A number that was cut short like this keeps the unit that its
/// column has: the coarsest unit among the column's numbers with the most significant digits, which cannot have been
/// cut.
class PublishedTable {
 public:
  /// Throws BadInput where the text is no such table; `file` is how messages call it.
  PublishedTable(std::string_view text, std::string file);

  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] const std::vector<std::string>& columns() const { return columns_; }  // without that of the names
  [[nodiscard]] const std::vector<std::string>& rows() const { return rows_; }
  [[nodiscard]] std::optional<std::size_t> column(std::string_view name) const;
  [[nodiscard]] std::optional<std::size_t> row(std::string_view name) const;
  /// Nothing where the table has no number there: an empty place, a dash, a word.
  [[nodiscard]] const std::optional<Printed>& number(std::size_t row, std::size_t column) const {
    return numbers_[row * columns_.size() + column];
  }
  /// As printed, number or not.
  [[nodiscard]] const std::string& text(std::size_t row, std::size_t column) const {
    return texts_[row * columns_.size() + column];
  }

 private:
  void find_units();

  std::string file_;
  std::vector<std::string> columns_, rows_, texts_;
  std::vector<std::optional<Printed>> numbers_;
};

}  // namespace talus::verification
