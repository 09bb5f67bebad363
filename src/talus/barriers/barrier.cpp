#include "talus/barriers/barrier.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "talus/impact/plain.hpp"

namespace talus {

namespace {
constexpr double by_rounding = 1e-6;  // by which ranges are widened [m]
}

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

std::vector<Panel> panels_over(std::span<const Vec3> foot, double height, double inclination) {
  std::vector<Panel> panels;
  double station = 0;
  for (std::size_t k = 0; k + 1 < foot.size(); ++k) {
    const Vec3 d = foot[k + 1] - foot[k];
    const Vec3 plan = Vec3(d.x(), d.y(), 0).normalized();
    const Vec3 right(plan.y(), -plan.x(), 0);
    Panel panel;
    panel.foot = foot[k];
    panel.length = d.norm();
    panel.along = d / panel.length;
    panel.up = std::cos(inclination) * Vec3::UnitZ() + std::sin(inclination) * right;
    panel.normal = panel.along.cross(panel.up).normalized();
    panel.height = height;
    panel.station = station;
    panel.plan_length = std::hypot(d.x(), d.y());
    station += panel.plan_length;
    panels.push_back(panel);
  }
  return panels;
}

void Barrier::stand(std::vector<Panel> panels) {
  constexpr double above = 1e4;  // [m]
  panels_ = std::move(panels);
  std::vector<PlanBounds> bounds(panels_.size());
  for (std::size_t k = 0; k < panels_.size(); ++k) {
    const Panel& panel = panels_[k];
    for (const double along : {0.0, panel.length}) {
      for (const double up : {0.0, panel.height + above}) {
        bounds[k].grow(Vec2((panel.foot + along * panel.along + up * panel.up).head<2>()));
      }
    }
  }
  on_plan_ = PlanIndex(bounds);
}

double free_way(std::span<const Barrier> barriers, const Vec3& p, double radius) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Barrier& barrier : barriers) nearest = barrier.on_plan().distance(p.head<2>(), nearest);
  return std::max(0.0, nearest - radius - by_rounding);
}

namespace {

// A range that holds p + v t + a t^2 / 2 for all t in [0, t_max], widened by `margin`.
struct Range {
  Range(double p, double v, double a, double t_max, double margin)
      : low(p + std::min(v * t_max, 0.0) + std::min(0.5 * a * t_max * t_max, 0.0) - margin),
        high(p + std::max(v * t_max, 0.0) + std::max(0.5 * a * t_max * t_max, 0.0) + margin) {}
  double low, high;
};

// Both times at which the quadratic h0 + v t + a t^2/2 is zero, rising; fewer where there are fewer.
struct Times {
  std::array<double, 2> t{};
  int count = 0;
};

Times zeros(double h0, double v, double a) {
  if (a == 0) {
    return v != 0 ? Times{{-h0 / v, 0}, 1} : Times{};
  }
  const double discriminant = v * v - 2 * a * h0;
  if (discriminant < 0) return {};
  const double q = -(v + std::copysign(std::sqrt(discriminant), v));
  const double t1 = q / a, t2 = q != 0 ? 2 * h0 / q : 0;
  return {{std::min(t1, t2), std::max(t1, t2)}, 2};
}

// Where a point of the panel's plane lies on the panel: along its foot and up its face (which need not be at right
// angles where the foot climbs).
struct Place {
  double along, up;
};

Place place_on(const Panel& panel, const Vec3& q) {
  const Vec3 d = q - panel.foot;
  const double c = panel.along.dot(panel.up), x = d.dot(panel.along), y = d.dot(panel.up);
  return {(x - c * y) / (1 - c * c), (y - c * x) / (1 - c * c)};
}

}  // namespace

std::optional<Crossing> first_crossing(std::span<const Barrier> barriers, const Parabola& path, double radius,
                                       double start, double t_max, const RecentCrossings& recent) {
  std::optional<Crossing> first;
  const double margin = radius + by_rounding;
  const Range x(path.p.x(), path.v.x(), path.a.x(), t_max, margin),
      y(path.p.y(), path.v.y(), path.a.y(), t_max, margin);
  const PlanBounds passed{{x.low, y.low}, {x.high, y.high}};
  for (std::uint32_t b = 0; b < barriers.size(); ++b) {
    barriers[b].on_plan().visit(passed, [&](std::size_t k) {
      const Panel& panel = barriers[b].panels()[k];
      const double h0 = panel.normal.dot(path.p - panel.foot);
      const double v = panel.normal.dot(path.v), a = panel.normal.dot(path.a);
      const Range distance(h0, v, a, t_max, margin);
      if (distance.low > 0 || distance.high < 0) return;
      // From either side, the side being where the rock comes from at that time.
      for (const double side : {1.0, -1.0}) {
        const Times times = zeros(h0 - side * radius, v, a);
        for (int i = 0; i < times.count; ++i) {
          // A rock that starts at the barrier, or a rounding beyond it, meets it.
          const double t = times.t[static_cast<std::size_t>(i)];
          if (t < -0.5 * same_crossing || t > t_max || (first && t >= first->t)) continue;
          if (side * (v + a * t) >= 0) continue;  // drawing away
          const Vec3 contact = path.at(t) - side * radius * panel.normal;
          const Place place = place_on(panel, contact);
          // Panels of one barrier meet without a gap; a rounding's breadth beyond an end belongs to it, too.
          if (place.along < -1e-9 || place.along > panel.length + 1e-9 || place.up < -radius - 1e-6) continue;
          const bool above = place.up > panel.height;
          if (recent.contain(BarrierId{b}, start + t)) continue;
          first = Crossing{std::max(t, 0.0),
                           BarrierId{b},
                           std::max(place.up, 0.0),
                           above ? place.up - panel.height - radius : 0,
                           side * panel.normal,
                           panel.up,
                           above,
                           panel.station + place.along / panel.length * panel.plan_length};
        }
      }
    });
  }
  return first;
}

BarrierResponse respond(const Barrier& barrier, const Motion& motion, const Vec3& normal, const Rock& rock) {
  const Rebound as_it_came{motion.velocity, motion.spin};
  if (barrier.is_collector) return {BarrierOutcome::passed, as_it_came};
  const double energy =
      0.5 * rock.mass * motion.velocity.squaredNorm() + 0.5 * rock.inertia * motion.spin.squaredNorm();
  if (energy > barrier.capacity) {
    const double kept = std::sqrt(1 - barrier.capacity / energy);
    return {BarrierOutcome::broke_through, Rebound{kept * motion.velocity, kept * motion.spin}};
  }
  if (!barrier.restitution) return {BarrierOutcome::stopped, std::nullopt};
  return {BarrierOutcome::rebounded, plain_rebound(motion.velocity, motion.spin, normal, *barrier.restitution)};
}

}  // namespace talus
