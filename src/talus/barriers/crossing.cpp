#include "talus/barriers/crossing.hpp"

#include <algorithm>
#include <array>

#include "talus/flight/touch.hpp"

namespace talus {

namespace {

constexpr double by_rounding = 1e-6;  // by which ranges are widened [m]

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

/// The first crossing of one rock's path.
class Search {
 public:
  Search(const Parabola& path, double radius, double start, double t_max, const RecentCrossings& recent)
      : path_(path),
        radius_(radius),
        margin_(radius + by_rounding),
        start_(start),
        t_max_(t_max),
        recent_(recent),
        barriers_{t_max, {}},
        // Of a barrier that ends the path a collector on its line may lie a rounding beyond.
        collectors_{t_max + same_crossing, {}} {}

  [[nodiscard]] PlanBounds bounds() const {
    const Range x(path_.p.x(), path_.v.x(), path_.a.x(), t_max_, margin_),
        y(path_.p.y(), path_.v.y(), path_.a.y(), t_max_, margin_);
    return {{x.low, y.low}, {x.high, y.high}};
  }
  void ask(BarrierId barrier, bool is_collector, const Panel& panel) {
    Earliest& earliest = is_collector ? collectors_ : barriers_;
    ask_face(barrier, panel, earliest);
    if (radius_ > 0 && panel.has_next) ask_joint(barrier, panel, earliest);
  }
  [[nodiscard]] const std::optional<Crossing>& first() const {
    const auto &barrier = barriers_.crossing, &collector = collectors_.crossing;
    if (!collector) return barrier;
    const bool is_met = barrier && !barrier->above;
    if (is_met && collector->t < barrier->t + same_crossing) return collector;
    if (collector->t > t_max_) return barrier;
    if (!barrier || collector->t < barrier->t) return collector;
    const bool is_before = collector->t == barrier->t && collector->barrier.index < barrier->barrier.index;
    return is_before ? collector : barrier;
  }

 private:
  /// The earliest crossing of a kind up to t_max.
  struct Earliest {
    double t_max;
    std::optional<Crossing> crossing;
  };
  void ask_face(BarrierId barrier, const Panel& panel, Earliest& earliest) {
    const double h0 = panel.normal.dot(path_.p - panel.foot);
    const double v = panel.normal.dot(path_.v), a = panel.normal.dot(path_.a);
    const Range distance(h0, v, a, earliest.t_max, margin_);
    if (distance.low > 0 || distance.high < 0) return;
    // From either side, the side being where the rock comes from at that time.
    for (const double side : {1.0, -1.0}) {
      const Times times = zeros(h0 - side * radius_, v, a);
      for (int i = 0; i < times.count; ++i) {
        // A rock that starts at the barrier, or a rounding beyond it, meets it.
        const double t = times.t[static_cast<std::size_t>(i)];
        if (t < -0.5 * same_crossing || t > earliest.t_max) continue;
        if (draws_away(side * (v + a * t), side * a)) continue;
        const Place place = place_on(panel, path_.at(t) - side * radius_ * panel.normal);
        // Panels of one barrier meet without a gap; a rounding's breadth beyond an end belongs to it, too.
        if (place.along < panel.start_at(place.up) - 1e-9 || place.along > panel.end_at(place.up) + 1e-9) continue;
        offer(earliest, barrier, panel, std::max(t, 0.0), place, side * panel.normal);
      }
    }
  }
  /// The side that a panel shares with the next one, over its top, too. From within a bend a sphere comes to one of the
  /// panels first.
  void ask_joint(BarrierId barrier, const Panel& panel, Earliest& earliest) {
    constexpr double endless = 1e4;  // [m]
    const Vec3 corner = panel.foot + panel.length * panel.along;
    const Vec3 side = panel.up + panel.end_lean * panel.along, direction = side.normalized();
    const auto t = touch_edge(path_, corner - margin_ * direction, direction, endless, radius_, {0, earliest.t_max});
    if (!t) return;
    const Vec3 away = tangential(path_.at(*t) - corner, direction);
    if (away.norm() < 0.5 * radius_) return;
    const double up = (path_.at(*t) - corner).dot(direction) / side.norm();
    offer(earliest, barrier, panel, *t, {panel.length, up}, away.normalized());
  }
  /// What neither comes nearer nor is drawn nearer, stays where it is. (Speeds below this are rounding.)
  static bool draws_away(double speed, double acceleration) {
    constexpr double none = 1e-9;  // [m/s]
    return speed > none || (speed > -none && acceleration >= 0);
  }
  void offer(Earliest& earliest, BarrierId barrier, const Panel& panel, double t, const Place& place,
             const Vec3& normal) {
    auto& first = earliest.crossing;
    if (place.up < -margin_ || (first && t >= first->t)) return;
    const bool from_ahead = normal.dot(panel.normal) > 0;
    if (recent_.contain(barrier, start_ + t, from_ahead)) return;
    const bool above = place.up > panel.height;
    const double share = std::clamp(place.along / panel.length, 0.0, 1.0);
    first = Crossing{t,
                     barrier,
                     std::max(place.up, 0.0),
                     above ? place.up - panel.height - radius_ : 0,
                     normal,
                     panel.up,
                     above,
                     panel.station + share * panel.plan_length,
                     from_ahead};
  }

  const Parabola& path_;
  const double radius_, margin_, start_, t_max_;
  const RecentCrossings& recent_;
  Earliest barriers_, collectors_;
};

}  // namespace

std::optional<Crossing> first_crossing(std::span<const Barrier> barriers, const Parabola& path, double radius,
                                       double start, double t_max, const RecentCrossings& recent) {
  Search search(path, radius, start, t_max, recent);
  const PlanBounds passed = search.bounds();
  for (std::uint32_t b = 0; b < barriers.size(); ++b) {
    const Barrier& barrier = barriers[b];
    barrier.on_plan().visit(
        passed, [&](std::size_t k) { search.ask(BarrierId{b}, barrier.is_collector, barrier.panels()[k]); });
  }
  return search.first();
}

}  // namespace talus
