#include "talus/calibration/observation_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>

#include "talus/core/nearest.hpp"
#include "talus/files/data_table.hpp"
#include "talus/files/mistyped_column.hpp"
#include "talus/files/ordinary_file.hpp"
#include "talus/project/values.hpp"

namespace talus::calibration {

namespace {

constexpr std::uintmax_t most_table_bytes = std::uintmax_t{64} << 20U;
constexpr std::size_t most_rows_reported = 10;

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string> split(std::string_view line, char separator) {
  std::vector<std::string> values(1);
  bool is_quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') {
      if (is_quoted && i + 1 < line.size() && line[i + 1] == '"') {
        values.back() += line[i++];
      } else {
        is_quoted = !is_quoted;
      }
    } else if (line[i] == separator && !is_quoted) {
      values.emplace_back();
    } else {
      values.back() += line[i];
    }
  }
  for (std::string& value : values) value = std::string(trimmed(value));
  return values;
}

Problem about_table(const std::string& file, std::string what, std::string why = {}, std::string hint = {}) {
  return {.file = file, .where = {}, .what = std::move(what), .why = std::move(why), .hint = std::move(hint)};
}

/// Whether a column's name ends with a unit.
bool has_unit(std::string_view plain) {
  for (std::size_t at = plain.find('_'); at != std::string_view::npos; at = plain.find('_', at + 1)) {
    if (is_unit_of_column(plain.substr(at + 1))) return true;
  }
  return false;
}

/// Whether `plain` is the quantity of a column with a unit, with another unit or none.
bool is_in_other_unit(const ObservedColumn& column, const std::string& plain) {
  std::string stem = plain_column_name(column.name);
  for (std::size_t at = stem.find('_'); at != std::string::npos; at = stem.find('_', at + 1)) {
    if (!is_unit_of_column(std::string_view(stem).substr(at + 1))) continue;
    stem.resize(at);
    return plain == stem ||
           (plain.starts_with(stem + "_") && is_unit_of_column(std::string_view(plain).substr(at + 1)));
  }
  return false;
}

std::string text_of_table(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::error_code error;
  if (!std::filesystem::exists(file, error)) throw BadInput(about_table(name, "there is no such file"));
  if (const auto why = not_an_ordinary_file(file)) throw BadInput(about_table(name, "the file is not read", *why));
  if (std::filesystem::file_size(file, error) > most_table_bytes) {
    throw BadInput(
        about_table(name, "the file is too large", fmt::format("expected at most {} MiB", most_table_bytes >> 20U)));
  }
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream || stream.bad()) throw BadInput(about_table(name, "the file cannot be read"));
  return std::move(text).str();
}

}  // namespace

bool ObservedColumn::is_named(std::string_view text) const {
  const std::string plain = plain_column_name(text);
  return plain == plain_column_name(name) ||
         std::ranges::any_of(others, [&](std::string_view other) { return plain == plain_column_name(other); });
}

void check_column_names(const Problem& place, std::span<const std::string> columns,
                        const std::vector<ObservedColumn>& known, Problems& problems, Problems& warnings) {
  std::vector<std::string_view> lacking;
  for (const ObservedColumn& one : known) {
    if (std::ranges::any_of(columns, [&](const std::string& column) { return one.is_named(column); })) continue;
    lacking.push_back(one.name);
    lacking.insert(lacking.end(), one.others.begin(), one.others.end());
  }
  for (const std::string& column : columns) {
    if (std::ranges::any_of(known, [&](const ObservedColumn& one) { return one.is_named(column); })) continue;
    const std::string plain = plain_column_name(column);
    Problem problem = place;
    const auto same =
        std::ranges::find_if(known, [&](const ObservedColumn& one) { return is_in_other_unit(one, plain); });
    if (same != known.end()) {
      problem.what = fmt::format("column \"{}\" has {}", column, has_unit(plain) ? "another unit" : "no unit");
      problem.why = fmt::format("the unit is in the name; expected {}", same->name);
      problem.hint = fmt::format("Convert it, and name it {}", same->name);
      problems.add(std::move(problem));
    } else if (const auto meant = mistyped_column(plain, lacking)) {
      problem.what = fmt::format("column \"{}\" is not known", column);
      problem.why = fmt::format("it would not be read, and there is no column {}", *meant);
      problem.hint = fmt::format("Name it {}, or otherwise if it is something else", *meant);
      problems.add(std::move(problem));
    } else if (const auto near = nearest(plain, lacking)) {
      problem.what = fmt::format("column \"{}\" is not read", column);
      problem.hint = fmt::format("Did you mean \"{}\"?", *near);
      problem.severity = Severity::warning;
      warnings.add(std::move(problem));
    }
  }
}

