#pragma once
// A bounding volume hierarchy with four children a node, over boxes; it knows nothing of what is in them.
// Built top-down by the binned surface-area heuristic (Wald, "On fast construction of SAH-based bounding volume
// hierarchies", RT 2007), each node split until it has four children; flattened depth-first, so that the same boxes
// always give the same tree, whatever the threads do.
//
// The boxes are stored as floats rounded outwards; the tests are in double.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "talus/flight/parabola.hpp"

namespace talus {

struct Box {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = Vec3::Constant(-std::numeric_limits<double>::infinity());
  void grow(const Vec3& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  void grow(const Box& other) {
    low = low.cwiseMin(other.low);
    high = high.cwiseMax(other.high);
  }
};

class Bvh {
 public:
  Bvh() = default;
  /// Afterwards `order()[k]` is the number of the box that came to stand at place k; leaves are ranges of places.
  explicit Bvh(std::span<const Box> boxes);

  [[nodiscard]] const std::vector<std::uint32_t>& order() const { return order_; }
  [[nodiscard]] std::size_t bytes() const { return nodes_.size() * sizeof(Node) + order_.size() * sizeof(order_[0]); }

  /// Calls leaf(first, last) for the leaves whose boxes, grown by `pad` on all sides, the path may meet at times in
  /// [0, t_max], the nearest in time first. `leaf` may lower t_max, which it gets by reference. The path's
  /// acceleration must be vertical.
  template <class Leaf>
  void visit_flight(const Parabola& path, double pad, double& t_max, Leaf&& leaf) const;

  /// Calls leaf(first, last) for the leaves whose boxes meet [low, high].
  template <class Leaf>
  void visit_box(const Vec3& low, const Vec3& high, Leaf&& leaf) const;

  /// Calls leaf(first, last) for the leaves that lie on plan under the path in [0, t_end] and whose lowest point is
  /// more than `worth()` below the path's highest point above them; worth() may rise on the way.
  template <class Leaf, class Worth>
  void visit_under(const Parabola& path, double t_end, Worth&& worth, Leaf&& leaf) const;

 private:
  struct alignas(64) Node {
    // A row per bound: low x, low y, low z, high x, high y, high z; a column per child.
    std::array<std::array<float, 4>, 6> bound;
    // A child with count 0 is the node `first`; otherwise a leaf of `count` places from `first`. Absent children have
    // empty boxes (low > high), which nothing meets.
    std::array<std::uint32_t, 4> first;
    std::array<std::uint32_t, 4> count;
  };
  struct Builder;

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
};

namespace bvh_detail {

// Four doubles side by side, as two pairs: pairs are what every 64-bit processor has registers for, and what the
// compiler turns into one instruction each.
using Pair = double __attribute__((vector_size(16)));
using PairMask = decltype(Pair{} < Pair{});

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

[[nodiscard]] inline Four four(double x) { return {Pair{x, x}, Pair{x, x}}; }
[[nodiscard]] inline Four four(const std::array<float, 4>& x) { return {Pair{x[0], x[1]}, Pair{x[2], x[3]}}; }
[[nodiscard]] inline Four least(Four x, Four y) { return {x.a < y.a ? x.a : y.a, x.b < y.b ? x.b : y.b}; }
[[nodiscard]] inline Four most(Four x, Four y) { return {x.a > y.a ? x.a : y.a, x.b > y.b ? x.b : y.b}; }
[[nodiscard]] inline FourMask at_most(Four x, Four y) { return {x.a <= y.a, x.b <= y.b}; }
[[nodiscard]] inline FourMask above(Four x, Four y) { return {x.a > y.a, x.b > y.b}; }
[[nodiscard]] inline Four chosen(FourMask mask, Four x, Four y) { return {mask.a ? x.a : y.a, mask.b ? x.b : y.b}; }

/// 1/v for slab tests, finite also where the path does not move along an axis.
[[nodiscard]] inline double reciprocal(double v) { return std::abs(v) > 1e-30 ? 1 / v : 1e30; }

struct Entry {
  std::uint32_t node;
  std::uint32_t count;
  double t;  // when the path enters it
};

/// When a flight is over (or in) four boxes on plan, and how high it is then.
struct Passage {
  Four enter, leave;     // [s]
  Four lowest, highest;  // of the path in between [m]
};

/// A flight made ready for slab tests.
struct FlightSlabs {
  explicit FlightSlabs(const Parabola& path)
      : px(path.p.x()),
        py(path.p.y()),
        pz(path.p.z()),
        vz(path.v.z()),
        half_az(0.5 * path.a.z()),
        inverse_vx(reciprocal(path.v.x())),
        inverse_vy(reciprocal(path.v.y())),
        top_t(path.a.z() < 0 ? -path.v.z() / path.a.z() : 0),
        top(path.a.z() < 0 ? path.z(top_t) : -1e300) {}

