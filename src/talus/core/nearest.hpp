#pragma once
// The known word that was probably meant by a mistyped one.

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

namespace talus {

/// The number of letters to insert, delete, replace or swap with their neighbour to turn one word into the other
/// (optimal string alignment distance; case is ignored, '-' and ' ' count as '_').
[[nodiscard]] std::size_t edit_distance(std::string_view one, std::string_view other);

/// The nearest of the known words, if it is near enough for a hint: at most a third of its letters differ, or one of
/// both words begins with the other (`gravity` for `gravity_m_s2`).
[[nodiscard]] std::optional<std::string_view> nearest(std::string_view word, std::span<const std::string_view> known);

}  // namespace talus