ObservationTable::ObservationTable(const std::filesystem::path& path) : file_(path.string()) {
  const std::string text = text_of_table(path);
  std::string_view left = text;
  if (left.starts_with("\xEF\xBB\xBF")) left.remove_prefix(3);  // as spreadsheets begin UTF-8
  Problems problems;
  std::size_t bad = 0;
  for (int line = 1; !left.empty(); ++line) {
    const std::size_t end = left.find('\n');
    const std::string_view row = trimmed(left.substr(0, end));
    left = end == std::string_view::npos ? std::string_view{} : left.substr(end + 1);
    if (row.empty() || row.starts_with('#')) continue;
    if (columns_.empty()) {
      for (const char each : {';', '\t', ','}) {
        if (row.find(each) != std::string_view::npos) {
          separator_ = each;
          break;
        }
      }
      columns_ = split(row, separator_);
      continue;
    }
    std::vector<std::string> values = split(row, separator_);
    if (values.size() != columns_.size()) {
      Problem problem =
          about_table(file_, fmt::format("the row has {}", project::counted(values.size(), "value", "values")),
                      fmt::format("the file has {}", project::counted(columns_.size(), "column", "columns")),
                      separator_ == ',' ? "Numbers have a decimal point; or separate values by semicolons" : "");
      problem.line = line;
      if (++bad <= most_rows_reported) problems.add(std::move(problem));
      continue;
    }
    rows_.push_back({line, std::move(values)});
  }
  if (bad > most_rows_reported)
    problems.add(about_table(file_, fmt::format("{} like this", project::counted(bad - most_rows_reported,
                                                                                 "more row is", "more rows are"))));
  if (rows_.empty() && bad == 0) {
    problems.add(
        about_table(file_, "there are no observations", "expected a line of column names, and a row for each rock"));
  }
  if (problems.has_errors()) throw BadInput(std::move(problems));
}

std::optional<std::size_t> ObservationTable::find(const ObservedColumn& column) const {
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    if (column.is_named(columns_[k])) return k;
  }
  return std::nullopt;
}

void ObservationTable::check_columns(const std::vector<ObservedColumn>& known, Problems& problems,
                                     Problems& warnings) const {
  check_column_names({.file = file_, .line = 1}, columns_, known, problems, warnings);
}

bool ObservationTable::is_in_degrees() const {
  return std::ranges::any_of(columns_, [](const std::string& column) {
    const std::string plain = plain_column_name(column);
    return plain.starts_with("lat") || plain.starts_with("lon") || plain == "lng";
  });
}

std::optional<double> ObservationTable::number(std::size_t row, std::size_t column, Problems& problems) const {
  std::string value = text(row, column);
  if (separator_ != ',') std::ranges::replace(value, ',', '.');
  double number = 0;
  const char* const begin = value.data() + (value.starts_with('+') ? 1 : 0);
  const auto [end, error] = std::from_chars(begin, value.data() + value.size(), number);
  if (error == std::errc{} && end == value.data() + value.size() && std::isfinite(number)) return number;
  Problem problem = at(row);
  problem.where = columns_[column];
  problem.what = value.empty() ? "the value is missing" : fmt::format("\"{}\" is not a number", text(row, column));
  problems.add(std::move(problem));
  return std::nullopt;
}

Problem ObservationTable::at(std::size_t row) const {
  Problem problem = about_table(file_, "");
  problem.line = rows_[row].line;
  return problem;
}

}  // namespace talus::calibration
