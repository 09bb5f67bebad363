#pragma once
// Barriers and collectors: a line on plan, draped over the ground, that stands up from it.
//
// A barrier's face is a row of flat panels, one between each two bends of its foot. A rock meets a panel when its
// centre comes within its radius of the panel's plane (the lumped mass: when it reaches the plane) and the point of
// contact lies on the panel. Height is measured from the foot along the face.
// Source: verification manual, section 4; physics of the break-through: a rock with more energy than the capacity goes
// on with the excess, its velocity and spin in proportion.

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "talus/barriers/plan_index.hpp"
#include "talus/core/id.hpp"
#include "talus/flight/parabola.hpp"
#include "talus/impact/restitution.hpp"
#include "talus/motion/motion.hpp"

namespace talus {

struct Panel {
  Vec3 foot;                            // one end of its foot
  Vec3 along;                           // unit, along the foot
  double length = 0;                    // of the foot [m]
  Vec3 up;                              // unit, up the face
  Vec3 normal;                          // unit, across the face
  double height = 0;                    // [m]
  double station = 0, plan_length = 0;  // where its foot begins along the line, and how long it is, on plan [m]
};

class Barrier {
 public:
  std::string name;
  bool is_collector = false;               // it records and does not touch
  double capacity = 0;                     // kinetic energy that it can take [J]; may be infinite
  std::optional<Restitution> restitution;  // of what rebounds; without it, what is stopped stays

  void stand(std::vector<Panel> panels);
  [[nodiscard]] const std::vector<Panel>& panels() const { return panels_; }
  /// Where on plan each panel can be met, or passed above by up to 10 km.
  [[nodiscard]] const PlanIndex& on_plan() const { return on_plan_; }

 private:
  std::vector<Panel> panels_;
  PlanIndex on_plan_;
};

/// Panels over the bends of a foot line. `inclination` leans the face from the vertical [rad], positive to the right of
/// the line's direction on plan: a right-handed turn about the line.
[[nodiscard]] std::vector<Panel> panels_over(std::span<const Vec3> foot, double height, double inclination);

/// How far on plan [m] a rock may go from `p` before any of it can be at or above a barrier; infinite without barriers.
[[nodiscard]] double free_way(std::span<const Barrier> barriers, const Vec3& p, double radius);

/// What becomes of a rock at a barrier.
enum class BarrierOutcome { stopped, rebounded, broke_through, passed };
inline constexpr int barrier_outcome_count = 4;
[[nodiscard]] const char* name(BarrierOutcome outcome);

/// A rock arrives at a barrier.
struct BarrierHit {
  BarrierId barrier;
  Motion motion;      // as it arrives
  double height = 0;  // of the contact point above the foot, along the face [m]
  double angle = 0;   // between the velocity and the face's normal, positive towards the foot [rad]
  BarrierOutcome outcome = BarrierOutcome::passed;
  double station = 0;  // where along the line, on plan [m]
};

/// A rock crosses the plane of a barrier on a part of its path.
struct Crossing {
  double t = 0;
  BarrierId barrier;
  double height = 0;     // of the contact point along the face; above the panel's height: it passes above
  double clearance = 0;  // above the panel's top, along the face [m]; only where it passes above
  Vec3 normal;           // across the face, against the rock
  Vec3 up;               // along the face
  bool above = false;
  double station = 0;  // where along the line, on plan [m]
};

/// Crossings this close in time [s] are one: what one part of a path ends with, the next one does not begin with.
inline constexpr double same_crossing = 1e-8;

/// Barriers that a rock has just met, so that it does not meet them again at once where one part of its path ends and
/// the next one begins. Times are the rock's.
class RecentCrossings {
 public:
  void note(BarrierId barrier, double time) { noted_[next_++ % noted_.size()] = {barrier, time}; }
  [[nodiscard]] bool contain(BarrierId barrier, double time) const {
    for (const auto& [noted_barrier, noted_time] : noted_) {
      if (noted_barrier == barrier && std::abs(time - noted_time) < same_crossing) return true;
    }
    return false;
  }
  /// Where times since `start` were noted on another clock, gives them the rock's: `time(t)` is how long it is from
  /// `start` until t on that clock.
  template <class Time>
  void retime(double start, Time&& time) {
    for (Noted& noted : noted_) {
      if (noted.time >= start) noted.time = start + time(noted.time - start);
    }
  }

 private:
  struct Noted {
    BarrierId barrier;
    double time = -1e300;
  };
  std::array<Noted, 8> noted_;
  std::size_t next_ = 0;
};

/// The first crossing up to t_max of a path that begins at the rock's time `start`, but for those that are recent; the
/// barriers' order decides ties.
[[nodiscard]] std::optional<Crossing> first_crossing(std::span<const Barrier> barriers, const Parabola& path,
                                                     double radius, double start, double t_max,
                                                     const RecentCrossings& recent);

/// What the barrier does to the rock, and how the rock leaves: as it came, if it passes; nothing, if it stays.
struct BarrierResponse {
  BarrierOutcome outcome = BarrierOutcome::passed;
  std::optional<Rebound> leaving;
};
[[nodiscard]] BarrierResponse respond(const Barrier& barrier, const Motion& motion, const Vec3& normal,
                                      const Rock& rock);

}  // namespace talus
