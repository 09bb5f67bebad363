#include "talus/gdal/ascii_grid_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/core/stop.hpp"
#include "talus/files/mesh_problems.hpp"

namespace talus {

namespace {

constexpr std::size_t chunk_bytes = 1 << 20;
constexpr std::uint64_t most_reported = 10;  // bad cells
constexpr std::size_t longest_number = 400;  // GDAL reads up to 498 characters

constexpr std::array<std::string_view, 10> keys{"ncols",     "nrows",    "xllcorner", "yllcorner", "xllcenter",
                                                "yllcenter", "cellsize", "dx",        "dy",        "nodata_value"};

// As in the C locale; std::isspace looks up the locale for each character.
bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

bool is_key(std::string_view word) { return std::ranges::find(keys, word) != keys.end(); }

/// Whether a token means "not a number", as most programs or those of Microsoft write it.
bool is_nan(std::string_view token) {
  const std::string word = lower(token.starts_with('-') || token.starts_with('+') ? token.substr(1) : token);
  return word == "nan" || word == "1.#qnan" || word == "1.#snan" || word == "1.#ind";
}

/// A number as GDAL reads it, with a decimal point or comma. Numbers too large for a double are infinite.
std::optional<double> number_of(std::string_view token) {
  if (token.starts_with('+')) {
    token.remove_prefix(1);
    if (token.starts_with('+') || token.starts_with('-')) return std::nullopt;
  }
  if (token.empty() || token.size() > longest_number) return std::nullopt;
  double number = 0;
  const char* const end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, number);
  if (stop == end && error == std::errc{}) {
    return std::isfinite(number) ? std::optional(number) : std::nullopt;  // "inf" is not a number of a grid
  }
  if (stop == end) {  // out of range: near 0, or too large
    return lower(token).find("e-") != std::string::npos ? 0 : std::numeric_limits<double>::infinity();
  }
  if (*stop != ',' && token.front() != ',' && !token.starts_with("-,")) return std::nullopt;
  std::string pointed(token);
  pointed[token.find(',')] = '.';
  return pointed.find(',') == std::string::npos ? number_of(pointed) : std::nullopt;
}

/// A number of columns or rows: `12`, or `12.000`.
std::optional<std::uint64_t> count_of(std::string_view token) {
  std::uint64_t count = 0;
  const char* const end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, count);
  if (error != std::errc{} || count < 1 || count > std::numeric_limits<std::int32_t>::max()) return std::nullopt;
  if (stop == end) return count;
  const std::string_view rest(stop + 1, end);
  return *stop == '.' && rest.find_first_not_of('0') == std::string_view::npos ? std::optional(count) : std::nullopt;
}

/// Where GDAL begins to read cells: at the first line that does not begin with a letter.
std::size_t start_of_cells(std::string_view text) {
  const auto ends_line = [](char c) { return c == '\n' || c == '\r'; };
  for (std::size_t i = 2; i < text.size(); ++i) {
    if (!ends_line(text[i - 1]) && !ends_line(text[i - 2])) continue;
    const bool is_letter = std::isalpha(static_cast<unsigned char>(text[i])) != 0 && text.substr(i, 5) != "null ";
    if (!is_letter && !ends_line(text[i])) return i;
  }
  return text.size();
}

class GridCheck {
 public:
  GridCheck(const std::filesystem::path& file, GridNumbers numbers)
      : numbers_(numbers), file_(file.string()), stream_(file, std::ios::binary) {}

  void run() {
    const std::size_t in_header = start_of_cells(fill(0));
    read_header(text().substr(0, in_header));
    // Without a valid header the cells cannot be checked.
    throw_if_any();
    read_cells(in_header);
    if (bad_cells_ > most_reported)
      report(0, fmt::format("{} more cells are not numbers", bad_cells_ - most_reported), "");
    if (cells_ != columns_ * rows_) report_count();
    throw_if_any();
  }

 private:
  struct Word {
    std::string_view text;
    int line;
    bool begins_line;
  };

  void report(int line, std::string what, std::string why, std::string hint = "") {
    problems_.add(Problem{.file = file_,
                          .line = line,
                          .where = {},
                          .what = std::move(what),
                          .why = std::move(why),
                          .hint = std::move(hint)});
  }

  void throw_if_any() const {
    if (problems_.has_errors()) throw BadInput(problems_);
  }

