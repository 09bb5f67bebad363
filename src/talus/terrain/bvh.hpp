#pragma once
// A bounding volume hierarchy over boxes, with four children per node. Built top-down by the binned surface-area
// heuristic (Wald, "On fast construction of SAH-based bounding volume hierarchies", RT 2007), each node split until it
// has four children, and flattened depth-first. The same boxes always give the same tree, for any number of threads.
//
// Boxes are stored as floats, rounded outwards; tests are in double. Boxes fit sloping ground badly: a flight close
// above a slope is inside them all the way. A node may therefore have a second bound, planes with the mean slope of its
// contents (add_leaning_bounds in leaning_bounds.hpp), and such a flight stays above them.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "talus/core/large_pages.hpp"
#include "talus/terrain/flight_slabs.hpp"

namespace talus {

/// Prefetches the cache lines of something that will be read soon.
template <class Thing>
inline void fetch_soon(const Thing& thing) {
  constexpr std::size_t line = 64;
  const auto* const begin = reinterpret_cast<const char*>(&thing);
  for (std::size_t k = 0; k < sizeof(Thing); k += line) __builtin_prefetch(begin + k);
}

class Bvh {
 public:
  Bvh() = default;
  /// Sorts the boxes: `order()[k]` is the number of the box at place k. Leaves are ranges of places.
  explicit Bvh(std::span<const Box> boxes);

  [[nodiscard]] const std::vector<std::uint32_t>& order() const { return order_; }
  [[nodiscard]] std::size_t bytes() const {
    return nodes_.size() * sizeof(Node) + leans_.size() * sizeof(Lean) + order_.size() * sizeof(order_[0]);
  }

  /// Calls leaf(first, last, t_max) for the leaves whose bounds, grown by `pad` on all sides, the path may meet in [0,
  /// t_max], in order of time. `leaf` may lower t_max. The path's acceleration must be vertical.
  ///
  /// Large trees do not fit into a processor's caches: ahead(first, last) is called for a leaf as soon as it is
  /// scheduled, so that its contents can be prefetched.
  template <class Leaf, class Ahead>
  void visit_flight(const Parabola& path, double pad, double& t_max, Leaf&& leaf, Ahead&& ahead) const;
  template <class Leaf>
  void visit_flight(const Parabola& path, double pad, double& t_max, Leaf&& leaf) const {
    visit_flight(path, pad, t_max, leaf, [](std::uint32_t, std::uint32_t) {});
  }

  /// Calls leaf(first, last) for the leaves whose boxes meet [low, high].
  template <class Leaf>
  void visit_box(const Vec3& low, const Vec3& high, Leaf&& leaf) const;

  /// Calls leaf(first, last) for the leaves that are below the path on plan in [0, t_end], and whose lowest point is
  /// more than `worth()` below the path's highest point over them. worth() may grow during the search.
  template <class Leaf, class Worth>
  void visit_under(const Parabola& path, double t_end, Worth&& worth, Leaf&& leaf) const;

  /// The same in [t_from, t_end], in reverse order of time. `leaf` gets t_from by reference, and may raise it.
  template <class Leaf>
  void visit_under_from_the_end(const Parabola& path, double& t_from, double t_end, double worth, Leaf&& leaf) const;

 private:
  struct alignas(64) Node {
    FlightSlabs::Bounds bound;  // a column per child
    // A child with count 0 is the node `first`; any other is a leaf of `count` places from `first`. Absent children
    // have empty boxes (low > high), which nothing meets.
    std::array<std::uint32_t, 4> first;
    std::array<std::uint32_t, 4> count;
  };
  // The contents of child k are between the planes z = along_x x + along_y y + bottom[k] and + top[k].
  struct alignas(16) Lean {
    float along_x = 0, along_y = 0;
    float slant = 1;  // ratio of heights over such a plane to distances from it; rounded up
    float unused = 0;
    std::array<float, 4> top, bottom;
  };
  template <class CornersAt>
  friend void add_leaning_bounds(Bvh& tree, CornersAt&& corners_at);
  struct Builder;
  struct Entry {
    std::uint32_t node;
    std::uint32_t count;
    double t;  // when the path enters it, or leaves it
  };

