#pragma once
// An index of a row of rectangles on plan: which of them meet a rectangle, and the distance to the nearest. A tree over
// neighbours in the row, since the panels of a barrier are next to each other on plan.

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "talus/core/vec.hpp"

namespace talus {

/// A rectangle on plan [m]; empty at first.
struct PlanBounds {
  Vec2 low = Vec2::all(std::numeric_limits<double>::infinity());
  Vec2 high = Vec2::all(-std::numeric_limits<double>::infinity());

  void grow(const Vec2& p) {
    low = low.min(p);
    high = high.max(p);
  }
  void grow(const PlanBounds& other) {
    low = low.min(other.low);
    high = high.max(other.high);
  }
  [[nodiscard]] bool meet(const PlanBounds& other) const {
    return low.is_at_most(other.high) && other.low.is_at_most(high);
  }
  /// The distance from a point [m]; 0 inside.
  [[nodiscard]] double distance(const Vec2& p) const { return (low - p).max(p - high).max(Vec2{}).norm(); }
};

class PlanIndex {
 public:
  PlanIndex() = default;
  explicit PlanIndex(std::span<const PlanBounds> row) : count_(row.size()) {
    leaves_ = 1;
    while (leaves_ < count_) leaves_ *= 2;
    nodes_.resize(2 * leaves_);  // children of k: 2 k and 2 k + 1; those beyond the row are empty
    std::copy(row.begin(), row.end(), nodes_.begin() + static_cast<std::ptrdiff_t>(leaves_));
    for (std::size_t k = leaves_ - 1; k > 0; --k) {
      nodes_[k] = nodes_[2 * k];
      nodes_[k].grow(nodes_[2 * k + 1]);
    }
  }

  /// The bounds of the whole row.
  [[nodiscard]] PlanBounds bounds() const { return count_ > 0 ? nodes_[1] : PlanBounds(); }
  /// Calls visit(k) for each rectangle that meets `bounds`, in the order of the row.
  template <class Visit>
  void visit(const PlanBounds& bounds, Visit&& visit) const {
    if (count_ > 0) visit_below(1, bounds, visit);
  }
  /// The distance from a point to the nearest rectangle [m], or `known` if that is smaller.
  [[nodiscard]] double distance(const Vec2& p, double known) const {
    return distance_to(p, known, [](std::size_t, double rectangle, double) { return rectangle; });
  }
  /// The distance to the nearest of several things inside the rectangles: distance(k, rectangle, known) returns the
  /// distance to that in rectangle k, which is `rectangle` away, or `known` if that is smaller.
  template <class Distance>
  [[nodiscard]] double distance_to(const Vec2& p, double known, Distance&& distance) const {
    if (count_ > 0) look_below(1, p, known, distance);
    return known;
  }

 private:
  template <class Visit>
  void visit_below(std::size_t node, const PlanBounds& bounds, Visit& visit) const {
    if (!nodes_[node].meet(bounds)) return;
    if (node >= leaves_) {
      visit(node - leaves_);
      return;
    }
    visit_below(2 * node, bounds, visit);
    visit_below(2 * node + 1, bounds, visit);
  }
  template <class Distance>
  void look_below(std::size_t node, const Vec2& p, double& known, Distance& distance) const {
    const double here = nodes_[node].distance(p);
    if (!(here < known)) return;
    if (node >= leaves_) {
      known = distance(node - leaves_, here, known);
      return;
    }
    const bool second_is_nearer = nodes_[2 * node + 1].distance(p) < nodes_[2 * node].distance(p);
    look_below(2 * node + (second_is_nearer ? 1 : 0), p, known, distance);
    look_below(2 * node + (second_is_nearer ? 0 : 1), p, known, distance);
  }

  std::size_t count_ = 0, leaves_ = 0;
  std::vector<PlanBounds> nodes_;
};

}  // namespace talus
