#pragma once
// JSON files of a run, which may have been truncated, damaged or replaced since.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "talus/core/problems.hpp"

namespace talus {

/// Throws BadInput about a JSON file of a run; `where`: in the file.
[[noreturn]] void refuse_json_file(const std::filesystem::path& path, std::string where, std::string what,
                                   std::string why, std::string_view hint);

/// A summary with a hundred thousand barriers, all of them hit, has 0.4 GB; files are read whole.
inline constexpr std::uintmax_t most_json_bytes = std::uintmax_t{1} << 30;

/// The text of a file. Throws BadInput unless it is an ordinary file of at most `most_bytes` without lists nested
/// deeper than deepest_json (json_text.hpp).
[[nodiscard]] std::string text_of_json_file(const std::filesystem::path& path, std::string_view hint,
                                            std::uintmax_t most_bytes);

/// The JSON object in a file. Throws BadInput if it contains none, and as text_of_json_file() does.
template <class Json>
[[nodiscard]] Json read_json_object(const std::filesystem::path& path, std::string_view hint,
                                    std::uintmax_t most_bytes = most_json_bytes) {
  Json json = Json::parse(text_of_json_file(path, hint, most_bytes), nullptr, false);
  if (!json.is_object()) refuse_json_file(path, "", "is damaged", "it is not a JSON object", hint);
  return json;
}

/// Parses a text, except for the entries of a list of the outermost object, `"list": [...]`: each is passed to
/// take(entry) as soon as it is read, and the list stays empty. For long lists of which little is needed. If the text
/// is not JSON, the result is discarded, or Json::parse() throws.
template <class Json, class Take>
[[nodiscard]] Json parse_without_list(std::string_view text, std::string_view list, Take&& take, bool throws = false) {
  bool in_list = false;
  const auto keeps = [&](int depth, typename Json::parse_event_t event, Json& parsed) {
    using Event = typename Json::parse_event_t;
    if (depth == 1 && event == Event::key) in_list = parsed == list;
    const bool is_entry =
        in_list && depth == 2 && (event == Event::value || event == Event::object_end || event == Event::array_end);
    if (is_entry) take(std::move(parsed));
    return !is_entry;
  };
  return Json::parse(text, keeps, throws);
}

}  // namespace talus
