#pragma once
// How a rock comes to a barrier: it meets a panel when its centre comes within its radius of the panel's plane (the
// lumped mass: when it reaches the plane) and the point of contact lies on the panel; where two panels meet, a sphere
// may touch the side that they share before either of them.

#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "talus/barriers/barrier.hpp"
#include "talus/flight/parabola.hpp"

namespace talus {

/// A rock comes to a barrier on a part of its path.
struct Crossing {
  double t = 0;
  BarrierId barrier;
  double height = 0;     // of the contact point along the face; above the panel's height: it passes above
  double clearance = 0;  // above the panel's top, along the face [m]; only where it passes above
  Vec3 normal;           // across the face, against the rock
  Vec3 up;               // along the face
  bool above = false;
  double station = 0;      // where along the line, on plan [m]
  bool from_ahead = true;  // from the side to which the panels' normals point
};

/// Crossings this close in time [s] are one: what one part of a path ends with, the next one does not begin with.
inline constexpr double same_crossing = 1e-8;

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
    note({crossing.barrier, time, std::max(time, through_until), false, crossing.from_ahead, crossing.normal});
  }
  /// It was thrown back, and leaves at `velocity`: it can meet the barrier again from the same side, but not from
  /// beyond. So it can what it met in the same moment and has not passed after all, as a collector on the same line.
  void note_rebound(const Crossing& crossing, double time, const Vec3& velocity) {
    for (Noted& noted : noted_) {
      if (!noted.is_passed_at(time) || noted.normal.dot(velocity) <= 0) continue;
      noted.until = noted.time;
      noted.was_thrown_back = true;
    }
    note({crossing.barrier, time, time, true, crossing.from_ahead, crossing.normal});
  }
  [[nodiscard]] bool contain(BarrierId barrier, double time, bool from_ahead) const {
    for (const Noted& noted : noted_) {
      const bool is_same = time > noted.time - same_crossing && time < noted.until + same_crossing;
      if (noted.barrier == barrier && is_same && !(noted.was_thrown_back && noted.from_ahead == from_ahead)) {
        return true;
      }
    }
    return false;
  }
  /// What is over when a part of the path begins cannot be met again by it.
  void forget_before(double start) {
    std::erase_if(noted_, [start](const Noted& noted) { return noted.until + same_crossing < start; });
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
    bool was_thrown_back, from_ahead;
    Vec3 normal;  // across the face, against the rock as it came

    [[nodiscard]] bool is_passed_at(double at) const { return !was_thrown_back && std::abs(time - at) < same_crossing; }
  };
  void note(const Noted& noted) { noted_.push_back(noted); }

  std::vector<Noted> noted_;
};

/// The first crossing up to t_max of a path that begins at the rock's time `start`, but for those that are recent. A
/// collector comes before a barrier that the rock meets in the same moment: it records what arrives. Otherwise the
/// barriers' order decides ties.
[[nodiscard]] std::optional<Crossing> first_crossing(std::span<const Barrier> barriers, const Parabola& path,
                                                     double radius, double start, double t_max,
                                                     const RecentCrossings& recent);

}  // namespace talus
