#pragma once
// Numbers that programs write where they have no value: -9999, 65535, 1e20 ... Files should declare them, and often do
// not.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "talus/core/vec.hpp"

namespace talus {

/// All of them but 0, in their order.
[[nodiscard]] std::span<const double> filler_values();

/// Whether a number is 0 or one of them.
[[nodiscard]] bool may_be_filler(double value);

/// The first vertex of a line whose height seems to be missing: it is far from those of all others, which are many, and
/// either 0 or a filler value, or a lonely spike of a level line. nullopt if there is none.
[[nodiscard]] std::optional<std::size_t> vertex_without_height(std::span<const Vec3> line);

/// Points at a height that may be a filler, and is far from the heights of all others.
struct DoubtfulHeight {
  double height = 0;
  std::size_t count = 0, first = 0;  // `first`: the number of the first such point
  double low = 0, high = 0;          // of the others
};
[[nodiscard]] std::vector<DoubtfulHeight> doubtful_heights(std::span<const Vec3> points);

/// Whether a height that may be a filler is far from those of the others.
[[nodiscard]] bool is_far_from(double height, double low, double high);

}  // namespace talus
