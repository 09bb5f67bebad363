#pragma once
// Barriers and collectors: a line on plan, draped over the ground, that stands up from it.
//
// A barrier's face is a row of flat panels, one between each two bends of its foot; how a rock comes to it is in
// crossing.hpp. Height is measured from the foot along the face.
// Source: verification manual, section 4; physics of the break-through: a rock with more energy than the capacity goes
// on with the excess, its velocity and spin in proportion.

#include <algorithm>
#include <cmath>
#include <concepts>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "talus/barriers/plan_index.hpp"
#include "talus/core/id.hpp"
#include "talus/impact/restitution.hpp"
#include "talus/rocks/motion.hpp"

namespace talus {

struct Panel {
  Vec3 foot;                            // one end of its foot
  Vec3 along;                           // unit, along the foot
  double length = 0;                    // of the foot [m]
  Vec3 up;                              // unit, up the face
  Vec3 normal;                          // unit, across the face
  double height = 0;                    // [m]
  double station = 0, plan_length = 0;  // where its foot begins along the line as given, and its share of it [m]
  // At a bend of the line, leaning panels meet where their planes do: by how much of the foot's direction their sides
  // go on with each metre up the face.
  double start_lean = 0, end_lean = 0;
  bool has_previous = false;  // another panel ends where it begins, and its side is the same

  /// Where its sides are at a height up the face [m], measured along the foot; as at the top from there on, as at the
  /// foot below it.
  [[nodiscard]] double start_at(double level) const { return start_lean * std::clamp(level, 0.0, height); }
  [[nodiscard]] double end_at(double level) const { return length + end_lean * std::clamp(level, 0.0, height); }
};

class Barrier {
 public:
  std::string name;
  bool is_collector = false;               // it records and does not touch
  double capacity = 0;                     // kinetic energy that it can take [J]; may be infinite
  std::optional<Restitution> restitution;  // of what rebounds; without it, what is stopped stays

  void stand(std::vector<Panel> panels);
  /// Its foot at another height, all along: across a section that stands elsewhere. On plan nothing changes.
  void move_foot_to(double z) {
    for (Panel& panel : panels_) panel.foot.z() = z;
  }
  [[nodiscard]] const std::vector<Panel>& panels() const { return panels_; }
  /// Where on plan each panel can be met or passed above.
  [[nodiscard]] const PlanIndex& on_plan() const { return on_plan_; }

 private:
  std::vector<Panel> panels_;
  PlanIndex on_plan_;
};

/// Panels over the bends of a foot line. `inclination` leans the face from the vertical [rad], positive to the right of
/// the line's direction on plan: a right-handed turn about the line.
[[nodiscard]] std::vector<Panel> panels_over(std::span<const Vec3> foot, double height, double inclination);

/// Which of many barriers are near, for BarrierList.
[[nodiscard]] PlanIndex index_of(std::span<const Barrier> barriers);

/// Barriers, and an index of them where there is one: without it all are asked, every time.
class BarrierList {
 public:
  BarrierList() = default;
  /// Both are the caller's and stay.
  BarrierList(std::span<const Barrier> barriers, const PlanIndex& on_plan) : barriers_(barriers), on_plan_(&on_plan) {}
  template <class Range>
  requires std::convertible_to<const Range&, std::span<const Barrier>> BarrierList(const Range& barriers)
      : barriers_(barriers) {}  // NOLINT(google-explicit-constructor)

  [[nodiscard]] bool empty() const { return barriers_.empty(); }
  [[nodiscard]] const Barrier& operator[](std::size_t k) const { return barriers_[k]; }
  /// Calls visit(k) for each barrier that may have a panel within `bounds`, in their order.
  template <class Visit>
  void visit(const PlanBounds& bounds, Visit&& visit) const {
    if (on_plan_ != nullptr) {
      on_plan_->visit(bounds, visit);
    } else {
      for (std::size_t k = 0; k < barriers_.size(); ++k) visit(k);
    }
  }
  /// On plan from a point to the nearest panel; infinite without barriers [m].
  [[nodiscard]] double distance(const Vec2& p) const;

 private:
  std::span<const Barrier> barriers_;
  const PlanIndex* on_plan_ = nullptr;
};

/// How far on plan [m] a rock may go from `p` before any of it can be at or above a barrier; infinite without barriers.
[[nodiscard]] double free_way(const BarrierList& barriers, const Vec3& p, double radius);

/// What becomes of a rock at a barrier.
enum class BarrierOutcome { stopped, rebounded, broke_through, passed };
inline constexpr int barrier_outcome_count = 4;
[[nodiscard]] const char* name(BarrierOutcome outcome);

/// A rock arrives at a barrier.
struct BarrierHit {
  BarrierId barrier;
  Motion motion;      // as it arrives
  double height = 0;  // above the foot, along the face: of the contact point; at a collector, of the centre [m]
  double angle = 0;   // between the velocity and the face's normal, positive towards the foot [rad]
  BarrierOutcome outcome = BarrierOutcome::passed;
  double station = 0;  // where along the line, on plan [m]
};

/// What the barrier does to the rock, and how the rock leaves: as it came, if it passes; nothing, if it stays.
struct BarrierResponse {
  BarrierOutcome outcome = BarrierOutcome::passed;
  std::optional<Rebound> leaving;
};
[[nodiscard]] BarrierResponse respond(const Barrier& barrier, const Motion& motion, const Vec3& normal,
                                      const Rock& rock);

}  // namespace talus
