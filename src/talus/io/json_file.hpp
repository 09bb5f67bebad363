#pragma once
// JSON files of a run, as they may have become since: shortened, damaged, replaced by something else.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "talus/core/problems.hpp"

namespace talus::io {

/// Throws BadInput about a file that was to hold JSON of a run; `where`: in it.
[[noreturn]] void refuse_json_file(const std::filesystem::path& path, std::string where, std::string what,
                                   std::string why, std::string_view hint);

/// Far beyond any summary; files are read whole.
inline constexpr std::uintmax_t most_json_bytes = std::uintmax_t{256} << 20;

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

}  // namespace talus::io
