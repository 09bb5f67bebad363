#include "talus/project/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <optional>
#include <sstream>
#include <system_error>
#include <vector>

#include "talus/core/utf8.hpp"
#include "talus/project/decimal_comma.hpp"

namespace talus::project {
namespace {

constexpr std::string_view override_mark = "--set ";

Problem about_file(const std::filesystem::path& file, std::string what, std::string why = {}, std::string hint = {}) {
  return {.file = file.string(), .where = {}, .what = std::move(what), .why = std::move(why), .hint = std::move(hint)};
}

std::string_view line_of(std::string_view text, std::size_t number) {
  for (; number > 1 && !text.empty(); --number) text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  return text.substr(0, text.find('\n'));
}

/// A hint if a line that is not TOML has a decimal comma.
std::string comma_hint(std::string_view line) {
  const std::string number = first_with_decimal_point(line);
  return number.empty() ? "" : fmt::format("Write {}: numbers have a decimal point", number);
}

/// A hint if it has a backslash in double quotes, as Windows paths do.
std::string backslash_hint(std::string_view line) {
  const std::size_t backslash = line.find('\\');
  if (backslash == std::string_view::npos || line.substr(0, backslash).find('"') == std::string_view::npos) return "";
  return "In double quotes a backslash begins an escape: write paths with /, or in single quotes";
}

std::string hint_at(std::string_view line) {
  const std::string hint = backslash_hint(line);
  return hint.empty() ? comma_hint(line) : hint;
}

/// Throws BadInput if the text is not UTF-8, with the probable encoding.
void check_encoding(std::string_view text, const std::string& file) {
  constexpr const char* how = "Save it as UTF-8; most editors offer this under Save as";
  const auto begins_with = [&](unsigned char a, unsigned char b) {
    return text.size() >= 2 && static_cast<unsigned char>(text[0]) == a && static_cast<unsigned char>(text[1]) == b;
  };
  const bool has_zero = text.size() >= 2 && (text[0] == '\0' || text[1] == '\0');
  if (begins_with(0xff, 0xfe) || begins_with(0xfe, 0xff) || has_zero) {
    throw BadInput(about_file(file, "the file is UTF-16", "a project file is UTF-8", how));
  }
  const std::string read = as_utf8(text);
  if (read == text) return;
  const auto [before, after] = std::ranges::mismatch(text, read);
  Problem problem = about_file(
      file, fmt::format("the byte {:#04x} is not UTF-8", static_cast<unsigned char>(*before)),
      "a project file is UTF-8; Latin-1 and Windows-1252 write letters such as \u00e4 and \u00e9 as single bytes", how);
  problem.line = 1 + static_cast<int>(std::count(text.begin(), before, '\n'));
  throw BadInput(std::move(problem));
}

/// The longest keys of a project have four parts. toml++ limits the nesting of values (256), but not the number of
/// parts of a key, and its destructors recurse into each part.
constexpr std::size_t most_parts_of_a_key = 16;

/// The end of the quoted string that begins at `at`: after its closing quote, or at the end of the line if that is
/// missing.
std::size_t end_of_text(std::string_view toml, std::size_t at) {
  const char quote = toml[at];
  const bool is_long = toml.substr(at, 3) == std::string(3, quote);
  const std::string_view ending = toml.substr(at, is_long ? 3 : 1);
  for (std::size_t i = at + ending.size(); i < toml.size(); ++i) {
    if (toml[i] == '\\' && quote == '"') {
      ++i;
    } else if (toml.substr(i).starts_with(ending)) {
      return i + ending.size();
    } else if (toml[i] == '\n' && !is_long) {
      return i;
    }
  }
  return toml.size();
}

/// The line of the first key with too many parts (`a.b.c...`).
std::optional<int> line_of_overlong_key(std::string_view toml) {
  std::size_t points = 0;
  int line = 1;
  for (std::size_t i = 0; i < toml.size();) {
    const char letter = toml[i];
    std::size_t end = i + 1;
    if (letter == '"' || letter == '\'') {
      end = end_of_text(toml, i);
      line += static_cast<int>(std::ranges::count(toml.substr(i, end - i), '\n'));
    } else if (letter == '#') {
      end = std::min(toml.find('\n', i), toml.size());
    } else if (letter == '\n') {
      ++line;
      points = 0;
    } else if (letter == '.') {
      if (++points >= most_parts_of_a_key) return line;
    } else if (std::string_view("=[]{},").find(letter) != std::string_view::npos) {
      points = 0;
    }
    i = end;
  }
  return std::nullopt;
}

std::optional<std::size_t> whole_number(std::string_view text) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// The number of the list entry that a part of a path refers to, by number or by name.
std::optional<std::size_t> entry(const toml::array& list, const std::string& part) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    const toml::table* table = list[i].as_table();
    if (table && (*table)["name"].value<std::string>() == part) return i;
  }
  const std::optional<std::size_t> number = whole_number(part);
  return number && *number < list.size() ? number : std::nullopt;
}

