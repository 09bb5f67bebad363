#pragma once
// Rows of comma-separated text. Numbers are written with the fewest digits that read back as the same number.

#include <charconv>
#include <concepts>
#include <string>
#include <string_view>

namespace talus {

class CsvRow {
 public:
  explicit CsvRow(std::string& text) : text_(text) {}
  CsvRow& operator<<(double x) { return number(x); }
  CsvRow& operator<<(std::integral auto x) { return number(x); }
  /// Quoted where it must be (RFC 4180).
  CsvRow& operator<<(std::string_view word) {
    separate();
    if (word.find_first_of(",\"\r\n") == std::string_view::npos) {
      text_ += word;
      return *this;
    }
    text_ += '"';
    for (const char c : word) {
      if (c == '"') text_ += '"';
      text_ += c;
    }
    text_ += '"';
    return *this;
  }
  CsvRow& operator<<(const char* word) { return *this << std::string_view(word); }
  void end() { text_ += '\n'; }

 private:
  template <class Number>
  CsvRow& number(Number x) {
    separate();
    char digits[32];
    const auto [last, error] = std::to_chars(digits, digits + sizeof digits, x);
    text_.append(digits, last);
    return *this;
  }
  void separate() {
    if (!first_) text_ += ',';
    first_ = false;
  }
  std::string& text_;
  bool first_ = true;
};

}  // namespace talus