  [[nodiscard]] std::string_view text() const { return {buffer_.data(), used_}; }

  /// Drops the bytes before `from` from the buffer, and fills it up from the file.
  std::string_view fill(std::size_t from) {
    stop_point();
    buffer_.resize(2 * chunk_bytes);
    std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(from), buffer_.begin() + static_cast<std::ptrdiff_t>(used_),
              buffer_.begin());
    used_ -= from;
    stream_.read(buffer_.data() + used_, static_cast<std::streamsize>(buffer_.size() - used_));
    used_ += static_cast<std::size_t>(stream_.gcount());
    return text();
  }

  // ---- the header ----

  void read_header(std::string_view header) {
    const std::vector<Word> words = words_of(header);
    for (std::size_t i = 0; i < words.size(); ++i) {
      const Word& word = words[i];
      const std::string key = lower(word.text);
      if (!is_key(key)) {
        if (word.begins_line) check_other_line(word);
        continue;
      }
      if (given(key)) report(word.line, fmt::format("{} is given twice", word.text), "one of them is wrong");
      const bool has_value = i + 1 < words.size() && words[i + 1].line == word.line;
      given_.push_back({key, has_value ? std::string(words[i + 1].text) : "", word.line});
      if (has_value) ++i;
      check_value(given_.back(), word.text);
    }
    check_missing_keys();
  }

  std::vector<Word> words_of(std::string_view header) {
    std::vector<Word> words;
    int last = 0;
    for (std::size_t i = 0; i < header.size();) {
      if (header[i] == '\n') ++line_;
      if (is_space(header[i])) {
        ++i;
        continue;
      }
      std::size_t end = i;
      while (end < header.size() && !is_space(header[end])) ++end;
      words.push_back({header.substr(i, end - i), line_, line_ != last});
      last = line_;
      i = end;
    }
    return words;
  }

  /// GDAL skips lines of the header with other keys, and so would skip a row of cells that begins with a letter.
  void check_other_line(const Word& word) {
    last_other_line_ = word.line;
    if (!is_nan(word.text) && lower(word.text) != "null") return;
    report(word.line, fmt::format("the first row begins with {}", in_quotes(word.text)),
           "a line that begins with a letter counts as part of the header",
           "Write no-data cells as a number, for example -9999, and declare it: NODATA_value -9999");
  }

  struct Given {
    std::string key, value;
    int line;
  };

  [[nodiscard]] const Given* given(std::string_view key) const {
    const auto found = std::ranges::find(given_, key, &Given::key);
    return found == given_.end() ? nullptr : &*found;
  }

  void check_value(const Given& entry, std::string_view key) {
    const auto refuse = [&](const char* expected) {
      report(entry.line,
             entry.value.empty() ? fmt::format("{} has no value", key)
                                 : fmt::format("{} is {}", key, in_quotes(entry.value)),
             fmt::format("expected {}", expected));
    };
    if (entry.key == "ncols" || entry.key == "nrows") {
      const auto count = count_of(entry.value);
      if (!count) refuse("a whole number, 1 or more");
      (entry.key == "ncols" ? columns_ : rows_) = count.value_or(0);
      return;
    }
    const auto number = number_of(entry.value);
    const bool is_finite = number && std::isfinite(*number);
    if (entry.key == "nodata_value") {
      if (!number && !is_nan(entry.value) && entry.value != "null") refuse("a number");
    } else if (entry.key == "cellsize" || entry.key == "dx" || entry.key == "dy") {
      if (!is_finite || *number <= 0) refuse("a number, more than 0");
    } else if (!is_finite) {
      refuse("a number");
    }
  }

  void check_missing_keys() {
    for (const char* key : {"ncols", "nrows"}) {
      if (!given(key)) report(0, fmt::format("has no {}", key), "the header needs it");
    }
    if (!given("cellsize") && !(given("dx") && given("dy")))
      report(0, "has no cellsize", "the header needs it, or dx and dy");
    if ((given("xllcorner") && given("yllcorner")) || (given("xllcenter") && given("yllcenter"))) return;
    report(0, "is not georeferenced", "the header needs xllcorner and yllcorner, or xllcenter and yllcenter");
  }

  // ---- the cells ----

  void read_cells(std::size_t from) {
    for (bool has_more = true; has_more;) {
      has_more = stream_.good();
      const std::string_view unread = text().substr(from);
      std::size_t end = unread.size();
      // The last number may continue in the next chunk, unless it is longer than any number.
      while (has_more && end > 0 && !is_space(unread[end - 1])) --end;
      if (end == 0 && unread.size() > longest_number) end = unread.size();
      read_some(unread.substr(0, end));
      if (has_more) fill(from + end);
      from = 0;
    }
  }

  void read_some(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
      if (text[i] == '\n') end_line();
      if (is_space(text[i])) {
        ++i;
        continue;
      }
      std::size_t end = i + 1;
      while (end < text.size() && !is_space(text[end])) ++end;
      check_cell(text.substr(i, end - i));
      i = end;
    }
  }

  void end_line() {
    ++line_;
    if (first_line_ == 0) first_line_ = cells_;
  }

  void check_cell(std::string_view token) {
    // (Old programs end a text with Ctrl-Z.)
    if (cells_ >= columns_ * rows_ && token.find_first_not_of(std::string_view("\x1a\0", 2)) == token.npos) return;
    ++cells_;
    if (cells_ == columns_ * rows_ + 1) first_surplus_ = line_;
    const auto refuse = [&](std::string why, std::string hint = "") {
      if (++bad_cells_ > most_reported) return;
      const std::uint64_t cell = cells_ - 1;
      report(line_, fmt::format("{} is not a number", in_quotes(token)),
             fmt::format("it is in row {}, column {}{}", cell / columns_ + 1, cell % columns_ + 1, why),
             std::move(hint));
    };
    const auto number = number_of(token);
    if (number) {
      using Limits = std::numeric_limits<std::int32_t>;
      if (numbers_ == GridNumbers::whole && (*number < Limits::min() || *number > Limits::max()))
        refuse("; integers have 32 bits", "Write it with a decimal point");
    } else if (!is_nan(token) && token != "null") {
      refuse("");
    } else if (numbers_ == GridNumbers::whole) {
      refuse("; in a grid of integers it would be read as 0",
             "Write no-data cells as a number, for example -9999, and declare it: NODATA_value -9999");
    }
  }

  void report_count() {
    const std::uint64_t needed = columns_ * rows_;
    std::string hint = "Copy it again from its source";
    if (cells_ < needed && last_other_line_ > 0) {
      hint = fmt::format("Line {} begins with a letter and so counts as part of the header: does it contain cells?",
                         last_other_line_);
    } else if (first_line_ > 0 && first_line_ != columns_) {
      hint = fmt::format("Its first line of cells has {}: is ncols wrong?", first_line_);
    } else if (cells_ > needed && cells_ % columns_ == 0) {
      hint = fmt::format("That makes {} rows: is nrows wrong?", cells_ / columns_);
    }
    report(cells_ > needed ? first_surplus_ : line_, fmt::format("has {} cells", cells_),
           fmt::format("ncols {} and nrows {} make {}", columns_, rows_, needed), std::move(hint));
  }

  GridNumbers numbers_;
  std::string file_;
  std::ifstream stream_;
  std::string buffer_;
  std::size_t used_ = 0;
  Problems problems_;
  std::vector<Given> given_;
  std::uint64_t columns_ = 0, rows_ = 0, cells_ = 0, bad_cells_ = 0;
  std::uint64_t first_line_ = 0;  // cells in the first line that has any
  int line_ = 1, first_surplus_ = 0;
  int last_other_line_ = 0;  // last line of the header without a known key
};

}  // namespace

bool is_ascii_grid(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return false;
  std::array<char, 1024> begin{};
  std::ifstream stream(file, std::ios::binary);
  stream.read(begin.data(), begin.size());
  const std::string text = lower({begin.data(), static_cast<std::size_t>(stream.gcount())});
  const auto end = std::ranges::find_if(text, is_space);
  const std::string_view first(text.data(), static_cast<std::size_t>(end - text.begin()));
  // (Another kind of file may begin with "dx", too.)
  return end != text.end() && first != "nodata_value" && is_key(first) &&
         (text.find("ncols") != std::string::npos || text.find("nrows") != std::string::npos);
}

void check_ascii_grid(const std::filesystem::path& file, GridNumbers numbers) { GridCheck(file, numbers).run(); }

}  // namespace talus