/// TOML as people write it: numbers with the fewest digits that identify them (toml++ writes 17). Stops early once more
/// than `enough` characters are written.
std::string in_one_line(const toml::node& node, std::size_t enough) {
  if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
  std::string text;
  if (const toml::array* list = node.as_array()) {
    for (const toml::node& item : *list) {
      if (text.size() > enough) break;
      text += (text.empty() ? "" : ", ") + in_one_line(item, enough);
    }
    return '[' + text + ']';
  }
  if (const toml::table* table = node.as_table()) {
    for (const auto& [key, item] : *table) {
      if (text.size() > enough) break;
      text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", key.str(), in_one_line(item, enough));
    }
    return "{ " + text + " }";
  }
  std::ostringstream stream;
  // Strings are quoted, with their line breaks escaped.
  constexpr auto flags = toml::format_flags::none;
  node.visit([&](const auto& value) { stream << toml::toml_formatter(value, flags); });
  return std::move(stream).str();
}

/// An empty table `it` with this source.
toml::table empty_table(const std::string& source) { return toml::parse("it = {}", std::string_view(source)); }

std::string entries_of(const toml::array& list) {
  std::string names;
  for (const toml::node& node : list) {
    const toml::table* table = node.as_table();
    const auto name = table ? (*table)["name"].value<std::string>() : std::nullopt;
    if (name) names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", *name);
  }
  std::string numbers = list.empty()       ? "there are none"
                        : list.size() == 1 ? "0"
                                           : fmt::format("0 to {}", list.size() - 1);
  return names.empty() ? numbers : fmt::format("{}, or {}", numbers, names);
}

/// Whether the text is meant as a list, a table, a quoted string or a number, correct or not. Its errors are then
/// reported; any other text is taken as a string without its quotes.
bool is_meant_as_toml(std::string_view text) {
  if (text.empty() || std::string_view("[{\"'").find(text[0]) != std::string_view::npos) return true;
  if (std::ranges::any_of(text, [](unsigned char letter) { return letter < ' ' || letter == 127; })) return true;
  if (std::isalpha(static_cast<unsigned char>(text[0])) != 0) return false;
  const std::string whole(text);
  char* end = nullptr;
  std::strtod(whole.c_str(), &end);
  return *end == '\0' || !with_decimal_point(whole).empty();
}

std::string in_quotes(std::string_view text) {
  std::string out = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') out += '\\';
    out += letter;
  }
  return out + '"';
}

std::string_view without_spaces_around(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

/// The value of an override, as `value` in a table. A value that is not TOML, such as ../dem.tif, is taken as a string
/// without its quotes; whether a string is expected is checked when values are read. Throws toml::parse_error.
toml::table table_of(std::string_view value_text, const std::string& source) {
  const auto parse = [&](std::string_view value) {
    return toml::parse(fmt::format("value = {}", value), std::string_view(source));
  };
  try {
    return parse(value_text);
  } catch (const toml::parse_error&) {
    const std::string_view text = without_spaces_around(value_text);
    if (is_meant_as_toml(text)) throw;
    return parse(in_quotes(text));
  }
}

}  // namespace

std::string text_of_file(const std::filesystem::path& file, std::string_view kind) {
  const bool is_project = kind == "project";
  const std::string expected =
      fmt::format("expected a {} file, for example {}.toml", kind, is_project ? std::string_view("slope") : kind);
  if (file.empty())
    throw BadInput(about_file("\"\"", "the file name is empty", fmt::format("expected the name of a {} file", kind)));
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found) {
    throw BadInput(
        about_file(file, "there is no such file", {}, is_project ? "`talus new` writes a project to start from" : ""));
  }
  if (std::filesystem::is_directory(status)) {
    throw BadInput(about_file(file, "this is a directory", expected));
  }
  if (error) throw BadInput(about_file(file, "the file cannot be read", error.message()));
  if (!std::filesystem::is_regular_file(status)) {
    throw BadInput(about_file(file, "this is not a regular file", expected));
  }
  const std::uintmax_t bytes = std::filesystem::file_size(file, error);
  if (!error && bytes > most_bytes) {
    throw BadInput(about_file(file, fmt::format("the file has {} MiB", bytes >> 20u),
                              fmt::format("a {} file has at most {} MiB", kind, most_bytes >> 20u),
                              is_project ? "Keep a large terrain in a mesh file and name it by terrain.mesh" : ""));
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw BadInput(about_file(file, "the file cannot be read", std::strerror(errno)));
  std::ostringstream text;
  text << stream.rdbuf();
  if (stream.bad()) throw BadInput(about_file(file, "the file cannot be read to its end"));
  return std::move(text).str();
}

Document::Document(std::string_view text, std::string file) : file_(std::move(file)) {
  check_encoding(text, file_);
  if (const auto line = line_of_overlong_key(text)) {
    Problem problem =
        about_file(file_, fmt::format("a key has more than {} parts", most_parts_of_a_key),
                   "the longest keys of a project have three, such as [material.normal_restitution] mean");
    problem.line = *line;
    throw BadInput(std::move(problem));
  }
  try {
    root_ = toml::parse(text, std::string_view(file_));
  } catch (const toml::parse_error& error) {
    throw BadInput(Problem{.file = file_,
                           .line = static_cast<int>(error.source().begin.line),
                           .where = {},
                           .what = "this is not TOML",
                           .why = std::string(error.description()),
                           .hint = hint_at(line_of(text, error.source().begin.line))});
  }
}

