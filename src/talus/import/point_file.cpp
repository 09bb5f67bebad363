#include "talus/import/point_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "talus/core/problems.hpp"
#include "talus/core/stop.hpp"
#include "talus/files/first_problems.hpp"
#include "talus/files/grouped_digits.hpp"
#include "talus/files/mesh_problems.hpp"
#include "talus/files/ordinary_file.hpp"
#include "talus/import/point_columns.hpp"
#include "talus/import/raster_file.hpp"
#include "talus/meshing/cleaning.hpp"

namespace talus {
namespace {

constexpr std::string_view blanks = " \t\r";
constexpr std::size_t longest_line = 100'000;  // bytes; a binary file may have no line feed at all
constexpr std::size_t most_points = std::size_t{1} << 30U;

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::string_view value_of(std::string_view text) {
  text = trimmed(text);
  if (text.size() >= 2 && (text.front() == '"' || text.front() == '\'') && text.back() == text.front()) {
    text = text.substr(1, text.size() - 2);
  }
  return text;
}

std::optional<double> number(std::string_view word, bool comma_is_point) {
  std::array<char, 64> copy;
  if (comma_is_point && word.find(',') != std::string_view::npos) {
    if (word.size() > copy.size()) return std::nullopt;
    for (std::size_t i = 0; i < word.size(); ++i) copy[i] = word[i] == ',' ? '.' : word[i];
    word = {copy.data(), word.size()};
  }
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return value;
}

// ---- the file ----

class PointReader {
 public:
  PointReader(const std::filesystem::path& path, bool y_is_needed)
      : file_(path.string()), problems_(file_, "lines"), has_y_(y_is_needed), y_is_needed_(y_is_needed) {}

  /// Without y in the file, it is 0.
  [[nodiscard]] bool has_y() const { return has_y_; }

  std::vector<Vec3> read() {
    std::ifstream stream = opened();
    std::string line;
    while (next_line(stream, line)) {
      stop_point(static_cast<std::size_t>(number_));
      std::string_view text = trimmed(line);
      if (number_ == 1 && text.starts_with("\xEF\xBB\xBF")) text = trimmed(text.substr(3));
      const bool is_comment = text.starts_with('#') || text.starts_with("//");
      if (is_comment) text = trimmed(text.substr(text.starts_with('#') ? 1 : 2));
      if (text.empty() || (is_comment && !points_.empty())) continue;
      if (!is_known_) {
        choose_separator(text);
        if (!is_comment && separator_ == ',' && has_commas_in_numbers(text)) {
          stop_at_line("seems to have decimal commas", "its numbers have commas, and blanks separate its columns",
                       "Write decimal points, or separate the columns by semicolons");
        }
        split(text);
        if (number_ == 1 && !is_comment && read_total()) continue;
        if (is_comment ? names_all_columns() : has_words()) {
          name_columns();
          continue;
        }
        if (is_comment) continue;
        is_known_ = true;
        may_be_numbered_ = !has_names_ && words_.size() > 3;
        if (!has_names_) {
          named_at_ = line_number();
          column_count_ = count_columns();
          if (!y_is_needed_) expect_section_columns();
          may_have_decimal_commas_ = separator_ == ',' && column_count_ >= 6;
        }
      } else {
        split(text);
      }
      read_point();
    }
    for (const GroupedDigits& digits : digits_) {
      if (const auto found = digits.problem()) problems_.add(found->line, found->what, found->why, found->hint);
    }
    problems_.throw_if_any();
    if (points_.empty()) {
      stop("has no points", total_ ? "its first line is a count, but no point follows" : "no line has three numbers");
    }
    if (total_ && *total_ != points_.size()) {
      stop(fmt::format("has {} points", points_.size()), fmt::format("its first line declares {}", *total_),
           "Copy it again from its source, or remove that line");
    }
    if (may_have_decimal_commas_) {
      stop("seems to have decimal commas",
           "its lines have six or more integers between commas, and no line names the columns",
           "Write decimal points, or separate the columns by semicolons; if they are integers, name the columns in the "
           "first line, for example: x,y,z,red,green,blue");
    }
    if (const auto why = numbered()) {
      stop("seems to number its points in the first column", "no line names the columns, and the first number " + *why,
           "Name the columns in the first line, for example: id x y z");
    }
    return std::move(points_);
  }

