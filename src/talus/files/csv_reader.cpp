#include "talus/files/csv_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "talus/core/problems.hpp"
#include "talus/core/stop.hpp"
#include "talus/files/ordinary_file.hpp"

namespace talus {
namespace {

// The part of a row that a message quotes: enough to find it, but not a whole file without line ends.
std::string excerpt(std::string_view text) {
  constexpr std::size_t most = 40;
  return text.size() <= most ? fmt::format("\"{}\"", text) : fmt::format("\"{}...\"", text.substr(0, most));
}

constexpr std::size_t longest_row = std::size_t{1} << 20;  // bytes; without the user's names about 300

constexpr auto cut_short = "The file was cut short or damaged; run the project again to write it anew";

}  // namespace

CsvReader::CsvReader(const std::filesystem::path& file)
    : file_(file.string()), buffer_(std::size_t{1} << 20), line_read_(longest_row + 2) {
  if (const auto why = not_an_ordinary_file(file)) refuse("", "cannot be opened", *why);
  stream_.rdbuf()->pubsetbuf(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
  stream_.open(file, std::ios::binary);
  if (!stream_) refuse("", "cannot be opened", "it must be a readable file");
  if (!read_record()) refuse("", "the file is empty", "its first line must name the columns", cut_short);
  split();
  columns_.assign(fields_.begin(), fields_.end());
}

CsvReader::CsvReader(const std::filesystem::path& file, std::span<const std::string_view> columns,
                     std::optional<std::size_t> more_at, std::size_t may_lack)
    : CsvReader(file) {
  const std::size_t least = columns.size() - may_lack, most = more_at ? columns_.size() : columns.size();
  const bool has_all = columns_.size() >= least && columns_.size() <= most;
  const std::size_t before = more_at.value_or(std::min(columns_.size(), columns.size())),
                    after = more_at ? columns.size() - before : 0;
  if (has_all && std::ranges::equal(columns.first(before), std::span(columns_).first(before)) &&
      std::ranges::equal(columns.last(after), std::span(columns_).last(after)))
    return;
  std::vector<std::string_view> expected(columns.begin(), columns.end() - static_cast<std::ptrdiff_t>(may_lack));
  if (more_at) expected.insert(expected.begin() + static_cast<std::ptrdiff_t>(before), "...");
  refuse("", fmt::format("the columns are {}", excerpt(record_)),
         fmt::format("expected \"{}\"", fmt::join(expected, ",")));
}

bool CsvReader::read_record() {
  record_.clear();
  line_ = lines_read_ + 1;
  for (bool open_quote = false;;) {  // a quoted value may contain a line end: read on while a quote is open
    // Not std::getline(): a binary file may be one line of gigabytes.
    stream_.getline(line_read_.data(), static_cast<std::streamsize>(line_read_.size()));
    const auto length = static_cast<std::size_t>(stream_.gcount());
    if (stream_.bad()) refuse("", "cannot be read", "the system reports a read error");
    if (stream_.eof() && length == 0) {
      if (!open_quote) return false;
      refuse("", "a quoted value has no end", "the file ends inside it", cut_short);
    }
    ++lines_read_;
    if (stream_.fail() || record_.size() + length > longest_row + 1) {
      refuse("", fmt::format("the row has more than {} bytes", longest_row), "no row of a table is that long",
             cut_short);
    }
    if (stream_.eof()) refuse("", "the last line has no line end", "every row ends with one", cut_short);
    const std::string_view part(line_read_.data(), length - 1);
    if (open_quote) record_ += '\n';
    record_ += part;
    if (std::ranges::count(part, '"') % 2 != 0) open_quote = !open_quote;
    if (!open_quote) break;
  }
  if (record_.ends_with('\r')) record_.pop_back();
  return true;
}

void CsvReader::split() {
  fields_.clear();
  unquoted_.clear();
  unquoted_.reserve(record_.size());  // keeps views into it valid while it grows
  const std::string_view row = record_;
  for (std::size_t at = 0;;) {
    if (at < row.size() && row[at] == '"') {
      const std::size_t start = unquoted_.size();
      for (++at; at < row.size(); ++at) {
        if (row[at] == '"' && (at + 1 == row.size() || row[++at] != '"')) break;
        unquoted_ += row[at];
      }
      fields_.push_back(std::string_view(unquoted_).substr(start));
      at = std::min(row.find(',', at), row.size());
    } else {
      const std::size_t end = std::min(row.find(',', at), row.size());
      fields_.push_back(row.substr(at, end - at));
      at = end;
    }
    if (at == row.size()) return;
    ++at;
  }
}

bool CsvReader::next() {
  stop_point(static_cast<std::size_t>(lines_read_));
  if (!read_record()) return false;
  split();
  if (fields_.size() != columns_.size()) {
    refuse("", fmt::format("the row has {} values", fields_.size()),
           fmt::format("expected {}, one for each column", columns_.size()), cut_short);
  }
  return true;
}

void CsvReader::go_to(std::uint64_t byte) {
  stream_.clear();
  stream_.seekg(static_cast<std::streamoff>(byte));
  is_line_known_ = false;
}

double CsvReader::number(std::size_t column) const {
  const std::string_view field = fields_[column];
  double value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc{} || end != field.data() + field.size() || !std::isfinite(value)) {
    refuse(columns_[column], fmt::format("{} is not a number", excerpt(field)), "expected a finite number");
  }
  return value;
}

std::int64_t CsvReader::whole_number(std::size_t column) const {
  const std::string_view field = fields_[column];
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc{} || end != field.data() + field.size() || value < 0) {
    refuse(columns_[column], fmt::format("{} is not a count", excerpt(field)), "expected a whole number, 0 or more");
  }
  return value;
}

void CsvReader::refuse(std::string where, std::string what, std::string why, std::string hint) const {
  throw BadInput({.file = file_,
                  .line = is_line_known_ ? line_ : 0,
                  .where = std::move(where),
                  .what = std::move(what),
                  .why = std::move(why),
                  .hint = std::move(hint)});
}

void CsvReader::refuse_word(std::size_t column, std::string_view fault, std::span<const std::string_view> known) const {
  refuse(columns_[column], fmt::format("\"{}\" {}", fields_[column], fault),
         fmt::format("expected one of {}", fmt::join(known, ", ")));
}

}  // namespace talus
