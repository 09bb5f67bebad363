#pragma once
// JSON files of a run, as they may have become since: shortened, damaged, replaced by something else.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "talus/core/problems.hpp"

namespace talus {

/// Throws BadInput about a file that was to hold JSON of a run; `where`: in it.
[[noreturn]] void refuse_json_file(const std::filesystem::path& path, std::string where, std::string what,
                                   std::string why, std::string_view hint);

/// Of a hundred thousand barriers that all were hit a summary has 0.4 GB; files are read whole.
inline constexpr std::uintmax_t most_json_bytes = std::uintmax_t{1} << 30;

/// The text of a file; expected to be an ordinary one of at most `most_bytes` with no lists deeper than deepest_json
/// (json_text.hpp), otherwise BadInput.
[[nodiscard]] std::string text_of_json_file(const std::filesystem::path& path, std::string_view hint,
                                            std::uintmax_t most_bytes);

/// The object that a file holds; throws BadInput where it is none, and as text_of_json_file() does.
template <class Json>
[[nodiscard]] Json read_json_object(const std::filesystem::path& path, std::string_view hint,
                                    std::uintmax_t most_bytes = most_json_bytes) {
  Json json = Json::parse(text_of_json_file(path, hint, most_bytes), nullptr, false);
  if (!json.is_object()) refuse_json_file(path, "", "is damaged", "it holds no JSON object", hint);
  return json;
}

/// What a text holds, but for the entries of a list of the outermost object, `"list": [...]`: as soon as each is read
/// it is given to take(entry), and the list stays empty. For lists that are long, of which little is needed. Where the
/// text is not JSON: discarded, or what Json::parse() throws.
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