 private:
  [[noreturn]] void stop(std::string what, std::string why, std::string hint = "") const {
    throw BadInput(
        Problem{.file = file_, .where = {}, .what = std::move(what), .why = std::move(why), .hint = std::move(hint)});
  }

  std::ifstream opened() const {
    if (const auto why = not_an_ordinary_file(file_)) stop("cannot be read", *why, "Name a file");
    errno = 0;
    std::ifstream stream(file_, std::ios::binary);
    if (!stream) {
      stop("cannot be read", std::error_code{errno, std::generic_category()}.message(),
           "Paths are relative to the project file");
    }
    return stream;
  }

  bool next_line(std::ifstream& stream, std::string& line) {
    line.clear();
    // Not getline(): a binary file may be one line of gigabytes.
    int c = 0;
    auto* buffer = stream.rdbuf();
    while ((c = buffer->sbumpc()) != std::char_traits<char>::eof()) {
      if (c == '\n') break;
      line += static_cast<char>(c);
      if (line.size() > longest_line) {
        stop("is not a text file of points", fmt::format("line {} has more than {} bytes", number_ + 1, longest_line));
      }
    }
    if (c == std::char_traits<char>::eof() && line.empty()) return false;
    ++number_;
    return true;
  }

  void choose_separator(std::string_view text) {
    separator_ = ' ';
    for (const char candidate : {';', '\t', ','}) {
      if (text.find(candidate) == std::string_view::npos) continue;
      separator_ = candidate;
      return;
    }
  }

  // Whether blanks separate the columns of a line, and two or more of them are a number with a comma: 2000,00 5000,00.
  static bool has_commas_in_numbers(std::string_view text) {
    std::size_t with_comma = 0;
    for (std::size_t at = text.find_first_not_of(blanks); at != std::string_view::npos;) {
      const std::size_t end = std::min(text.find_first_of(blanks, at), text.size());
      const std::string_view word = text.substr(at, end - at);
      const auto commas = std::ranges::count(word, ',');
      if (commas > 1 || word.starts_with(',') || word.ends_with(',')) return false;
      if (commas == 1 && ++with_comma && !number(word, true)) return false;
      at = text.find_first_not_of(blanks, end);
    }
    return with_comma > 1;
  }

  // The end of the quoted text that begins at `at`; `at` if none does.
  static std::size_t after_quotes(std::string_view text, std::size_t at) {
    const std::size_t begin = std::min(text.find_first_not_of(blanks, at), text.size());
    if (begin == text.size() || text[begin] != '"') return at;
    const std::size_t end = text.find('"', begin + 1);
    return end == std::string_view::npos ? at : end;
  }

  void split(std::string_view text) {
    words_.clear();
    if (separator_ == ' ') {
      for (std::size_t at = text.find_first_not_of(blanks); at != std::string_view::npos;) {
        const std::size_t end = std::min(text.find_first_of(blanks, at), text.size());
        words_.push_back(value_of(text.substr(at, end - at)));
        at = text.find_first_not_of(blanks, end);
      }
      return;
    }
    for (std::size_t at = 0; at <= text.size();) {
      const std::size_t end = std::min(text.find(separator_, after_quotes(text, at)), text.size());
      words_.push_back(value_of(text.substr(at, end - at)));
      at = end + 1;
    }
  }

  // A single integer, with which .pts files begin: the number of points.
  bool read_total() {
    if (words_.size() != 1) return false;
    std::size_t total = 0;
    const auto [end, error] = std::from_chars(words_[0].data(), words_[0].data() + words_[0].size(), total);
    if (error != std::errc{} || end != words_[0].data() + words_[0].size()) return false;
    total_ = total;
    return true;
  }

  [[nodiscard]] bool comma_is_point() const { return separator_ == ';' || separator_ == '\t'; }

  // Whether a line begins with a word, so that it must name the columns.
  [[nodiscard]] bool has_words() const { return !has_names_ && !number(words_[0], comma_is_point()); }
  // Whether a comment names all three coordinates: otherwise it is an ordinary comment.
  [[nodiscard]] bool names_all_columns() const {
    std::array<bool, 3> found{};
    for (const std::string_view word : words_) {
      if (const auto named = meaning_of_point_column(word)) found[named->axis] = true;
    }
    if (!y_is_needed_ && std::ranges::any_of(words_, means_distance)) found[0] = true;
    return found[0] && (found[1] || !y_is_needed_) && found[2];
  }

