#include "talus/barriers/crossing.hpp"

#include <algorithm>

#include "talus/barriers/on_panel.hpp"
#include "talus/rocks/heights.hpp"
#include "talus/rocks/touch.hpp"

namespace talus {

namespace {

using tolerance::same_crossing;

using namespace on_panel;

/// The first crossing of one rock's path.
class Search {
 public:
  Search(const Parabola& path, double radius, double start, double t_max, const RecentCrossings& recent, double below)
      : path_(path), radius_(radius), margin_(radius + below), start_(start), t_max_(t_max), recent_(recent) {}

  [[nodiscard]] PlanBounds bounds() const { return bounds_of(path_, t_max_, margin_); }

  /// Where the rock touches a barrier's panel, and where it passes above it.
  void search_barrier(BarrierId barrier, const Panel& panel) {
    if (radius_ > 0) {
      touch_face(barrier, panel);
      touch_outline(barrier, panel);
    }
    cross_face(barrier, panel, first_barrier_);
    pass_over(barrier, panel, first_barrier_);
  }

  /// Where its centre passes through a collector, or above it. A sphere that a barrier keeps from the collector counts
  /// where it is, if it touches the collector there. To be called after all barriers.
  void search_collector(BarrierId barrier, const Panel& panel) {
    cross_face(barrier, panel, first_collector_);
    pass_over(barrier, panel, first_collector_);
    if (radius_ > 0 && is_met()) reach_over(barrier, panel, first_barrier_->t);
  }

  [[nodiscard]] const std::optional<Crossing>& first() const {
    const auto &barrier = first_barrier_, &collector = first_collector_;
    if (!collector) return barrier;
    if (is_met() && collector->t < barrier->t + same_crossing) return collector;
    if (collector->t > t_max_) return barrier;
    if (!barrier || collector->t < barrier->t) return collector;
    const bool is_before = collector->t == barrier->t && collector->barrier.index < barrier->barrier.index;
    return is_before ? collector : barrier;
  }

 private:
  using First = std::optional<Crossing>;

  [[nodiscard]] bool is_met() const { return first_barrier_ && !first_barrier_->above; }
  /// The end of the search for crossings of a kind. A collector on the line of a barrier that ends the path may be
  /// beyond it by rounding.
  [[nodiscard]] double time_for(const First& first) const {
    return &first == &first_collector_ ? t_max_ + same_crossing : t_max_;
  }

  /// Calls meets(t, side) for each time at which the path comes within `distance` of a plane, from either side; `side`:
  /// 1 if it comes from the side of the normal, -1 from the other.
  template <class Meets>
  void come_near(const Vec3& point, const Vec3& normal, double distance, double t_max, Meets&& meets) const {
    const double h0 = normal.dot(path_.p - point), v = normal.dot(path_.v), a = normal.dot(path_.a);
    const Range range(h0, v, a, t_max, distance + tolerance::barrier_range);
    if (range.low > 0 || range.high < 0) return;
    for (const double side : {1.0, -1.0}) {
      const Times times = zeros(h0 - side * distance, v, a);
      for (int i = 0; i < times.count; ++i) {
        // A rock that starts at the barrier, or beyond it by rounding, meets it.
        const double t = times.t[static_cast<std::size_t>(i)];
        if (t < -0.5 * same_crossing || t > t_max) continue;
        if (!draws_away(side * (v + a * t), side * a)) meets(std::max(t, 0.0), side);
      }
    }
  }

  /// A sphere touches a panel's face, from slightly below its foot to its top.
  void touch_face(BarrierId barrier, const Panel& panel) {
    come_near(panel.foot, panel.normal, radius_, t_max_, [&](double t, double side) {
      const Place place = place_on(panel, path_.at(t) - side * radius_ * panel.normal);
      if (place.up < -margin_ || place.up > panel.height || !is_between_sides(panel, place)) return;
      offer(first_barrier_, hit(barrier, panel, t, place, side));
    });
  }

  /// It touches the panel's top, one of its sides or a corner. (Shared sides belong to the first of both panels.)
  void touch_outline(BarrierId barrier, const Panel& panel) {
    const double h0 = panel.normal.dot(path_.p - panel.foot);
    const Range distance(h0, panel.normal.dot(path_.v), panel.normal.dot(path_.a), t_max_, margin_);
    if (distance.low > 0 || distance.high < 0) return;
    const double top_start = panel.start_at(panel.height), top_end = panel.end_at(panel.height);
    touch_edge_of(barrier, panel, {top_start, panel.height}, {top_end, panel.height});
    if (!panel.has_sides) return;
    touch_edge_of(barrier, panel, {panel.length, 0}, {top_end, panel.height});
    touch_corner(barrier, panel, {top_end, panel.height});
    if (panel.has_previous) return;
    touch_edge_of(barrier, panel, {0, 0}, {top_start, panel.height});
    touch_corner(barrier, panel, {top_start, panel.height});
  }
  /// Sides continue below the foot.
  void touch_edge_of(BarrierId barrier, const Panel& panel, const Place& from, const Place& to) {
    const Vec3 start = point_of(panel, from), way = point_of(panel, to) - start;
    const double length = way.norm(), below = from.up == 0 ? margin_ : 0;
    if (!(length > 0)) return;
    const Vec3 direction = way / length;
    const auto t =
        touch_edge(path_, start - below * direction, direction, length + below, radius_, {0, time_of_first()});
    if (!t) return;
    const double share = (path_.at(*t) - start).dot(direction) / length;
    const Place place{from.along + share * (to.along - from.along), from.up + share * (to.up - from.up)};
    offer_edge(barrier, panel, *t, place);
  }
  void touch_corner(BarrierId barrier, const Panel& panel, const Place& corner) {
    const auto t = touch_point(path_, point_of(panel, corner), radius_, {0, time_of_first()});
    if (t) offer_edge(barrier, panel, *t, corner);
  }
  void offer_edge(BarrierId barrier, const Panel& panel, double t, const Place& place) {
    const Vec3 away = path_.at(t) - point_of(panel, place);
    // A path that begins within the outline does not meet it: the centre may still reach the face.
    if (away.norm() < 0.5 * radius_) return;
    Crossing crossing = hit(barrier, panel, t, place, away.dot(panel.normal) < 0 ? -1 : 1);
    crossing.normal = away.normalized();
    crossing.lowest = lowest_point(place_on(panel, path_.at(t)).up, radius_);
    offer(first_barrier_, crossing);
  }
  [[nodiscard]] double time_of_first() const { return first_barrier_ ? first_barrier_->t : t_max_; }