  [[nodiscard]] Passage pass(const std::array<std::array<float, 4>, 6>& bound, double pad, double t_max) const {
    const auto when = [](const std::array<float, 4>& plane, double shift, double inverse_v) {
      return (four(plane) + four(shift)) * four(inverse_v);
    };
    const Four x1 = when(bound[0], -pad - px, inverse_vx), x2 = when(bound[3], pad - px, inverse_vx);
    const Four y1 = when(bound[1], -pad - py, inverse_vy), y2 = when(bound[4], pad - py, inverse_vy);
    Passage passage;
    passage.enter = most(most(least(x1, x2), least(y1, y2)), four(0));
    passage.leave = least(least(most(x1, x2), most(y1, y2)), four(t_max));
    const auto height = [&](Four t) { return four(pz) + t * (four(vz) + four(half_az) * t); };
    const Four z1 = height(passage.enter), z2 = height(passage.leave);
    passage.lowest = least(z1, z2);
    passage.highest = most(z1, z2);
    const FourMask top_inside = above(four(top_t), passage.enter) & above(passage.leave, four(top_t));
    passage.highest = chosen(top_inside, most(passage.highest, four(top)), passage.highest);
    return passage;
  }

  double px, py, pz, vz, half_az, inverse_vx, inverse_vy, top_t, top;
};

}  // namespace bvh_detail

template <class Leaf>
void Bvh::visit_flight(const Parabola& path, double pad, double& t_max, Leaf&& leaf) const {
  using namespace bvh_detail;
  if (nodes_.empty()) return;
  const FlightSlabs slabs(path);
  std::array<Entry, 192> stack;
  int depth = 0;
  stack[0] = {0, 0, 0};
  depth = 1;
  while (depth > 0) {
    const Entry entry = stack[static_cast<std::size_t>(--depth)];
    if (entry.t > t_max) continue;
    if (entry.count > 0) {
      leaf(entry.node, entry.node + entry.count, t_max);
      continue;
    }
    const Node& node = nodes_[entry.node];
    const Passage passage = slabs.pass(node.bound, pad, t_max);
    const FourMask met = at_most(passage.enter, passage.leave) &
                         at_most(four(node.bound[2]) - four(pad), passage.highest) &
                         at_most(passage.lowest, four(node.bound[5]) + four(pad));
    // Pushed latest first, so that the nearest is taken next.
    const int base = depth;
    for (int k = 0; k < 4; ++k) {
      if (!met[k]) continue;
      const auto child = static_cast<std::size_t>(k);
      Entry next{node.first[child], node.count[child], passage.enter[k]};
      int place = depth++;
      for (; place > base && stack[static_cast<std::size_t>(place - 1)].t < next.t; --place) {
        stack[static_cast<std::size_t>(place)] = stack[static_cast<std::size_t>(place - 1)];
      }
      stack[static_cast<std::size_t>(place)] = next;
    }
  }
}

template <class Leaf>
void Bvh::visit_box(const Vec3& low, const Vec3& high, Leaf&& leaf) const {
  if (nodes_.empty()) return;
  std::array<std::uint32_t, 192> stack;
  std::size_t depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const Node& node = nodes_[stack[--depth]];
    for (std::size_t k = 0; k < 4; ++k) {
      const bool met = node.bound[0][k] <= high.x() && node.bound[3][k] >= low.x() && node.bound[1][k] <= high.y() &&
                       node.bound[4][k] >= low.y() && node.bound[2][k] <= high.z() && node.bound[5][k] >= low.z();
      if (!met) continue;
      if (node.count[k] > 0) {
        leaf(node.first[k], node.first[k] + node.count[k]);
      } else {
        stack[depth++] = node.first[k];
      }
    }
  }
}

template <class Leaf, class Worth>
void Bvh::visit_under(const Parabola& path, double t_end, Worth&& worth, Leaf&& leaf) const {
  using namespace bvh_detail;
  if (nodes_.empty()) return;
  const FlightSlabs slabs(path);
  std::array<std::uint32_t, 192> stack;
  std::size_t depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const Node& node = nodes_[stack[--depth]];
    const Passage passage = slabs.pass(node.bound, 1e-6, t_end);
    const FourMask met =
        at_most(passage.enter, passage.leave) & above(passage.highest - four(node.bound[2]), four(worth()));
    for (std::size_t k = 0; k < 4; ++k) {
      if (!met[static_cast<int>(k)]) continue;
      if (node.count[k] > 0) {
        leaf(node.first[k], node.first[k] + node.count[k]);
      } else {
        stack[depth++] = node.first[k];
      }
    }
  }
}

}  // namespace talus
