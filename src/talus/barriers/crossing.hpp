#pragma once
// Where a rock meets a barrier. A sphere meets a barrier when it touches a panel: its face, its top or one of its
// sides; a lumped mass, when it reaches the face. A rock passes above a panel when its centre crosses the vertical
// plane above the panel's top (vertical even if the panel leans), and the rock does not touch the panel. A rock meets a
// collector when its centre reaches it, or when a barrier stops or returns a sphere that touches the collector. Rocks
// with a shape: body_crossing.hpp. Checked by test/barriers.

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "talus/barriers/barrier.hpp"
#include "talus/core/tolerances.hpp"
#include "talus/rocks/parabola.hpp"

namespace talus {

/// A rock meets a barrier, or passes above it, on a part of its path.
struct Crossing {
  double t = 0;
  BarrierId barrier;
  double height = 0;       // along the face [m]: of the contact; at a collector, or above, of the centre
  double lowest = 0;       // of the block's lowest point above the foot, along the face (rocks/heights.hpp) [m]
  double half_height = 0;  // of a rock with a shape there: half of the way from its lowest point to its top [m]
  double clearance = 0;    // above: of the rock's underside over the panel's top [m]
  double way_over = 0;     // above: the distance on plan to beyond a panel that leans against the rock [m]
  Vec3 normal;             // unit, from the contact to the rock's centre; above: level
  Vec3 across;             // unit, across the face, against the rock
  Vec3 up;                 // unit, up the face
  bool above = false;
  double station = 0;      // position along the line, on plan [m]
  bool from_ahead = true;  // from the side to which the panels' normals point

  /// Half of the height of the block [m]; `radius`: of the sphere of the same volume.
  [[nodiscard]] double half_height_of(double radius) const { return half_height > 0 ? half_height : radius; }
};

/// Barriers that a rock has just met, so that it does not meet them again where one part of its path ends and the next
/// begins. Times are since release.
class RecentCrossings {
 public:
  /// The rock has passed through the barrier, or above it. Until `through_until` it does not meet the same barrier
  /// again: at a bend a sphere touches two panels. The same applies to other barriers that it passed at that time.
  void record_passage(const Crossing& crossing, double time, double through_until) {
    for (Noted& noted : noted_) {
      if (noted.is_passed_at(time)) noted.until = std::max(noted.until, through_until);
    }
    note({crossing.barrier, time, std::max(time, through_until), false, crossing.from_ahead, crossing.above,
          crossing.normal});
  }
  /// The rock has rebounded with `velocity`: it can meet the barrier again from the same side, but not from the other.
  /// The same applies to what it met at that time and has not passed after all, such as a collector on the same line.
  void record_rebound(const Crossing& crossing, double time, const Vec3& velocity) {
    for (Noted& noted : noted_) {
      if (!noted.is_passed_at(time) || noted.normal.dot(velocity) <= 0) continue;
      noted.until = noted.time;
      noted.has_rebounded = true;
    }
    note({crossing.barrier, time, time, true, crossing.from_ahead, false, crossing.normal});
  }
  [[nodiscard]] bool contain(const Crossing& crossing, double time) const {
    return std::ranges::any_of(noted_, [&](const Noted& noted) {
      if (noted.barrier != crossing.barrier) return false;
      if (time <= noted.time - tolerance::same_crossing || time >= noted.until + tolerance::same_crossing) return false;
      // A rock that has passed above may still come down on the panel.
      if (noted.above && !crossing.above) return false;
      return !(noted.has_rebounded && noted.from_ahead == crossing.from_ahead);
    });
  }
  /// Whether the rock is over a barrier that it is passing above.
  [[nodiscard]] bool is_over(BarrierId barrier, double time) const {
    return std::ranges::any_of(noted_, [&](const Noted& noted) {
      return noted.above && noted.barrier == barrier && time >= noted.time && time <= noted.until;
    });
  }
  /// Drops entries that no longer matter to a part of the path that begins at `start`.
  void forget_before(double start) {
    std::erase_if(noted_, [start](const Noted& noted) { return noted.until + tolerance::same_crossing < start; });
  }
  /// Converts times since `start` that were recorded as parameters of a path: time(t) is the duration from `start` to
  /// parameter t.
  template <class Time>
  void retime(double start, Time&& time) {
    for (Noted& noted : noted_) {
      if (noted.time < start) continue;
      noted.time = start + time(noted.time - start);
      noted.until = start + time(noted.until - start);
    }
  }

 private:
  struct Noted {
    BarrierId barrier;
    double time, until;
    bool has_rebounded, from_ahead, above;
    Vec3 normal;  // against the arriving rock

    [[nodiscard]] bool is_passed_at(double at) const {
      return !has_rebounded && std::abs(time - at) < tolerance::same_crossing;
    }
  };
  void note(const Noted& noted) { noted_.push_back(noted); }

  std::vector<Noted> noted_;
};

/// The first crossing up to t_max on a path that begins at time `start`, without recent ones. If a rock meets a barrier
/// and a collector at the same time, the collector comes first, to record the arrival. Other ties are decided by the
/// barriers' order. `below`: how far below the foot the path may run by rounding, and still crosses [m].
[[nodiscard]] std::optional<Crossing> first_crossing(const BarrierList& barriers, const Parabola& path, double radius,
                                                     double start, double t_max, const RecentCrossings& recent,
                                                     double below = tolerance::barrier_range);

}  // namespace talus
