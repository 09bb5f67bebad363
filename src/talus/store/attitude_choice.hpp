#pragma once
// Which attitudes of a path a store keeps. On the ground a run takes short steps, of which most only continue the turn
// before them.

#include <cstddef>
#include <span>
#include <vector>

#include "talus/rocks/attitude.hpp"

namespace talus {

/// The attitudes, by their places, from which a free turn leads to each of those left out within `max_angle` [rad]. The
/// first and the last are among them. An attitude at the time of the one before replaces it.
inline void divide_into_turns(std::span<const Attitude> attitudes, const Vec3& inertia, double max_angle,
                              std::vector<std::size_t>& kept) {
  kept.clear();
  if (attitudes.empty()) return;
  std::size_t from = 0;
  FreeRotation turn(inertia, attitudes[0].orientation, attitudes[0].spin);
  const auto keep = [&](std::size_t k) {
    if (!kept.empty() && attitudes[kept.back()].time == attitudes[k].time) {
      kept.back() = k;
    } else {
      kept.push_back(k);
    }
    from = k;
    turn = FreeRotation(inertia, attitudes[k].orientation, attitudes[k].spin);
  };
  const auto is_told = [&](std::size_t k) {
    const Attitude& attitude = attitudes[k];
    return angle_between(turn.at(attitude.time - attitudes[from].time).orientation, attitude.orientation) <= max_angle;
  };
  keep(0);
  for (std::size_t k = 1; k < attitudes.size(); ++k) {
    if (is_told(k)) continue;
    if (k - 1 > from) keep(k - 1);
    if (!is_told(k)) keep(k);
  }
  if (from + 1 < attitudes.size()) keep(attitudes.size() - 1);
}

}  // namespace talus
