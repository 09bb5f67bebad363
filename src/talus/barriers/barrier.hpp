#pragma once
// Barriers and collectors: faces that stand on a line on plan, draped over the ground.
//
// A face is a row of flat panels, one between any two neighbouring bends of its foot; crossing.hpp finds where a rock
// meets it. Height is measured from the foot along the face. Source: verification manual, section 4. Break-through: a
// rock with more energy than the capacity keeps the excess; velocity and spin are reduced by the same factor.

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
  double station = 0, plan_length = 0;  // start and length of its foot along the given line, on plan [m]
  // At a bend, leaning panels meet in the line in which their planes meet: the shift of their sides along the foot per
  // metre up the face.
  double start_lean = 0, end_lean = 0;
  bool has_previous = false;  // another panel ends where it begins, and they share a side
  // A panel in a section has no sides: it is as wide as the section is deep, and its foot's length means nothing.
  bool has_sides = true;

  /// The positions of its sides along the foot, at a height up the face [m]; constant above the top and below the foot.
  [[nodiscard]] double start_at(double level) const { return start_lean * std::clamp(level, 0.0, height); }
  [[nodiscard]] double end_at(double level) const { return length + end_lean * std::clamp(level, 0.0, height); }
};

class Barrier {
 public:
  std::string name;
  bool is_collector = false;               // records rocks without affecting them
  double capacity = 0;                     // kinetic energy that it can absorb [J]; may be infinite
  std::optional<Restitution> restitution;  // for rebounds; nullopt: rocks stop at the barrier

  void set_panels(std::vector<Panel> panels);
  /// Moves the whole foot to another elevation, when a section varies. Nothing changes on plan.
  void move_foot_to(double z) {
    for (Panel& panel : panels_) panel.foot.z() = z;
  }
  [[nodiscard]] const std::vector<Panel>& panels() const { return panels_; }
  /// The bounds on plan of each panel, where it can be met or passed above.
  [[nodiscard]] const PlanIndex& on_plan() const { return on_plan_; }

 private:
  std::vector<Panel> panels_;
  PlanIndex on_plan_;
};

/// The panels on a foot line. `inclination` of the face from the vertical [rad], positive to the right of the line's
/// direction on plan: a right-handed turn about the line.
[[nodiscard]] std::vector<Panel> panels_over(std::span<const Vec3> foot, double height, double inclination);

/// The panel of a barrier in a section, which faces along x and has no sides. `foot`: in the section's plane.
[[nodiscard]] Panel panel_in_section(const Vec3& foot, double height, double inclination);

/// The bounds of many barriers on plan, for BarrierList.
[[nodiscard]] PlanIndex index_of(std::span<const Barrier> barriers);

/// Barriers, and optionally an index of them. Without the index every search visits all barriers.
class BarrierList {
 public:
  BarrierList() = default;
  /// Both must outlive the list.
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
  /// The distance on plan from a point to the nearest panel [m]; infinite without barriers.
  [[nodiscard]] double distance(const Vec2& p) const;

 private:
  std::span<const Barrier> barriers_;
  const PlanIndex* on_plan_ = nullptr;
};

/// The distance on plan [m] that a rock can move from `p` before any part of it can be at or above a barrier; infinite
/// without barriers.
[[nodiscard]] double free_way(const BarrierList& barriers, const Vec3& p, double radius);

/// What a barrier does to a rock.
enum class BarrierOutcome { stopped, rebounded, broke_through, passed };
inline constexpr int barrier_outcome_count = 4;
[[nodiscard]] const char* name(BarrierOutcome outcome);

/// What the barrier does to the rock, and how the rock leaves: unchanged if it passes, nullopt if it stops.
struct BarrierResponse {
  BarrierOutcome outcome = BarrierOutcome::passed;
  std::optional<Rebound> leaving;
};
[[nodiscard]] BarrierResponse respond(const Barrier& barrier, const Motion& motion, const Vec3& normal,
                                      const Rock& rock);

}  // namespace talus
