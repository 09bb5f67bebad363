#include "talus/barriers/body_crossing.hpp"

namespace talus {

bool may_meet(const BarrierList& barriers, const Parabola& path, double t_max, double margin) {
  if (barriers.empty()) return false;
  const PlanBounds passed = on_panel::bounds_of(path, t_max, margin + tolerance::barrier_range);
  bool is_near = false;
  barriers.visit(passed, [&](std::size_t number) {
    barriers[number].on_plan().visit(passed, [&](std::size_t) { is_near = true; });
  });
  return is_near;
}

namespace body_crossing {

using namespace on_panel;

std::optional<TimesNear> times_near(const Panel& panel, const Parabola& path, double distance, double t_max) {
  const double h0 = panel.normal.dot(path.p - panel.foot), v = panel.normal.dot(path.v), a = panel.normal.dot(path.a);
  const Range range(h0, v, a, t_max, distance);
  if (range.low > 0 || range.high < 0) return std::nullopt;
  const auto is_near = [&](double t) { return std::abs(h0 + v * t + 0.5 * a * t * t) <= distance; };
  TimesNear near{is_near(0) ? 0 : t_max, is_near(t_max) ? t_max : 0};
  for (const double side : {1.0, -1.0}) {
    const Times times = zeros(h0 - side * distance, v, a);
    for (int i = 0; i < times.count; ++i) {
      const double t = times.t[static_cast<std::size_t>(i)];
      if (!(t >= 0 && t <= t_max)) continue;
      near = {std::min(near.first, t), std::max(near.last, t)};
    }
  }
  if (near.first > near.last) return std::nullopt;
  if (!panel.has_sides) return near;
  const Vec3 p = path.at(near.first) - panel.foot, velocity = path.velocity(near.first);
  const Range along(p.dot(panel.along), velocity.dot(panel.along), path.a.dot(panel.along), near.last - near.first,
                    distance);
  const double lean = std::abs(panel.along.dot(panel.up)) * panel.height;
  const double start = std::min(0.0, panel.start_at(panel.height)) - lean - distance;
  const double end = std::max(panel.length, panel.end_at(panel.height)) + lean + distance;
  return along.high >= start && along.low <= end ? std::optional(near) : std::nullopt;
}

std::array<Vec3, 4> outline_near(const Panel& panel, const Vec3& centre, double reach) {
  const double below = -reach - tolerance::barrier_range;
  Place start{panel.start_lean * below, below}, end{panel.length + panel.end_lean * below, below};
  Place top_start{panel.start_at(panel.height), panel.height}, top_end{panel.end_at(panel.height), panel.height};
  if (!panel.has_sides) {  // as wide as the rock can tell
    const double along = place_on(panel, centre).along, width = 4 * (reach + panel.height);
    start.along = top_start.along = along - width;
    end.along = top_end.along = along + width;
  }
  return {point_of(panel, start), point_of(panel, end), point_of(panel, top_end), point_of(panel, top_start)};
}

Separation across(const Panel& panel, const Posture& body) {
  const Place place = place_on(panel, body.centre);
  const double along = panel.has_sides ? std::clamp(place.along, 0.0, panel.length) : place.along;
  const double side = panel.normal.dot(body.centre - panel.foot) < 0 ? -1 : 1;
  return {0, side * panel.normal, point_of(panel, {along, std::clamp(place.up, 0.0, panel.height)})};
}

Extent extent_on(const Panel& panel, const Posture& body) {
  const double centre = place_on(panel, body.centre).up;
  Extent extent{centre, centre};
  for (std::size_t i = 0; i < body.corners.size(); ++i) {
    const double up = place_on(panel, body.place(i)).up;
    extent = {std::min(extent.lowest, up), std::max(extent.highest, up)};
  }
  return extent;
}

bool is_at(const Panel& panel, const Posture& body, const Parabola& path, double t) {
  const double distance = panel.normal.dot(body.centre - panel.foot), side = distance < 0 ? -1 : 1;
  if (draws_away(side * panel.normal.dot(path.velocity(t)), side * panel.normal.dot(path.a))) return false;
  double nearest = side * distance;
  for (std::size_t i = 0; i < body.corners.size(); ++i) {
    nearest = std::min(nearest, side * distance + side * panel.normal.dot(body.arm(i)));
  }
  const Place place = place_on(panel, body.centre);
  return nearest <= tolerance::barrier_range && place.up >= -body.reach && is_between_sides(panel, place);
}

const Panel& panel_of(const Barrier& barrier, const Crossing& crossing) {
  for (const Panel& panel : barrier.panels()) {
    if (crossing.station <= panel.station + panel.plan_length) return panel;
  }
  return barrier.panels().back();
}

Crossing meeting(BarrierId barrier, const Panel& panel, const Posture& body, double t, const Vec3& contact,
                 const Vec3& normal) {
  const Place place = place_on(panel, contact);
  const double side = panel.normal.dot(body.centre - panel.foot) < 0 ? -1 : 1;
  const Extent extent = extent_on(panel, body);
  Crossing crossing;
  crossing.t = t;
  crossing.barrier = barrier;
  crossing.height = std::max(place.up, 0.0);
  crossing.lowest = std::max(extent.lowest, 0.0);
  crossing.half_height = 0.5 * (extent.highest - extent.lowest);
  crossing.normal = normal;
  crossing.across = side * panel.normal;
  crossing.up = panel.up;
  crossing.station = panel.station + std::clamp(place.along / panel.length, 0.0, 1.0) * panel.plan_length;
  crossing.from_ahead = side > 0;
  return crossing;
}

}  // namespace body_crossing
}  // namespace talus
