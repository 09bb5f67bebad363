#pragma once
// Reads a table of a user's data: text whose first line names the columns, one row per line.
//
// Values are separated by commas, semicolons or tabs, the same in the whole file; with semicolons and tabs, numbers may
// have decimal commas. Values may be quoted (RFC 4180), also over several lines. Empty lines and comments (#) are
// skipped. Every row has as many values as there are columns. Problems of rows are collected, the first ten with their
// lines, and thrown at the end.

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "talus/files/first_problems.hpp"
#include "talus/files/grouped_digits.hpp"

namespace talus {

/// A number as tables contain it: `12.5`, `+3`, `1e-3`; with a decimal comma if that is allowed. May be infinite or NaN
/// if the text says so; nullopt if it is not a number.
[[nodiscard]] std::optional<double> number_in_cell(std::string_view text, bool comma_is_point);

/// The name of a column in the form in which tables of Talus have it: lower case, words joined by underscores, without
/// umlauts and accents. So `Mass (kg)` is `mass_kg`, and `vx [m/s]` and `vx_mps` are `vx_m_s`.
[[nodiscard]] std::string plain_column_name(std::string_view name);

/// Whether a word with which a column's name ends is a unit, of those that people use, in the form of
/// plain_column_name.
[[nodiscard]] bool is_unit_of_column(std::string_view word);

class DataTable {
 public:
  /// Reads the names of the columns. Throws BadInput if the file cannot be opened, is empty, has no names or has two
  /// columns of the same name.
  explicit DataTable(const std::filesystem::path& file);

  /// The names as in the file, without blanks around them.
  [[nodiscard]] std::span<const std::string> columns() const { return columns_; }
  /// Moves to the next row with the right number of values; false after the last. Throws BadInput for text that is no
  /// table: a row of more than a megabyte, quotes that do not end.
  [[nodiscard]] bool next();
  /// The number of rows so far, bad ones included.
  [[nodiscard]] std::uint64_t rows() const { return rows_; }
  /// The line in which the current row begins, from 1.
  [[nodiscard]] int line() const { return line_; }
  /// A value of the current row, without blanks around it. Valid until the next call of next().
  [[nodiscard]] std::string_view text(std::size_t column) const { return fields_[column]; }
  [[nodiscard]] bool comma_is_point() const { return separator_ != ','; }

  /// Adds a problem of the current row.
  void refuse(std::string what, std::string why, std::string hint = "");
  /// Throws BadInput with the problems of all rows, if there are any.
  void throw_if_any() const { problems_.throw_if_any(); }

 private:
  [[nodiscard]] bool read_record();
  void split();
  void note_digits();
  [[noreturn]] void stop(int line, std::string what, std::string why, std::string hint = "") const;

  std::string file_;
  std::ifstream stream_;
  FirstProblems problems_;
  char separator_ = ',';
  std::string record_;    // the current row as in the file
  std::string unquoted_;  // text of its quoted values, into which fields_ may point
  std::vector<std::string_view> fields_;
  std::vector<std::string> columns_;
  std::vector<GroupedDigits> digits_;  // of the columns
  std::uint64_t rows_ = 0;
  int line_ = 0, lines_read_ = 0;
};

}  // namespace talus
