#include "talus/files/data_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <system_error>

#include "talus/core/problems.hpp"
#include "talus/core/stop.hpp"
#include "talus/core/utf8.hpp"
#include "talus/files/mesh_problems.hpp"
#include "talus/files/ordinary_file.hpp"

namespace talus {
namespace {

constexpr std::size_t longest_record = std::size_t{1} << 20;  // bytes
constexpr int most_lines = 100'000'000;
constexpr std::string_view spaces = " \t\r";

std::string_view without_spaces(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(spaces);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(spaces) - begin + 1);
}

bool is_letter_or_digit(char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); }

/// Semicolons and tabs before commas, which may be in numbers.
char separator_of(std::string_view header) {
  for (const char candidate : {';', '\t'}) {
    if (header.find(candidate) != std::string_view::npos) return candidate;
  }
  return ',';
}

}  // namespace

std::optional<double> number_in_cell(std::string_view text, bool comma_is_point) {
  std::array<char, 64> copy;
  if (comma_is_point && text.find(',') != std::string_view::npos) {
    if (text.size() > copy.size()) return std::nullopt;
    std::replace_copy(text.begin(), text.end(), copy.begin(), ',', '.');
    text = {copy.data(), text.size()};
  }
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string plain_column_name(std::string_view given) {
  const std::string name = in_ascii(given);
  std::string plain;
  for (std::size_t at = 0; at < name.size(); ++at) {
    char c = name[at];
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (std::string_view(name).substr(at).starts_with("\xC2\xB3")) {  // a superscript 3
      plain += '3';
      ++at;
    } else if (is_letter_or_digit(c)) {
      plain += c;
    } else if (!plain.empty() && plain.back() != '_') {
      plain += '_';
    }
  }
  while (plain.ends_with('_')) plain.pop_back();
  if (plain.ends_with("_mps")) plain.replace(plain.size() - 4, 4, "_m_s");
  return plain;
}

bool is_unit_of_column(std::string_view word) {
  static constexpr std::array units{"m",     "ft",   "feet",  "cm",     "mm",      "km",     "inch",  "in",  "kg",
                                    "g",     "t",    "to",    "lb",     "lbs",     "tonnes", "kn",    "m3",  "cm3",
                                    "dm3",   "l",    "ft3",   "m_s",    "km_h",    "kmh",    "ft_s",  "fps", "mph",
                                    "deg",   "rad",  "grad",  "degree", "degrees", "deg_s",  "rad_s", "rpm", "hz",
                                    "kg_m3", "t_m3", "g_cm3", "j",      "kj",      "mj"};
  return std::find(units.begin(), units.end(), word) != units.end();
}

DataTable::DataTable(const std::filesystem::path& file) : file_(file.string()), problems_(file_, "rows") {
  if (const auto why = not_an_ordinary_file(file)) stop(0, "cannot be read", *why, "Name a file");
  errno = 0;
  stream_.open(file, std::ios::binary);
  if (!stream_) {
    stop(0, "cannot be read", std::error_code{errno, std::generic_category()}.message(),
         "Paths are relative to the project file");
  }
  if (!read_record()) stop(0, "is empty", "its first line must name the columns");
  separator_ = separator_of(record_);
  split();
  const bool has_numbers_only = std::ranges::all_of(
      fields_, [&](std::string_view field) { return number_in_cell(field, comma_is_point()).has_value(); });
  if (has_numbers_only) {
    stop(line_, "names no columns", "its first line has only numbers",
         "Write the names of the columns in a first line");
  }
  std::vector<std::string> plain;
  for (const std::string_view field : fields_) {
    columns_.emplace_back(field);
    plain.push_back(plain_column_name(field));
    const auto same = std::find(plain.begin(), plain.end() - 1, plain.back());
    if (plain.back().empty() || same == plain.end() - 1) continue;
    stop(line_,
         fmt::format("column {} is named {}, as column {} is", columns_.size(), in_quotes(field),
                     same - plain.begin() + 1),
         "it is not clear which one to read", "Rename one of them");
  }
}

void DataTable::stop(int line, std::string what, std::string why, std::string hint) const {
  throw BadInput(Problem{.file = file_,
                         .line = line,
                         .where = {},
                         .what = std::move(what),
                         .why = std::move(why),
                         .hint = std::move(hint)});
}

void DataTable::refuse(std::string what, std::string why, std::string hint) {
  problems_.add(line_, std::move(what), std::move(why), std::move(hint));
}

bool DataTable::read_record() {
  auto* buffer = stream_.rdbuf();
  constexpr int end = std::char_traits<char>::eof();
  for (;;) {
    record_.clear();
    line_ = lines_read_ + 1;
    bool in_quotes = false;
    int c = buffer->sbumpc();
    if (c == end) return false;
    if (lines_read_ == most_lines) {
      stop(line_, fmt::format("has more than {} lines", most_lines), "Talus reads no more");
    }
    // Not getline(): a binary file may be one line of gigabytes.
    for (; c != end && (c != '\n' || in_quotes); c = buffer->sbumpc()) {
      if (c == '"') in_quotes = !in_quotes;
      if (c == '\n') ++lines_read_;
      record_ += static_cast<char>(c);
      if (record_.size() > longest_record) {
        stop(line_, fmt::format("a row has more than {} bytes", longest_record),
             in_quotes ? "a quoted value has no end" : "no row of a table is that long");
      }
    }
    if (in_quotes) stop(line_, "a quoted value has no end", "the file ends inside it");
    if (++lines_read_ == 1 && record_.starts_with("\xEF\xBB\xBF")) record_.erase(0, 3);
    const std::string_view text = without_spaces(record_);
    if (!text.empty() && !text.starts_with('#')) return true;
  }
}

void DataTable::split() {
  fields_.clear();
  unquoted_.clear();
  unquoted_.reserve(record_.size());  // keeps views into it valid while it grows
  const std::string_view row = record_;
  for (std::size_t at = 0;;) {
    const std::size_t begin = std::min(row.find_first_not_of(" \r", at), row.size());
    if (begin < row.size() && row[begin] == '"') {
      const std::size_t start = unquoted_.size();
      for (at = begin + 1; at < row.size(); ++at) {
        if (row[at] == '"' && (at + 1 == row.size() || row[++at] != '"')) break;
        unquoted_ += row[at];
      }
      fields_.push_back(without_spaces(std::string_view(unquoted_).substr(start)));
      at = std::min(row.find(separator_, at), row.size());
    } else {
      const std::size_t end = std::min(row.find(separator_, at), row.size());
      fields_.push_back(without_spaces(row.substr(at, end - at)));
      at = end;
    }
    if (at == row.size()) return;
    ++at;
  }
}

bool DataTable::next() {
  while (read_record()) {
    stop_point(static_cast<std::size_t>(rows_));
    ++rows_;
    split();
    // A separator at the end of a row does not begin another value.
    if (fields_.size() == columns_.size() + 1 && fields_.back().empty()) fields_.pop_back();
    if (fields_.size() == columns_.size()) {
      note_digits();
      return true;
    }
    const bool may_be_commas = separator_ == ',' && fields_.size() > columns_.size();
    refuse(
        fmt::format("the row has {} value{}", fields_.size(), fields_.size() == 1 ? "" : "s"),
        fmt::format("the first line names {} column{}", columns_.size(), columns_.size() == 1 ? "" : "s"),
        may_be_commas ? "If its commas are decimal commas, write points, or separate the columns by semicolons" : "");
  }
  for (const GroupedDigits& digits : digits_) {
    if (const auto found = digits.problem()) problems_.add(found->line, found->what, found->why, found->hint);
  }
  digits_.clear();
  return false;
}

void DataTable::note_digits() {
  if (!comma_is_point()) return;
  digits_.resize(columns_.size());
  for (std::size_t k = 0; k < fields_.size(); ++k) {
    if (const auto value = number_in_cell(fields_[k], comma_is_point())) digits_[k].add(fields_[k], *value, line_);
  }
}

}  // namespace talus
