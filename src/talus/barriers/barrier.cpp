#include "talus/barriers/barrier.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "talus/impact/plain.hpp"
#include "talus/rocks/energy.hpp"

namespace talus {

const char* name(BarrierOutcome outcome) {
  switch (outcome) {
    case BarrierOutcome::stopped:
      return "stopped";
    case BarrierOutcome::rebounded:
      return "rebounded";
    case BarrierOutcome::broke_through:
      return "broke through";
    case BarrierOutcome::passed:
      return "passed";
  }
  return "";
}

namespace {

/// The shift along a panel's foot per metre up its face, for a direction in its plane; nullopt if the direction hardly
/// rises.
std::optional<double> lean_of(const Panel& panel, const Vec3& direction) {
  const double c = panel.along.dot(panel.up), x = direction.dot(panel.along), y = direction.dot(panel.up);
  constexpr double steep = 0.1;
  const double up = (y - c * x) / (1 - c * c);
  return up > steep * direction.norm() ? std::optional((x - c * y) / (1 - c * c) / up) : std::nullopt;
}

/// Joins the sides of two panels of which one ends where the other begins, along the line in which their planes meet.
void join(Panel& before, Panel& after) {
  Vec3 line = before.normal.cross(after.normal);
  constexpr double flat = 1e-9;  // sine of the angle below which two planes are one
  after.has_previous = true;
  if (line.norm() < flat) return;
  if (line.dot(before.up) < 0) line = -line;
  const auto lean_before = lean_of(before, line), lean_after = lean_of(after, line);
  after.has_previous = lean_before && lean_after;
  if (!after.has_previous) return;  // a hairpin bend: the shared side would be nearly horizontal
  before.end_lean = *lean_before;
  after.start_lean = *lean_after;
}

}  // namespace

std::vector<Panel> panels_over(std::span<const Vec3> foot, double height, double inclination) {
  std::vector<Panel> panels;
  constexpr double step = 1e-9;  // on plan [m]: the foot climbs a vertical face, where there is no panel
  Vec3 foot_of_last;             // the end of the last panel's foot
  double station = 0;
  for (std::size_t k = 0; k + 1 < foot.size(); ++k) {
    const Vec3 d = foot[k + 1] - foot[k];
    if (d.xy().norm() < step) continue;
    const Vec3 plan = Vec3(d.x(), d.y(), 0).normalized();
    const Vec3 right(plan.y(), -plan.x(), 0);
    Panel panel;
    panel.foot = foot[k];
    panel.length = d.norm();
    panel.along = d / panel.length;
    panel.up = std::cos(inclination) * unit_z + std::sin(inclination) * right;
    panel.normal = panel.along.cross(panel.up).normalized();
    panel.height = height;
    panel.station = station;
    panel.plan_length = std::hypot(d.x(), d.y());
    station += panel.plan_length;
    if (!panels.empty() && (foot_of_last - foot[k]).norm() < step) join(panels.back(), panel);
    foot_of_last = foot[k + 1];
    panels.push_back(panel);
  }
  return panels;
}

Panel panel_in_section(const Vec3& foot, double height, double inclination) {
  const Vec3 aside = unit_y;  // the panel of panels_over() to both sides of the plane
  Panel panel = panels_over(std::array<Vec3, 2>{foot - aside, foot + aside}, height, inclination).front();
  panel.has_sides = false;
  return panel;
}

void Barrier::set_panels(std::vector<Panel> panels) {
  panels_ = std::move(panels);
  std::vector<PlanBounds> bounds(panels_.size());
  for (std::size_t k = 0; k < panels_.size(); ++k) {
    const Panel& panel = panels_[k];
    for (const double up : {0.0, panel.height}) {
      for (const double along : {panel.start_at(up), panel.end_at(up)}) {
        bounds[k].grow((panel.foot + along * panel.along + up * panel.up).xy());
      }
    }
  }
  on_plan_ = PlanIndex(bounds);
}

PlanIndex index_of(std::span<const Barrier> barriers) {
  std::vector<PlanBounds> bounds;
  for (const Barrier& barrier : barriers) bounds.push_back(barrier.on_plan().bounds());
  return PlanIndex(bounds);
}

double BarrierList::distance(const Vec2& p) const {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  if (on_plan_ != nullptr) {
    return on_plan_->distance_to(
        p, infinite, [&](std::size_t k, double, double known) { return barriers_[k].on_plan().distance(p, known); });
  }
  double nearest = infinite;
  for (const Barrier& barrier : barriers_) nearest = barrier.on_plan().distance(p, nearest);
  return nearest;
}

double free_way(const BarrierList& barriers, const Vec3& p, double radius) {
  constexpr double by_rounding = 1e-6;  // [m]
  return std::max(0.0, barriers.distance(p.xy()) - radius - by_rounding);
}

BarrierResponse respond(const Barrier& barrier, const Motion& motion, const Vec3& normal, const Rock& rock) {
  const Rebound as_it_came{motion.velocity, motion.spin};
  if (barrier.is_collector) return {BarrierOutcome::passed, as_it_came};
  const double energy = kinetic_energy(rock, motion);
  if (energy > barrier.capacity) {
    const double kept = std::sqrt(1 - barrier.capacity / energy);
    return {BarrierOutcome::broke_through, Rebound{kept * motion.velocity, kept * motion.spin}};
  }
  if (!barrier.restitution) return {BarrierOutcome::stopped, std::nullopt};
  return {BarrierOutcome::rebounded, plain_rebound(motion.velocity, motion.spin, normal, *barrier.restitution)};
}

}  // namespace talus
