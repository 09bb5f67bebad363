#pragma once
// How a rock comes to a barrier. A sphere meets a barrier when it touches a panel: its face, its top or one of its
// sides; a lumped mass, when it comes to the face. Above a panel's top stands a wall without end, upright even where
// the panel leans: a rock passes above when its centre goes through that, and nothing of it is in the panel's way. A
// collector touches nothing: a rock comes to it when its centre does. What of a sphere stands in a collector when a
// barrier stops it, or throws it back, has come to it, too.
// Checked by test/barriers.

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "talus/barriers/barrier.hpp"
#include "talus/core/tolerances.hpp"
#include "talus/flight/parabola.hpp"

namespace talus {

/// A rock comes to a barrier on a part of its path.
struct Crossing {
  double t = 0;
  BarrierId barrier;
  double height = 0;  // along the face, of the contact, or of where the centre comes to the collector or passes above
  double clearance = 0;  // of the underside above the panel's top [m]; only where it passes above
  double way_over =
      0;  // on plan, from there to beyond a panel that leans against the rock [m]; only where it passes above
  Vec3 normal = Vec3::Zero();  // from where the rock touches the panel to its centre, unit; level where it passes above
  Vec3 across = Vec3::Zero();  // across the face, against the rock; unit
  Vec3 up = Vec3::Zero();      // along the face, unit
  bool above = false;
  double station = 0;      // where along the line, on plan [m]
  bool from_ahead = true;  // from the side to which the panels' normals point
};

/// Barriers that a rock has just met, so that it does not meet them again at once where one part of its path ends and
/// the next one begins. Times are the rock's.
class RecentCrossings {
 public:
  /// It has gone through, or above. Until it is well beyond, it does not meet the same barrier again: at a bend a
  /// sphere touches two panels. What it met in the same moment it leaves as slowly.
  void note_passage(const Crossing& crossing, double time, double through_until) {
    for (Noted& noted : noted_) {
      if (noted.is_passed_at(time)) noted.until = std::max(noted.until, through_until);
    }
    note({crossing.barrier, time, std::max(time, through_until), false, crossing.from_ahead, crossing.above,
          crossing.normal});
  }
  /// It was thrown back, and leaves at `velocity`: it can meet the barrier again from the same side, but not from
  /// beyond. So it can what it met in the same moment and has not passed after all, as a collector on the same line.
  void note_rebound(const Crossing& crossing, double time, const Vec3& velocity) {
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
      // What has passed above may come down on the panel.
      if (noted.above && !crossing.above) return false;
      return !(noted.has_rebounded && noted.from_ahead == crossing.from_ahead);
    });
  }
  /// Whether it is over a barrier that it passes above.
  [[nodiscard]] bool is_over(BarrierId barrier, double time) const {
    return std::ranges::any_of(noted_, [&](const Noted& noted) {
      return noted.above && noted.barrier == barrier && time >= noted.time && time <= noted.until;
    });
  }
  /// What is over when a part of the path begins cannot be met again by it.
  void forget_before(double start) {
    std::erase_if(noted_, [start](const Noted& noted) { return noted.until + tolerance::same_crossing < start; });
  }
  /// Where times since `start` were noted on another clock, gives them the rock's: `time(t)` is how long it is from
  /// `start` until t on that clock.
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
    Vec3 normal;  // against the rock as it came

    [[nodiscard]] bool is_passed_at(double at) const {
      return !has_rebounded && std::abs(time - at) < tolerance::same_crossing;
    }
  };
  void note(const Noted& noted) { noted_.push_back(noted); }

  std::vector<Noted> noted_;
};

/// The first crossing up to t_max of a path that begins at the rock's time `start`, but for those that are recent. A
/// collector comes before a barrier that the rock meets in the same moment: it records what arrives. Otherwise the
/// barriers' order decides ties.
[[nodiscard]] std::optional<Crossing> first_crossing(const BarrierList& barriers, const Parabola& path, double radius,
                                                     double start, double t_max, const RecentCrossings& recent);

}  // namespace talus
