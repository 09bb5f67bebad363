#include "talus/terrain/bvh.hpp"

#include <tbb/parallel_invoke.h>

#include <memory>
#include <numeric>

#include "talus/core/stop.hpp"

namespace talus {

namespace {

constexpr std::size_t bins = 16;
constexpr std::uint32_t leaf_size = 4;            // measured: 2 to 6 differ by less than the noise
constexpr int deepest_by_heuristic = 40;          // deeper ranges are halved, so that no input makes a deeper tree
constexpr std::uint32_t parallel_size = 1 << 14;  // smaller ranges are not worth a task

float rounded_down(double x) {
  const auto f = static_cast<float>(x);
  return static_cast<double>(f) > x ? std::nextafter(f, -std::numeric_limits<float>::infinity()) : f;
}
float rounded_up(double x) { return -rounded_down(-x); }

double half_area(const Box& box) {
  const Vec3 d = box.high - box.low;
  return d.x() * d.y() + d.y() * d.z() + d.z() * d.x();
}

struct Range {
  std::uint32_t first, last;
  Box box;
  [[nodiscard]] std::uint32_t size() const { return last - first; }
};

}  // namespace

struct Bvh::Builder {
  // The tree before it is flattened: a node with up to four ranges, each a leaf or another node.
  struct Draft {
    std::array<Range, 4> part;
    std::array<std::unique_ptr<Draft>, 4> child;
    std::size_t count = 0;
  };

  std::span<const Box> boxes;
  std::vector<std::uint32_t>& order;

  Box bounds(std::uint32_t first, std::uint32_t last) const {
    Box box;
    for (std::uint32_t k = first; k < last; ++k) box.grow(boxes[order[k]]);
    return box;
  }

  static double centre(const Box& box, int axis) { return 0.5 * (box.low[axis] + box.high[axis]); }

  // Splits a range in two where the surface-area heuristic expects the fewest tests; halves it if all centres agree.
  std::pair<Range, Range> split(const Range& range, bool halve) {
    Box centres;
    for (std::uint32_t k = range.first; k < range.last; ++k) {
      const Box& box = boxes[order[k]];
      centres.grow(0.5 * (box.low + box.high));
    }
    double best_cost = std::numeric_limits<double>::infinity();
    int best_axis = -1;
    std::size_t best_bin = 0;
    for (int axis = 0; axis < 3 && !halve; ++axis) {
      const double low = centres.low[axis], width = centres.high[axis] - low;
      if (!(width > 0)) continue;
      std::array<Box, bins> bin_box{};
      std::array<std::uint32_t, bins> bin_count{};
      for (std::uint32_t k = range.first; k < range.last; ++k) {
        const Box& box = boxes[order[k]];
        const std::size_t bin = bin_of(box, axis, low, width);
        bin_box[bin].grow(box);
        ++bin_count[bin];
      }
      std::array<double, bins> right_cost{};
      Box right;
      std::uint32_t right_count = 0;
      for (std::size_t b = bins - 1; b > 0; --b) {
        right.grow(bin_box[b]);
        right_count += bin_count[b];
        right_cost[b] = right_count > 0 ? half_area(right) * right_count : 0;
      }
      Box left;
      std::uint32_t left_count = 0;
      for (std::size_t b = 0; b + 1 < bins; ++b) {
        left.grow(bin_box[b]);
        left_count += bin_count[b];
        if (left_count == 0 || left_count == range.size()) continue;
        const double cost = half_area(left) * left_count + right_cost[b + 1];
        if (cost < best_cost) {
          best_cost = cost;
          best_axis = axis;
          best_bin = b;
        }
      }
    }
    std::uint32_t middle = range.first + range.size() / 2;
    if (best_axis >= 0) {
      const double low = centres.low[best_axis], width = centres.high[best_axis] - low;
      const auto it = std::partition(order.begin() + range.first, order.begin() + range.last, [&](std::uint32_t i) {
        return bin_of(boxes[i], best_axis, low, width) <= best_bin;
      });
      middle = static_cast<std::uint32_t>(it - order.begin());
    }
    return {{range.first, middle, bounds(range.first, middle)}, {middle, range.last, bounds(middle, range.last)}};
  }

  static std::size_t bin_of(const Box& box, int axis, double low, double width) {
    const double place = (centre(box, axis) - low) / width * static_cast<double>(bins);
    return std::min(static_cast<std::size_t>(place), bins - 1);
  }

  std::unique_ptr<Draft> build(const Range& range, int depth) {
    auto draft = std::make_unique<Draft>();
    draft->part[0] = range;
    draft->count = 1;
    while (draft->count < 4) {
      // Split the largest part that is not yet a leaf.
      std::size_t widest = 4;
      for (std::size_t k = 0; k < draft->count; ++k) {
        if (draft->part[k].size() <= leaf_size) continue;
        if (widest == 4 || half_area(draft->part[k].box) > half_area(draft->part[widest].box)) widest = k;
      }
      if (widest == 4) break;
      auto [left, right] = split(draft->part[widest], depth > deepest_by_heuristic);
      draft->part[widest] = left;
      draft->part[draft->count++] = right;
    }
    const auto descend = [&](std::size_t k) {
      if (k < draft->count && draft->part[k].size() > leaf_size) draft->child[k] = build(draft->part[k], depth + 1);
    };
    if (range.size() > parallel_size) {
      stop_point();
      const StopScope* const here = StopScope::current();
      const auto task = [&](std::size_t k) {
        const StopScope scope(here);
        descend(k);
      };
      tbb::parallel_invoke([&] { task(0); }, [&] { task(1); }, [&] { task(2); }, [&] { task(3); });
    } else {
      for (std::size_t k = 0; k < 4; ++k) descend(k);
    }
    return draft;
  }

  static std::uint32_t flatten(const Draft& draft, std::vector<Node, LargePages<Node>>& nodes) {
    const auto here = static_cast<std::uint32_t>(nodes.size());
    nodes.emplace_back();
    for (std::size_t k = 0; k < 4; ++k) {
      const bool present = k < draft.count;
      const Box box = present ? draft.part[k].box : Box{};
      std::uint32_t first = 0, count = 1;
      if (present) {
        first = draft.child[k] ? flatten(*draft.child[k], nodes) : draft.part[k].first;
        count = draft.child[k] ? 0 : draft.part[k].size();
      }
      Node& node = nodes[here];
      for (int axis = 0; axis < 3; ++axis) {
        node.bound[static_cast<std::size_t>(axis)][k] = rounded_down(box.low[axis]);
        node.bound[static_cast<std::size_t>(axis) + 3][k] = rounded_up(box.high[axis]);
      }
      node.first[k] = first;
      node.count[k] = count;
    }
    return here;
  }
};

Bvh::Bvh(std::span<const Box> boxes) : order_(boxes.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  if (boxes.empty()) return;
  Builder builder{boxes, order_};
  const auto last = static_cast<std::uint32_t>(boxes.size());
  const auto root = builder.build({0, last, builder.bounds(0, last)}, 0);
  nodes_.reserve(boxes.size() / 4 + 1);
  Builder::flatten(*root, nodes_);
  nodes_.shrink_to_fit();
}

}  // namespace talus
