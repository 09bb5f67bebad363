#pragma once
// Where a rock is at a time of its path.

#include <algorithm>
#include <iterator>
#include <span>

#include "talus/trajectory/rock_log.hpp"

namespace talus {

/// The motion at a time since release [s], limited to that of the path. `pieces`: at least one, in their order, without
/// glides (RockLog::for_each_piece gives their steps). Of a block, the spin is that of its sphere.
[[nodiscard]] inline Motion motion_at(std::span<const PathPiece> pieces, double time) {
  time = std::max(time, 0.0);
  const auto next = std::ranges::upper_bound(pieces, time, {}, &PathPiece::start_time);
  const PathPiece& piece = next == pieces.begin() ? *next : *std::prev(next);
  const double s = std::clamp(piece.drag.parameter(time - piece.start_time), 0.0, piece.duration);
  return {piece.path.at(s), piece.velocity(s), piece.spin_at(s), time};
}

}  // namespace talus
