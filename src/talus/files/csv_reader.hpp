#pragma once
// Reads one of Talus's own comma-separated files row by row, in constant memory, and reports errors with file and line.
// Quoting follows RFC 4180, since the names of seeders and barriers are the user's.

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace talus {

class CsvReader {
 public:
  /// Expects exactly these columns in the file's first line, and any number of others at the place `more_at` if it is
  /// given; throws BadInput otherwise. The last `may_lack` of them may be missing.
  CsvReader(const std::filesystem::path& file, std::span<const std::string_view> columns,
            std::optional<std::size_t> more_at = {}, std::size_t may_lack = 0);
  /// Takes the columns that the file's first line names.
  explicit CsvReader(const std::filesystem::path& file);

  [[nodiscard]] std::span<const std::string> columns() const { return columns_; }

  /// Moves to the next row; false after the last. Throws BadInput for a row with too few or too many values or of more
  /// than a megabyte, and for a last line without a line end, the sign of a file that was cut short.
  [[nodiscard]] bool next();
  /// Continues with the row that begins at this byte of the file. Errors in it and in later rows have no line number.
  void go_to(std::uint64_t byte);

  // The values of the current row, by column. Views are valid until the next call of next().
  [[nodiscard]] std::string_view text(std::size_t column) const { return fields_[column]; }
  /// False too for the last columns if the table lacks them.
  [[nodiscard]] bool has_value(std::size_t column) const { return column < fields_.size() && !fields_[column].empty(); }
  [[nodiscard]] double number(std::size_t column) const;              // finite
  [[nodiscard]] std::int64_t whole_number(std::size_t column) const;  // not negative

  /// Throws BadInput about the current row.
  [[noreturn]] void refuse(std::string where, std::string what, std::string why, std::string hint = {}) const;
  /// About a value that is none of the known words; `fault` follows it in the message.
  [[noreturn]] void refuse_word(std::size_t column, std::string_view fault,
                                std::span<const std::string_view> known) const;

 private:
  [[nodiscard]] bool read_record();
  void split();

  std::string file_;
  std::vector<char> buffer_;
  std::ifstream stream_;
  std::vector<char> line_read_;
  std::string record_;    // the current row as in the file
  std::string unquoted_;  // text of its quoted values, into which fields_ may point
  std::vector<std::string_view> fields_;
  std::vector<std::string> columns_;
  int line_ = 0;  // of the current row's first line
  int lines_read_ = 0;
  bool is_line_known_ = true;
};

}  // namespace talus
