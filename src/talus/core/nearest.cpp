#include "talus/core/nearest.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace talus {

static std::string folded(std::string_view word) {
  std::string out(word);
  for (char& letter : out) {
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    if (letter == '-' || letter == ' ') letter = '_';
  }
  return out;
}

std::size_t edit_distance(std::string_view one, std::string_view other) {
  const std::string a = folded(one), b = folded(other);
  // Three rows of the table of distances between the beginnings of both words: the one being filled and the two before.
  std::vector<std::size_t> before_last(b.size() + 1), last(b.size() + 1), now(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) now[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before_last.swap(last);
    last.swap(now);
    now[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      now[j] = std::min({last[j] + 1, now[j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        now[j] = std::min(now[j], before_last[j - 2] + 1);
    }
  }
  return now[b.size()];
}

std::optional<std::string_view> nearest(std::string_view word, std::span<const std::string_view> known) {
  constexpr std::size_t shortest_beginning = 3;  // letters
  std::optional<std::string_view> best;
  std::size_t best_distance = 0;
  for (const std::string_view candidate : known) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance <= std::max(word.size(), candidate.size()) / 3 && (!best || distance < best_distance)) {
      best = candidate;
      best_distance = distance;
    }
  }
  if (best || word.size() < shortest_beginning) return best;
  const std::string start = folded(word);
  for (const std::string_view candidate : known) {
    const std::string whole = folded(candidate);
    if (whole.starts_with(start) || (whole.size() >= shortest_beginning && start.starts_with(whole))) return candidate;
  }
  return std::nullopt;
}

}  // namespace talus
