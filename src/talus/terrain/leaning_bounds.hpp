#pragma once
// The second bounds of a tree (bvh.hpp) over triangles: planes with the mean slope of the ground in a node.

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <limits>

#include "talus/terrain/bvh.hpp"

namespace talus {

/// Adds them to a tree. `corners_at(place)` returns the three corners of the triangle at that place of the tree's
/// order.
template <class CornersAt>
void add_leaning_bounds(Bvh& tree, CornersAt&& corners_at) {
  struct Part {
    std::uint32_t first = std::numeric_limits<std::uint32_t>::max(), last = 0;  // places
    Vec3 area;                                                                  // the sum of 2 area times normal
    void add(const Part& other) {
      first = std::min(first, other.first);
      last = std::max(last, other.last);
      area += other.area;
    }
  };
  constexpr float infinite = std::numeric_limits<float>::infinity();
  const auto rounded_up = [](double x) {
    const auto f = static_cast<float>(x);
    return static_cast<double>(f) < x ? std::nextafter(f, infinite) : f;
  };
  using Node = Bvh::Node;
  const auto& nodes = tree.nodes_;
  // Children are stored after their parents.
  std::vector<Part> whole(nodes.size());
  const auto is_absent = [](const Node& node, std::size_t k) { return !(node.bound[0][k] <= node.bound[3][k]); };
  const auto child_of = [&](const Node& node, std::size_t k) {
    if (is_absent(node, k)) return Part{};
    if (node.count[k] == 0) return whole[node.first[k]];
    Part leaf{node.first[k], node.first[k] + node.count[k]};
    for (std::uint32_t place = leaf.first; place < leaf.last; ++place) {
      const auto& [a, b, c] = corners_at(place);
      leaf.area += (b - a).cross(c - a);
    }
    return leaf;
  };
  for (std::size_t n = nodes.size(); n-- > 0;) {
    for (std::size_t k = 0; k < 4; ++k) whole[n].add(child_of(nodes[n], k));
  }
  tree.leans_.resize(nodes.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, nodes.size()), [&](const auto& range) {
    for (std::size_t n = range.begin(); n < range.end(); ++n) {
      Bvh::Lean& lean = tree.leans_[n];
      // For contents that are nearly vertical on average, or overhang, a level plane is used.
      constexpr double steepest = 10;
      const Vec3& area = whole[n].area;
      if (area.z() * steepest > area.xy().norm()) {
        lean.along_x = static_cast<float>(-area.x() / area.z());
        lean.along_y = static_cast<float>(-area.y() / area.z());
      }
      const double x = lean.along_x, y = lean.along_y;
      lean.slant = rounded_up(std::sqrt(1 + x * x + y * y));
      for (std::size_t k = 0; k < 4; ++k) {
        const Part part = child_of(nodes[n], k);
        double top = -std::numeric_limits<double>::infinity(), bottom = -top;
        for (std::uint32_t place = part.first; place < part.last; ++place) {
          for (const Vec3& corner : corners_at(place)) {
            const double over = corner.z() - x * corner.x() - y * corner.y();
            top = std::max(top, over);
            bottom = std::min(bottom, over);
          }
        }
        lean.top[k] = rounded_up(top);
        lean.bottom[k] = -rounded_up(-bottom);
      }
    }
  });
}

}  // namespace talus
