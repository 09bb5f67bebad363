#pragma once
// Published numbers as printed: the number of digits limits how closely they can be matched.

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

/// Reads a number: `-0.0260` has the unit 0.0001, `3.97E-05` 1e-7, `57` 1. nullopt if it is not a number.
[[nodiscard]] std::optional<Printed> printed(std::string_view text);

/// A published table: comma-separated, with the names of the columns in the first line and those of the rows in the
/// first column.
///
/// Programs print 15.4900 as 15.49 and 0.00000 as 0. A number without its trailing zeros has the unit of its column:
/// the coarsest unit among the numbers of the column with the most significant digits, which have lost no zeros.
class PublishedTable {
 public:
  /// Throws BadInput if the text is not such a table; `file` is its name in messages.
  PublishedTable(std::string_view text, std::string file);

  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] const std::vector<std::string>& columns() const { return columns_; }  // without the column of row names
  [[nodiscard]] const std::vector<std::string>& rows() const { return rows_; }
  [[nodiscard]] std::optional<std::size_t> column(std::string_view name) const;
  [[nodiscard]] std::optional<std::size_t> row(std::string_view name) const;
  /// nullopt if the table has no number there, but an empty cell, a dash or a word.
  [[nodiscard]] const std::optional<Printed>& number(std::size_t row, std::size_t column) const {
    return numbers_[row * columns_.size() + column];
  }
  /// The text as printed, number or not.
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