  // A section without names has two columns, distance and height, or three, x, y and z.
  void expect_section_columns() {
    has_y_ = column_count_ != 2;
    if (!has_y_) columns_ = {0, 0, 1};
  }

  void name_columns() {
    std::array<std::optional<std::size_t>, 3> columns;
    const auto distance = y_is_needed_ ? words_.end() : std::ranges::find_if(words_, means_distance);
    if (distance != words_.end()) columns[0] = static_cast<std::size_t>(distance - words_.begin());
    for (std::size_t i = 0; i < words_.size(); ++i) {
      const auto named = meaning_of_point_column(words_[i]);
      if (!named || (distance != words_.end() && named->axis < 2)) continue;
      if (named->in_feet) {
        stop_at_line(fmt::format("column {} is in feet", in_quotes(words_[i])),
                     "Talus needs coordinates and heights in metres",
                     "Convert it to metres: a foot is 0.3048 m, a US survey foot 1200/3937 m");
      }
      if (columns[named->axis]) {
        stop_at_line(fmt::format("columns {} and {} have the same meaning", in_quotes(words_[*columns[named->axis]]),
                                 in_quotes(words_[i])),
                     "expected one x, one y and one z", "Rename the one that is not to be used");
      }
      columns[named->axis] = i;
    }
    static constexpr std::array<std::string_view, 3> names{"x", "y", "z"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (columns[axis]) {
        columns_[axis] = *columns[axis];
        has_y_ = has_y_ || axis == 1;
        continue;
      }
      if (axis == 1 && !y_is_needed_) continue;
      for (const std::string_view word : words_) {
        if (axis == 2 || !means_degrees(word)) continue;
        stop_at_line(fmt::format("column {} is in degrees", in_quotes(word)), "Talus needs metres on plan",
                     "Project the points, for example with gdaltransform -s_srs EPSG:4326 -t_srs EPSG:XXXX");
      }
      std::string found;
      for (const std::string_view word : words_) found += (found.empty() ? "" : ", ") + in_quotes(word);
      stop_at_line(fmt::format("no column is named {}", names[axis]), fmt::format("the columns are {}", found),
                   "Name the columns x, y and z, or easting, northing and elevation");
    }
    has_names_ = true;
    named_at_ = line_number();
    column_count_ = count_columns();
  }

  // A separator at the end of a line does not begin another column.
  [[nodiscard]] std::size_t count_columns() const { return words_.size() - (words_.back().empty() ? 1 : 0); }

  [[nodiscard]] bool has_whole_numbers_only() const {
    return std::ranges::all_of(words_, [](std::string_view word) {
      const std::size_t sign = word.starts_with('-') || word.starts_with('+') ? 1 : 0;
      return word.size() > sign && word.find_first_not_of("0123456789", sign) == std::string_view::npos;
    });
  }

  // A surplus value may be the rest of a number with a decimal comma.
  [[nodiscard]] bool is_too_long() {
    const std::size_t count = count_columns();
    if (count <= column_count_) return false;
    const bool may_be_commas = separator_ == ',' && has_whole_numbers_only();
    problems_.add(line_number(), fmt::format("has {} columns", count),
                  fmt::format("line {} {} {}", named_at_, has_names_ ? "names" : "has", column_count_),
                  may_be_commas
                      ? "If its commas are decimal commas, write points, or separate the columns by semicolons"
                      : "Name all columns in the first line");
    return true;
  }

  [[noreturn]] void stop_at_line(std::string what, std::string why, std::string hint) const {
    throw BadInput(Problem{.file = file_,
                           .line = line_number(),
                           .where = {},
                           .what = std::move(what),
                           .why = std::move(why),
                           .hint = std::move(hint)});
  }

  [[nodiscard]] int line_number() const {
    return static_cast<int>(std::min<std::size_t>(number_, std::numeric_limits<int>::max()));
  }

