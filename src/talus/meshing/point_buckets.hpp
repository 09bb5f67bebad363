#pragma once
// Points on plan in the squares of a grid, for box queries.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "talus/core/vec.hpp"

namespace talus {

class PointBuckets {
 public:
  /// Refers to `points`, which must outlive it. About two points a square; fewer than 2^32 in all.
  explicit PointBuckets(std::span<const Vec2> points) : points_(points) {
    Vec2 high = Vec2::all(-std::numeric_limits<double>::infinity());
    for (const Vec2& p : points) {
      low_ = low_.min(p);
      high = high.max(p);
    }
    const Vec2 size = points.empty() ? Vec2(0, 0) : high - low_;
    const double wanted = std::max(1.0, 0.5 * static_cast<double>(points.size()));
    const double area = size.x() * size.y(), longer = size.largest();
    side_ = area > 0 ? std::max(std::sqrt(area / wanted), longer / 1e6) : std::max(longer / wanted, 1e-9);
    columns_ = static_cast<std::size_t>(size.x() / side_) + 1;
    rows_ = static_cast<std::size_t>(size.y() / side_) + 1;
    first_.assign(columns_ * rows_ + 1, 0);
    for (const Vec2& p : points) ++first_[bucket_of(p) + 1];
    for (std::size_t b = 0; b + 1 < first_.size(); ++b) first_[b + 1] += first_[b];
    numbers_.resize(points.size());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < points.size(); ++i)
      numbers_[next[bucket_of(points[i])]++] = static_cast<std::uint32_t>(i);
  }

  /// Calls visit(number) for every point in the closed box from low to high, and for some around it.
  template <class Visit>
  void visit_near(const Vec2& low, const Vec2& high, Visit&& visit) const {
    if (points_.empty()) return;
    const std::size_t c0 = column(low.x()), c1 = column(high.x()), r0 = row(low.y()), r1 = row(high.y());
    for (std::size_t r = r0; r <= r1; ++r) {
      const std::size_t begin = first_[r * columns_ + c0], end = first_[r * columns_ + c1 + 1];
      for (std::size_t k = begin; k < end; ++k) visit(numbers_[k]);
    }
  }

 private:
  static std::size_t clamped(double place, std::size_t count) {
    return place <= 0 ? 0 : place >= static_cast<double>(count) ? count - 1 : static_cast<std::size_t>(place);
  }
  [[nodiscard]] std::size_t column(double x) const { return clamped((x - low_.x()) / side_, columns_); }
  [[nodiscard]] std::size_t row(double y) const { return clamped((y - low_.y()) / side_, rows_); }
  [[nodiscard]] std::size_t bucket_of(const Vec2& p) const { return row(p.y()) * columns_ + column(p.x()); }

  std::span<const Vec2> points_;
  Vec2 low_ = Vec2::all(std::numeric_limits<double>::infinity());
  double side_ = 1;
  std::size_t columns_ = 1, rows_ = 1;
  std::vector<std::uint32_t> first_, numbers_;
};

}  // namespace talus
