#pragma once
// When a flight passes boxes: four at once, for a node of the tree, or one.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "talus/core/pair.hpp"
#include "talus/rocks/parabola.hpp"

namespace talus {

struct Box {
  Vec3 low = Vec3::all(std::numeric_limits<double>::infinity());
  Vec3 high = Vec3::all(-std::numeric_limits<double>::infinity());
  void grow(const Vec3& p) {
    low = low.min(p);
    high = high.max(p);
  }
  void grow(const Box& other) {
    low = low.min(other.low);
    high = high.max(other.high);
  }
};

/// A box that contains a short leg with any acceleration until t_max, grown by `pad`.
[[nodiscard]] inline Box swept_box(const Parabola& leg, double t_max, double pad) {
  Box swept;
  swept.grow(leg.p);
  swept.grow(leg.at(0.5 * t_max));
  swept.grow(leg.at(t_max));
  // The arc between these three points stays within an eighth of a t^2 of their box.
  const Vec3 margin = Vec3::all(pad) + 0.125 * t_max * t_max * leg.a.abs();
  return {swept.low - margin, swept.high + margin};
}

namespace slabs_detail {

// Four doubles side by side.
struct Four {
  Pair a, b;
  friend Four operator+(Four x, Four y) { return {x.a + y.a, x.b + y.b}; }
  friend Four operator-(Four x, Four y) { return {x.a - y.a, x.b - y.b}; }
  friend Four operator*(Four x, Four y) { return {x.a * y.a, x.b * y.b}; }
  [[nodiscard]] double operator[](int k) const { return k < 2 ? a[k] : b[k - 2]; }
};

struct FourMask {
  PairMask a, b;
  friend FourMask operator&(FourMask x, FourMask y) { return {x.a & y.a, x.b & y.b}; }
  [[nodiscard]] bool operator[](int k) const { return (k < 2 ? a[k] : b[k - 2]) != 0; }
};

[[nodiscard]] inline Four four(double x) { return {pair(x), pair(x)}; }
[[nodiscard]] inline Four four(const std::array<float, 4>& x) { return {Pair{x[0], x[1]}, Pair{x[2], x[3]}}; }
[[nodiscard]] inline Four least(Four x, Four y) { return {x.a < y.a ? x.a : y.a, x.b < y.b ? x.b : y.b}; }
[[nodiscard]] inline Four most(Four x, Four y) { return {x.a > y.a ? x.a : y.a, x.b > y.b ? x.b : y.b}; }
[[nodiscard]] inline FourMask at_most(Four x, Four y) { return {x.a <= y.a, x.b <= y.b}; }
[[nodiscard]] inline FourMask above(Four x, Four y) { return {x.a > y.a, x.b > y.b}; }
[[nodiscard]] inline Four chosen(FourMask mask, Four x, Four y) { return {mask.a ? x.a : y.a, mask.b ? x.b : y.b}; }

/// 1/v for slab tests, finite also where the path does not move along an axis.
[[nodiscard]] inline double reciprocal(double v) { return std::abs(v) > 1e-30 ? 1 / v : 1e30; }

}  // namespace slabs_detail

/// A flight prepared for slab tests. Its acceleration must be vertical.
class FlightSlabs {
 public:
  /// When the flight is over (or in) four boxes on plan, and its heights during that time.
  struct Passage {
    slabs_detail::Four enter, leave;     // [s]
    slabs_detail::Four lowest, highest;  // z of the path in between [m]
  };
  using Bounds = std::array<std::array<float, 4>, 6>;  // rows: low x, low y, low z, high x, high y, high z

  explicit FlightSlabs(const Parabola& path)
      : px_(path.p.x()),
        py_(path.p.y()),
        pz_(path.p.z()),
        vx_(path.v.x()),
        vy_(path.v.y()),
        vz_(path.v.z()),
        half_az_(0.5 * path.a.z()),
        inverse_vx_(slabs_detail::reciprocal(path.v.x())),
        inverse_vy_(slabs_detail::reciprocal(path.v.y())),
        top_t_(path.a.z() < 0 ? -path.v.z() / path.a.z() : 0),
        top_(path.a.z() < 0 ? path.z(top_t_) : -1e300) {}