  void read_point() {
    if (is_too_long()) return;
    may_have_decimal_commas_ = may_have_decimal_commas_ && has_whole_numbers_only();
    Vec3 point;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (axis == 1 && !has_y_) continue;
      if (columns_[axis] >= words_.size()) {
        problems_.add(line_number(), fmt::format("has {} of {} columns", words_.size(), columns_needed()),
                      axis == 2 && words_.size() == 2 ? "a point needs a height" : "a point needs x, y and z");
        return;
      }
      const std::string_view word = words_[columns_[axis]];
      const auto value = number(word, comma_is_point());
      if (value && comma_is_point()) digits_[axis].add(word, *value, line_number());
      if (!value || !std::isfinite(*value)) {
        problems_.add(line_number(), fmt::format("{} is not a number", in_quotes(word)),
                      fmt::format("expected {} in metres", axis == 0   ? "x"
                                                           : axis == 1 ? "y"
                                                                       : "z"));
        return;
      }
      if (axis < 2 && std::abs(*value) > largest_coordinate_m) {
        problems_.add(line_number(), fmt::format("{} is {:.10g}", axis == 0 ? "x" : "y", *value),
                      fmt::format("coordinates must be smaller than {:g} m", largest_coordinate_m));
        return;
      }
      point[axis] = *value;
    }
    if (point.z() < lowest_elevation_m || point.z() > highest_elevation_m) {
      problems_.add(line_number(), fmt::format("z is {:.10g}", point.z()),
                    fmt::format("heights must be between {:g} and {:g} m", lowest_elevation_m, highest_elevation_m),
                    "If it means no data, remove the line");
      return;
    }
    if (may_be_numbered_) note_numbering(point.x());
    if (points_.size() == most_points)
      stop("is too large", fmt::format("Talus reads fewer than {} points", most_points));
    points_.push_back(point);
  }

  // Only without names: the first column is x, unless it is the number of the point.
  void note_numbering(double first) {
    static constexpr std::string_view not_whole = ".,eE";
    may_be_numbered_ = words_[0].find_first_of(not_whole) == std::string_view::npos;
    counts_on_ = counts_on_ && (points_.empty() || first == points_.back().x() + 1);
    rises_ = rises_ && (points_.empty() || first > points_.back().x());
    for (std::size_t k = 1; k < 3; ++k)
      have_decimals_ = have_decimals_ && words_[k].find_first_of(not_whole) != std::string_view::npos;
    has_four_numbers_ = has_four_numbers_ && words_.size() > 3 && number(words_[3], comma_is_point());
  }

  // Why the first column seems to be the number of the point. The x of points may be whole, too; but then several have
  // the same x, or their y are whole as well.
  [[nodiscard]] std::optional<std::string> numbered() const {
    if (!may_be_numbered_ || points_.size() < 3) return std::nullopt;
    if (counts_on_) return "increases by 1 from line to line";
    if (!y_is_needed_) return std::nullopt;  // a section is in the order of its distances
    constexpr std::size_t few = 10;          // so few points with whole coordinates may be in the order of their x
    if (rises_ && has_four_numbers_ && points_.size() >= few) return "is whole and increases from line to line";
    if (!have_decimals_) return std::nullopt;
    std::vector<double> first;
    for (const Vec3& p : points_) first.push_back(p.x());
    std::ranges::sort(first);
    if (std::ranges::adjacent_find(first) != first.end()) return std::nullopt;
    return "is whole, and different in each line";
  }

  [[nodiscard]] std::size_t columns_needed() const {
    return 1 + std::max({columns_[0], has_y_ ? columns_[1] : 0, columns_[2]});
  }

  std::string file_;
  FirstProblems problems_;
  bool has_y_, y_is_needed_;
  std::vector<Vec3> points_;
  std::size_t number_ = 0;  // of the line, from 1
  char separator_ = ' ';
  std::optional<std::size_t> total_;  // number of points declared in the first line
  bool is_known_ = false;             // whether the separator and the columns are known
  bool has_names_ = false;
  int named_at_ = 0;  // the line that gives the number of columns
  std::size_t column_count_ = 0;
  bool may_have_decimal_commas_ = false;
  bool may_be_numbered_ = false;  // whether the first column may be the number of the point
  bool counts_on_ = true, rises_ = true, have_decimals_ = true, has_four_numbers_ = true;  // as numbered points
  std::array<GroupedDigits, 3> digits_;                                                    // of x, y and z
  std::array<std::size_t, 3> columns_{0, 1, 2};
  std::vector<std::string_view> words_;
};

}  // namespace

std::vector<Vec3> read_point_file(const std::filesystem::path& path) { return PointReader(path, true).read(); }

SectionPoints read_section_points(const std::filesystem::path& path) {
  PointReader reader(path, false);
  std::vector<Vec3> points = reader.read();
  return {std::move(points), reader.has_y()};
}

}  // namespace talus
