#pragma once
// Limits the nesting of JSON from outside. nlohmann's parser accepts any depth, but copying, comparing and writing its
// values recurse for every level, so that deeply nested lists could exhaust the stack.

#include <cstddef>
#include <string_view>

namespace talus {

/// The maximum nesting of lists and objects in the files of a run; the echo of a project has about ten levels.
inline constexpr std::size_t deepest_json = 100;

/// The nesting in a text, whether or not it is JSON.
[[nodiscard]] std::size_t depth_of_json(std::string_view text);

}  // namespace talus