  [[nodiscard]] Passage pass(const Bounds& bound, double pad, double t_max) const {
    using namespace slabs_detail;
    const auto when = [](const std::array<float, 4>& plane, double shift, double inverse_v) {
      return (four(plane) + four(shift)) * four(inverse_v);
    };
    const Four x1 = when(bound[0], -pad - px_, inverse_vx_), x2 = when(bound[3], pad - px_, inverse_vx_);
    const Four y1 = when(bound[1], -pad - py_, inverse_vy_), y2 = when(bound[4], pad - py_, inverse_vy_);
    Passage passage;
    passage.enter = most(most(least(x1, x2), least(y1, y2)), four(0));
    passage.leave = least(least(most(x1, x2), most(y1, y2)), four(t_max));
    const auto height = [&](Four t) { return four(pz_) + t * (four(vz_) + four(half_az_) * t); };
    const Four z1 = height(passage.enter), z2 = height(passage.leave);
    passage.lowest = least(z1, z2);
    passage.highest = most(z1, z2);
    const FourMask top_inside = above(four(top_t_), passage.enter) & above(passage.leave, four(top_t_));
    passage.highest = chosen(top_inside, most(passage.highest, four(top_)), passage.highest);
    return passage;
  }

  /// Minimum and maximum height of the flight over the plane z = along_x x + along_y y, in four passages. The height is
  /// a concave function of time: its minimum is at an end.
  struct OverSlope {
    slabs_detail::Four lowest, highest;
  };
  [[nodiscard]] OverSlope over_slope(double along_x, double along_y, const Passage& passage) const {
    using namespace slabs_detail;
    const double start = pz_ - along_x * px_ - along_y * py_, speed = vz_ - along_x * vx_ - along_y * vy_;
    const auto height = [&](Four t) { return four(start) + t * (four(speed) + four(half_az_) * t); };
    const Four first = height(passage.enter), last = height(passage.leave);
    OverSlope over{least(first, last), most(first, last)};
    if (half_az_ < 0) {
      const double top_t = -0.5 * speed / half_az_;
      const FourMask inside = above(four(top_t), passage.enter) & above(passage.leave, four(top_t));
      const double top = start + 0.5 * speed * top_t;
      over.highest = chosen(inside, most(over.highest, four(top)), over.highest);
    }
    return over;
  }

  /// A part of [0, t_max] that contains every time at which the flight is within `pad` of one box.
  [[nodiscard]] TimeWindow window(const Box& box, double pad, double t_max) const {
    const double x1 = (box.low.x() - pad - px_) * inverse_vx_, x2 = (box.high.x() + pad - px_) * inverse_vx_;
    const double y1 = (box.low.y() - pad - py_) * inverse_vy_, y2 = (box.high.y() + pad - py_) * inverse_vy_;
    const TimeWindow window{std::max({0.0, std::min(x1, x2), std::min(y1, y2)}),
                            std::min({t_max, std::max(x1, x2), std::max(y1, y2)})};
    if (window.is_empty()) return window;
    const auto height = [&](double t) { return pz_ + t * (vz_ + half_az_ * t); };
    const double z1 = height(window.enter), z2 = height(window.leave);
    const bool top_inside = top_t_ > window.enter && top_t_ < window.leave;
    const double lowest = std::min(z1, z2), highest = top_inside ? top_ : std::max(z1, z2);
    const bool meets = lowest <= box.high.z() + pad && highest >= box.low.z() - pad;
    return meets ? window : TimeWindow{1, 0};
  }

 private:
  double px_, py_, pz_, vx_, vy_, vz_, half_az_, inverse_vx_, inverse_vy_, top_t_, top_;
};

}  // namespace talus
