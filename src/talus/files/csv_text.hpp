#pragma once
// Rows of comma-separated text. Numbers are written with the fewest digits that read back as the same number.

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

namespace talus {

/// The numbers of the previous row. A number that repeats in its column is not formatted again: in a path every
/// departure is where and when the rock arrived, and rocks of a seeder often have the same mass.
class CsvMemory {
 public:
  /// The digits of a number in a column.
  [[nodiscard]] std::string_view digits(std::size_t column, double x) {
    Cell& cell = cells_[column % cells_.size()];
    const auto bits = std::bit_cast<std::uint64_t>(x);
    if (cell.length == 0 || cell.bits != bits) {
      const char* const last = std::to_chars(cell.digits.data(), cell.digits.data() + cell.digits.size(), x).ptr;
      cell.length = static_cast<std::uint8_t>(last - cell.digits.data());
      cell.bits = bits;
    }
    return {cell.digits.data(), cell.length};
  }

 private:
  struct Cell {
    std::uint64_t bits = 0;
    std::array<char, 31> digits{};
    std::uint8_t length = 0;
  };
  std::array<Cell, 32> cells_;
};

class CsvRow {
 public:
  explicit CsvRow(std::string& text, CsvMemory* memory = nullptr) : text_(text), memory_(memory) {}
  CsvRow& operator<<(double x) {
    if (memory_ == nullptr) return number(x);
    const std::string_view digits = memory_->digits(column_, x);
    separate();
    put(digits);
    return *this;
  }
  CsvRow& operator<<(std::integral auto x) { return number(x); }
  /// Quoted if necessary (RFC 4180).
  CsvRow& operator<<(std::string_view word) {
    separate();
    if (word.find_first_of(",\"\r\n") == std::string_view::npos) {
      put(word);
      return *this;
    }
    put("\"");
    for (const char c : word) put(c == '"' ? "\"\"" : std::string_view(&c, 1));
    put("\"");
    return *this;
  }
  CsvRow& operator<<(const char* word) { return *this << std::string_view(word); }
  /// Adds the row to the text.
  void end() {
    put("\n");
    flush();
  }

 private:
  static constexpr std::size_t longest_number = 32;

  template <class Number>
  CsvRow& number(Number x) {
    separate();
    if (line_.size() - length_ < longest_number) flush();
    char* const begin = line_.data() + length_;
    length_ += static_cast<std::size_t>(std::to_chars(begin, begin + longest_number, x).ptr - begin);
    return *this;
  }
  void put(std::string_view part) {
    if (line_.size() - length_ < part.size()) flush();
    if (line_.size() < part.size()) {
      text_ += part;
      return;
    }
    std::copy(part.begin(), part.end(), line_.data() + length_);
    length_ += part.size();
  }
  void separate() {
    if (column_++ > 0) put(",");
  }
  void flush() {
    text_.append(line_.data(), length_);
    length_ = 0;
  }

  std::string& text_;
  CsvMemory* memory_;
  std::size_t column_ = 0;
  std::array<char, 512> line_;  // not yet appended to the text: one large append is faster than many small ones
  std::size_t length_ = 0;
};

}  // namespace talus
