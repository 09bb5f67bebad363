#pragma once
// The known word that a mistyped one was probably meant to be.

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace talus {

/// How many letters must be put in, taken out, replaced or swapped with their neighbour to turn one word into the other
/// (optimal string alignment distance; capitals count as small letters, '-' and ' ' as '_').
[[nodiscard]] std::size_t edit_distance(std::string_view one, std::string_view other);

/// The nearest of the known words, if one is near enough to be worth a question: at most a third of its letters differ,
/// or one begins with the other (`gravity` for `gravity_m_s2`).
[[nodiscard]] std::optional<std::string_view> nearest(std::string_view word, std::span<const std::string_view> known);

}  // namespace talus