  /// When a path is over a node's children on plan, and which of them have a lowest point more than `least` [m] below
  /// it.
  struct Under {
    FlightSlabs::Passage passage;
    slabs_detail::FourMask met;
  };
  [[nodiscard]] Under under(const FlightSlabs& slabs, std::uint32_t node, double t_end, double least) const {
    using namespace slabs_detail;
    const FlightSlabs::Bounds& bound = nodes_[node].bound;
    Under under{slabs.pass(bound, 1e-6, t_end), {}};
    const auto& passage = under.passage;
    under.met = at_most(passage.enter, passage.leave) & above(passage.highest - four(bound[2]), four(least));
    if (!leans_.empty()) {
      const Lean& lean = leans_[node];
      const auto over = slabs.over_slope(lean.along_x, lean.along_y, passage);
      under.met = under.met & above(over.highest - four(lean.bottom), four(least));
    }
    return under;
  }

  void fetch(std::uint32_t node) const {
    fetch_soon(nodes_[node]);
    if (!leans_.empty()) fetch_soon(leans_[node]);
  }

  std::vector<Node, LargePages<Node>> nodes_;
  std::vector<Lean, LargePages<Lean>> leans_;  // one per node, or empty
  std::vector<std::uint32_t> order_;
};

template <class Leaf, class Ahead>
void Bvh::visit_flight(const Parabola& path, double pad, double& t_max, Leaf&& leaf, Ahead&& ahead) const {
  using namespace slabs_detail;
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
    const FlightSlabs::Passage passage = slabs.pass(node.bound, pad, t_max);
    FourMask met = at_most(passage.enter, passage.leave) & at_most(four(node.bound[2]) - four(pad), passage.highest) &
                   at_most(passage.lowest, four(node.bound[5]) + four(pad));
    if (!leans_.empty()) {
      const Lean& lean = leans_[entry.node];
      const auto over = slabs.over_slope(lean.along_x, lean.along_y, passage);
      met = met & at_most(over.lowest, four(lean.top) + four(pad * lean.slant));
    }
    // Pushed latest first, so that the earliest is taken next.
    const int base = depth;
    for (int k = 0; k < 4; ++k) {
      if (!met[k]) continue;
      const auto child = static_cast<std::size_t>(k);
      Entry next{node.first[child], node.count[child], passage.enter[k]};
      if (next.count > 0) {
        ahead(next.node, next.node + next.count);
      } else {
        fetch(next.node);
      }
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
  if (nodes_.empty()) return;
  const FlightSlabs slabs(path);
  std::array<std::uint32_t, 192> stack;
  std::size_t depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const std::uint32_t at = stack[--depth];
    const Node& node = nodes_[at];
    const slabs_detail::FourMask met = under(slabs, at, t_end, worth()).met;
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

template <class Leaf>
void Bvh::visit_under_from_the_end(const Parabola& path, double& t_from, double t_end, double worth,
                                   Leaf&& leaf) const {
  if (nodes_.empty()) return;
  const FlightSlabs slabs(path);
  std::array<Entry, 192> stack;
  std::size_t depth = 0;
  stack[depth++] = {0, 0, t_end};
  while (depth > 0) {
    const Entry entry = stack[--depth];
    if (entry.t < t_from) continue;
    if (entry.count > 0) {
      leaf(entry.node, entry.node + entry.count, t_from);
      continue;
    }
    const Node& node = nodes_[entry.node];
    const auto [passage, met] = under(slabs, entry.node, t_end, worth);
    // Pushed earliest first, so that the latest is taken next.
    const std::size_t base = depth;
    for (std::size_t k = 0; k < 4; ++k) {
      if (!met[static_cast<int>(k)]) continue;
      const Entry next{node.first[k], node.count[k], passage.leave[static_cast<int>(k)]};
      std::size_t place = depth++;
      for (; place > base && stack[place - 1].t > next.t; --place) stack[place] = stack[place - 1];
      stack[place] = next;
    }
  }
}

}  // namespace talus