  /// The centre reaches a panel's face.
  void cross_face(BarrierId barrier, const Panel& panel, First& first) {
    come_near(panel.foot, panel.normal, 0, time_for(first), [&](double t, double side) {
      const Place place = place_on(panel, path_.at(t));
      if (place.up < -margin_ || place.up > panel.height || !is_between_sides(panel, place)) return;
      offer(first, hit(barrier, panel, t, place, side));
    });
  }

  /// The centre comes over a panel's top. A rock that reaches down to the top there meets the panel; a collector, also
  /// one that reaches down to it elsewhere on its path.
  void pass_over(BarrierId barrier, const Panel& panel, First& first) {
    const double top_start = panel.start_at(panel.height);
    const Vec3 start = point_of(panel, {top_start, panel.height});
    const Vec3 normal = panel.along.cross(unit_z).normalized();
    come_near(start, normal, 0, time_for(first), [&](double t, double side) {
      const Vec3 from_start = path_.at(t) - start;
      const Vec2 plan = panel.along.xy();
      const double along = from_start.xy().dot(plan) / plan.squared_norm();
      const double over = from_start.z() - along * panel.along.z();
      const Place place{top_start + along, panel.height + std::max(over, 0.0) * panel.up.z()};
      if (over < -tolerance::panel_border || !is_between_sides(panel, place)) return;
      Crossing crossing = hit(barrier, panel, t, place, side);
      const Vec3 distance = tangential(over * unit_z, panel.along);
      const Vec3 way = tangential(path_.velocity(t), panel.along);
      const double nearest = &first == &first_collector_ ? distance.cross(way.normalized()).norm() : distance.norm();
      crossing.above = nearest > radius_ + tolerance::panel_border;
      if (crossing.above) {
        crossing.clearance = over - radius_;
        crossing.normal = side * normal;
        crossing.way_over = std::max(0.0, panel.height * panel.up.dot(crossing.normal));
      }
      offer(first, crossing);
    });
  }

  /// At a time, a sphere touches a collector or is above it, and its centre has not reached it.
  void reach_over(BarrierId barrier, const Panel& panel, double t) {
    const Vec3 centre = path_.at(t);
    const double distance = panel.normal.dot(centre - panel.foot);
    if (std::abs(distance) > margin_) return;
    const double side = distance < 0 ? -1 : 1;
    if (draws_away(side * panel.normal.dot(path_.velocity(t)), side * panel.normal.dot(path_.a))) return;
    const Place place = place_on(panel, centre);
    if (place.up < -margin_ || !is_between_sides(panel, place)) return;
    Crossing crossing = hit(barrier, panel, t, place, side);
    crossing.above = place.up > panel.height + radius_;
    if (crossing.above) crossing.clearance = place.up - panel.height - radius_;
    offer(first_collector_, crossing);
  }

  /// `place`: as high along the face as the rock's place; `side`: 1 from the side of the panel's normal, -1 from
  /// behind.
  [[nodiscard]] Crossing hit(BarrierId barrier, const Panel& panel, double t, const Place& place, double side) const {
    const double share = std::clamp(place.along / panel.length, 0.0, 1.0);
    Crossing crossing;
    crossing.t = t;
    crossing.barrier = barrier;
    crossing.height = std::max(place.up, 0.0);
    crossing.lowest = lowest_point(place.up, radius_);
    crossing.normal = crossing.across = side * panel.normal;
    crossing.up = panel.up;
    crossing.station = panel.station + share * panel.plan_length;
    crossing.from_ahead = side > 0;
    return crossing;
  }
  void offer(First& first, const Crossing& crossing) const {
    if (first && crossing.t >= first->t) return;
    if (!recent_.contain(crossing, start_ + crossing.t)) first = crossing;
  }

  const Parabola& path_;
  const double radius_, margin_, start_, t_max_;
  const RecentCrossings& recent_;
  First first_barrier_, first_collector_;
};

}  // namespace

std::optional<Crossing> first_crossing(const BarrierList& barriers, const Parabola& path, double radius, double start,
                                       double t_max, const RecentCrossings& recent, double below) {
  Search search(path, radius, start, t_max, recent, below);
  const PlanBounds passed = search.bounds();
  for (const bool collectors : {false, true}) {
    barriers.visit(passed, [&](std::size_t number) {
      const Barrier& barrier = barriers[number];
      if (barrier.is_collector != collectors) return;
      const BarrierId b{static_cast<std::uint32_t>(number)};
      barrier.on_plan().visit(passed, [&](std::size_t k) {
        const Panel& panel = barrier.panels()[k];
        collectors ? search.search_collector(b, panel) : search.search_barrier(b, panel);
      });
    });
  }
  return search.first();
}

}  // namespace talus
