#pragma once
// A rock at a barrier or a collector: where it meets it or passes above it, and what comes of that.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "talus/barriers/crossing.hpp"
#include "talus/rocks/motion.hpp"

namespace talus {

struct Passage : Crossing {
  Motion motion;  // as it arrives; above: in the plane above the panel's top
  BarrierOutcome outcome = BarrierOutcome::passed;

  /// Between the velocity and the face's normal, positive towards the foot [rad].
  [[nodiscard]] double angle() const {
    const double speed = motion.velocity.norm();
    const double along_normal = speed > 0 ? std::clamp(-motion.velocity.dot(across) / speed, -1.0, 1.0) : 1;
    return std::copysign(std::acos(along_normal), -motion.velocity.dot(up));
  }
};

/// Removes the last passage above a barrier: a rock that meets a barrier while it is over it has not passed above after
/// all.
inline void take_back(std::vector<Passage>& passed_above, BarrierId barrier) {
  const auto last = std::ranges::find(passed_above.rbegin(), passed_above.rend(), barrier, &Passage::barrier);
  if (last != passed_above.rend()) passed_above.erase(std::next(last).base());
}

}  // namespace talus
