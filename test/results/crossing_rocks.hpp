#pragma once
// Rocks that cross lines as a test says, and the design that follows from them.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "talus/results/design_result.hpp"

namespace talus::test {

/// In the direction of x, with a rotational energy of a tenth of the translational one. `height`: of the block's top.
struct Crosses {
  std::uint32_t barrier;
  double time, velocity, height, station;
  bool above = false;  // above the panel
};

struct Seen {
  RockRecord record;
  RockLog log{false};
};

/// A rock of 200 kg and a radius of 0.3 m.
inline Seen crossing_rock(const std::vector<Crosses>& crossings) {
  Seen seen;
  seen.record.body = {200, 0.3, 8};
  for (const Crosses& crossing : crossings) {
    Motion motion;
    motion.time = crossing.time;
    const double lowest = std::max(crossing.height - 2 * seen.record.body.radius, 0.0);
    motion.velocity = crossing.velocity * Vec3(0.6, 0, -0.8);
    motion.spin = Vec3(0, crossing.velocity * std::sqrt(0.1 * 200 / 8), 0);
    Crossing where;
    where.barrier = BarrierId{crossing.barrier};
    where.height = where.lowest = lowest;
    where.clearance = 1;
    where.station = crossing.station;
    (crossing.above ? seen.log.passed_above : seen.log.hits).push_back({where, motion});
  }
  return seen;
}

inline void show(SummingObserver& observer, const std::vector<Seen>& rocks) {
  const auto part = observer.new_part();
  for (const Seen& seen : rocks) part->see(seen.record, seen.log);
  observer.commit(*part);
}

inline DesignResult result_of(const DesignPlan& plan, const std::vector<Seen>& rocks) {
  DesignObserver observer(plan, rocks.size());
  show(observer, rocks);
  return evaluate(observer.plan(), observer.tally());
}

}  // namespace talus::test
