#pragma once
// Where a rock with a shape meets a barrier: when its hull touches a panel, which ends at its top and its sides and
// goes on below its foot. It passes above a panel, and meets a collector, when its centre does (crossing.hpp), with
// heights of its own lowest and highest points at that moment.
//
// Before a sphere about the whole rock comes near a panel, nothing can touch. From there the time of the first touch is
// approached from below: a step is so short that neither the way of the centre nor a turn can bring a corner across the
// gap. Source: B. Mirtich, "Impulse-based dynamic simulation of rigid body systems", PhD thesis, Berkeley 1996
// (conservative advancement). A rock that touches a panel while its centre draws away meets it when its centre does.
//
// Checked by test/trajectory/bodies_at_barriers_test.cpp.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "talus/barriers/crossing.hpp"
#include "talus/barriers/on_panel.hpp"
#include "talus/rocks/separation.hpp"

namespace talus {

/// Whether a part of a path is near a panel on plan. `margin`: the rock's reach [m].
[[nodiscard]] bool may_meet(const BarrierList& barriers, const Parabola& path, double t_max, double margin);

namespace body_crossing {

/// When a path is within `distance` of a panel's plane.
struct TimesNear {
  double first, last;
};
[[nodiscard]] std::optional<TimesNear> times_near(const Panel& panel, const Parabola& path, double distance,
                                                  double t_max);

/// The corners of a panel near a body.
[[nodiscard]] std::array<Vec3, 4> outline_near(const Panel& panel, const Vec3& centre, double reach);

/// Where a body reaches through a panel: as if it touched it from the side of its centre.
[[nodiscard]] Separation across(const Panel& panel, const Posture& body);

/// Of a body, up a panel's face from the foot [m].
struct Extent {
  double lowest, highest;
};
[[nodiscard]] Extent extent_on(const Panel& panel, const Posture& body);

/// Whether a body touches the plane of a panel, or is above it, and approaches it.
[[nodiscard]] bool is_at(const Panel& panel, const Posture& body, const Parabola& path, double t);

/// The panel that a crossing is on.
[[nodiscard]] const Panel& panel_of(const Barrier& barrier, const Crossing& crossing);

/// `contact`: on the panel; `normal`: from there to the body.
[[nodiscard]] Crossing meeting(BarrierId barrier, const Panel& panel, const Posture& body, double t,
                               const Vec3& contact, const Vec3& normal);

/// Where a body first touches a panel until `t_max`, while its centre approaches the contact.
template <class Way>
[[nodiscard]] std::optional<Crossing> touch(BarrierId barrier, const Panel& panel, const Way& way, double t_max) {
  constexpr int max_steps = 1000, steps_in_full = 16;
  constexpr double min_way = 1e-3;  // in a step after those [m]: what reaches less far into a panel may be missed
  constexpr double near = tolerance::barrier_range;
  const Parabola& path = way.path;
  const double reach = way.body.reach, turning = way.max_turning() * reach;
  const auto times = times_near(panel, path, reach + near, t_max);
  if (!times) return std::nullopt;
  std::optional<Separation> last;
  double t = times->first;
  for (int step = 0; step < max_steps; ++step) {
    const Posture body = way.at(t);
    auto apart = separation(body, outline_near(panel, body.centre, reach));
    const Vec3 velocity = path.velocity(t);
    if (!apart || apart->distance <= near) {
      if (!apart) apart = last ? *last : across(panel, body);
      if (on_panel::draws_away(apart->direction.dot(velocity), apart->direction.dot(path.a))) break;
      return meeting(barrier, panel, body, t, apart->nearest, apart->direction);
    }
    // The gap closes by less than c t + a t^2 / 2.
    const double gap = apart->distance - 0.5 * near;
    const double c = turning - apart->direction.dot(velocity), a = -apart->direction.dot(path.a);
    const double root = c * c + 2 * a * gap, divisor = root >= 0 ? c + std::sqrt(root) : 0;
    if (!(divisor > 0)) break;
    double dt = 2 * gap / divisor;
    if (step >= steps_in_full) dt = std::max(dt, min_way / (velocity.norm() + turning));
    t += dt;
    if (t > times->last) break;
    last = apart;
  }
  return std::nullopt;
}

}  // namespace body_crossing

/// The first crossing of a body, as first_crossing() in crossing.hpp. `Way`: how it moves, with its `body`, the `path`
/// of its centre, at(t), its posture, and max_turning() [rad/s].
template <class Way>
[[nodiscard]] std::optional<Crossing> first_body_crossing(const BarrierList& barriers, const Way& way, double start,
                                                          double t_max, const RecentCrossings& recent) {
  using namespace body_crossing;
  const double margin = way.body.reach + tolerance::barrier_range;
  const PlanBounds passed = on_panel::bounds_of(way.path, t_max, margin);
  // Calls visit(id, panel) for each panel that may be met.
  const auto visit_panels = [&](bool collectors, auto&& visit) {
    barriers.visit(passed, [&](std::size_t number) {
      if (barriers[number].is_collector != collectors) return;
      barriers[number].on_plan().visit(passed, [&](std::size_t k) {
        visit(BarrierId{static_cast<std::uint32_t>(number)}, barriers[number].panels()[k]);
      });
    });
  };

  auto first = first_crossing(barriers, way.path, 0, start, t_max, recent, margin);  // of the centre
  if (first) {
    const Barrier& barrier = barriers[first->barrier.index];
    const Panel& panel = panel_of(barrier, *first);
    const Posture body = way.at(first->t);
    const Extent extent = extent_on(panel, body);
    first->lowest = std::max(extent.lowest, 0.0);
    first->half_height = 0.5 * (extent.highest - extent.lowest);
    if (first->above) {
      const auto apart = separation(body, outline_near(panel, body.centre, way.body.reach));
      first->clearance = apart ? apart->distance : 0;
      first->above = apart && !(barrier.is_collector && touch(first->barrier, panel, way, t_max));
    }
  }
  std::optional<Crossing> met;
  visit_panels(false, [&](BarrierId barrier, const Panel& panel) {
    const auto touched = touch(barrier, panel, way, met ? met->t : first ? first->t : t_max);
    if (!touched || (met && touched->t >= met->t) || recent.contain(*touched, start + touched->t)) return;
    met = touched;
  });
  if (!met) return first;
  // A rock that a barrier keeps from a collector counts where it is, if it touches the collector there.
  std::optional<Crossing> reached;
  const Posture body = way.at(met->t);
  visit_panels(true, [&](BarrierId collector, const Panel& panel) {
    if (reached || !is_at(panel, body, way.path, met->t)) return;
    Crossing crossing = meeting(collector, panel, body, met->t, body.centre, met->normal);
    crossing.normal = crossing.across;
    crossing.above = crossing.lowest > panel.height;
    if (crossing.above) crossing.clearance = crossing.lowest - panel.height;
    if (!recent.contain(crossing, start + met->t)) reached = crossing;
  });
  return reached ? reached : met;
}

}  // namespace talus
