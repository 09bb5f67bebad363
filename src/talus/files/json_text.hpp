#pragma once
// JSON from outside: nlohmann's reader itself takes any depth, but what copies, compares and writes its values calls
// itself for every level, so that lists within lists could take all of the stack.

#include <cstddef>
#include <string_view>

namespace talus {

/// How deep lists and objects may lie within one another in the files of a run; a project's echo has some ten levels.
inline constexpr std::size_t deepest_json = 100;

/// How deep they do in a text, whether or not it is JSON.
[[nodiscard]] std::size_t depth_of_json(std::string_view text);

}  // namespace talus