void Document::set(const std::string& override_text, Problems& problems) {
  const std::string source = std::string(override_mark) + override_text;
  const auto refuse = [&](std::string what, std::string why, std::string hint = {}) {
    problems.add(about_file(source, std::move(what), std::move(why), std::move(hint)));
  };
  const std::size_t equals = override_text.find('=');
  const auto path = parts_of(std::string_view(override_text).substr(0, equals));
  if (equals == std::string::npos || !path) {
    refuse("this is not a setting", "expected table.key=value, for example analysis.gravity_m_s2=9.81");
    return;
  }
  if (path->size() > most_parts_of_a_key) {
    refuse(fmt::format("the key has {} parts", path->size()),
           "the longest keys of a project have four, such as material.Rock.normal_restitution.mean");
    return;
  }
  const std::string value_text = override_text.substr(equals + 1);
  toml::table parsed;
  // (Without an equals sign it has no key, but may be a path with many dots.)
  if (value_text.find('=') != std::string::npos && line_of_overlong_key(value_text)) {
    refuse("the value is not TOML", fmt::format("a key in it has more than {} parts", most_parts_of_a_key));
    return;
  }
  try {
    parsed = table_of(value_text, source);
  } catch (const toml::parse_error& error) {
    refuse("the value is not TOML", std::string(error.description()), comma_hint("=" + value_text));
    return;
  }
  if (parsed.size() != 1) {
    refuse("the value is not TOML", "expected a single value");
    return;
  }

  paths_.reset();
  toml::node* parent = &root_;
  for (std::size_t i = 0; i < path->size(); ++i) {
    const std::string& part = (*path)[i];
    const bool is_last = i + 1 == path->size();
    if (toml::array* list = parent->as_array()) {
      const std::optional<std::size_t> number = entry(*list, part);
      if (!number) {
        refuse(fmt::format("{} has no entry {}", (*path)[i - 1], part), fmt::format("expected {}", entries_of(*list)));
        return;
      }
      if (is_last)
        list->replace(list->cbegin() + static_cast<std::ptrdiff_t>(*number), std::move(*parsed.get("value")));
      parent = list->get(*number);
    } else if (toml::table* table = parent->as_table()) {
      if (is_last) {
        table->insert_or_assign(part, std::move(*parsed.get("value")));
      } else if (!table->contains(part)) {
        table->insert(part, std::move(*empty_table(source).get("it")));
      } else if (table->get(part)->is_number()) {
        // A plain number is short for a distribution, and is expanded to one so that its parts can be set.
        toml::table distribution = empty_table(source);
        distribution.get("it")->as_table()->insert("mean", std::move(*table->get(part)));
        table->insert_or_assign(part, std::move(*distribution.get("it")));
      }
      parent = table->get(part);
    } else {
      refuse(fmt::format("{} is {}", (*path)[i - 1], quoted(*parent)), "it has no parts to set");
      return;
    }
  }
}

Problem Document::at(const toml::node& node, Severity severity) const {
  const toml::source_region& source = node.source();
  Problem problem = nowhere();
  problem.severity = severity;
  if (source.path) problem.file = *source.path;
  // An override has no lines; its text is the location.
  const bool from_override = source.path && source.path->starts_with(override_mark);
  problem.line = from_override ? 0 : static_cast<int>(source.begin.line);
  if (!paths_) paths_.emplace(root_);
  problem.path = paths_->of(node);
  return problem;
}

Problem Document::at(const Spot& spot, Severity severity) const {
  Problem problem = spot.node ? at(*spot.node, severity) : nowhere();
  problem.severity = severity;
  if (spot.lacking) problem.path = SettingPaths::below(at(*spot.lacking).path, spot.key);
  return problem;
}

Problem Document::nowhere(std::string_view key) const {
  return {.file = file_, .where = {}, .what = {}, .why = {}, .hint = {}, .path = SettingPaths::below("", key)};
}

std::optional<double> number_in(const toml::node& node) {
  if (const auto* real = node.as_floating_point()) return real->get();
  if (const auto* whole = node.as_integer()) return static_cast<double>(whole->get());
  return std::nullopt;
}

std::string quoted(const toml::node& node) {
  constexpr std::size_t longest = 60;  // bytes
  std::string text = in_one_line(node, longest);
  if (text.size() > longest) {
    std::size_t cut = longest;
    while (cut > 0 && (static_cast<unsigned char>(text[cut]) & 0xC0u) == 0x80u) --cut;  // not inside a character
    text = text.substr(0, cut) + "...";
  }
  return text;
}

const toml::node* entry(const toml::node* list, std::size_t index) {
  const toml::array* array = list->as_array();
  return array && index < array->size() ? array->get(index) : list;
}

}  // namespace talus::project
