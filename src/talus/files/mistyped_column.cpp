#include "talus/files/mistyped_column.hpp"

#include <algorithm>
#include <string>

#include "talus/core/nearest.hpp"

namespace talus {

namespace {

/// What a slip of the fingers leaves as it is: how many words there are, and the digits.
std::string frame_of(std::string_view name) {
  std::string frame;
  std::ranges::copy_if(name, std::back_inserter(frame), [](char c) { return c == '_' || (c >= '0' && c <= '9'); });
  return frame;
}

}  // namespace

std::optional<std::string_view> mistyped_column(std::string_view name, std::span<const std::string_view> known) {
  constexpr std::size_t most_wrong = 2, right_at_least = 5;  // letters
  std::optional<std::string_view> best;
  std::size_t least = most_wrong + 1;
  for (const std::string_view each : known) {
    const std::size_t wrong = edit_distance(name, each);
    if (wrong == 0 || wrong >= least || std::min(name.size(), each.size()) < right_at_least + wrong) continue;
    if (frame_of(name) != frame_of(each)) continue;
    best = each;
    least = wrong;
  }
  return best;
}

}  // namespace talus
