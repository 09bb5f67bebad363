#pragma once
// Proper scores of a simulated distribution against observed values, and distances between two distributions.
//
// T. Gneiting and A. E. Raftery, "Strictly proper scoring rules, prediction, and estimation", Journal of the American
// Statistical Association 102 (2007) 359-378, sections 4.2 and 4.3: the continuous ranked probability score
//   CRPS(F, y) = E|X - y| - E|X - X'| / 2
// and the energy score, the same with distances in the plane; X and X' are independent and distributed as F. Both are
// in the unit of the values, 0 for a certain and correct forecast, and on average lowest for the true distribution.
//
// G. J. Szekely and M. L. Rizzo, "Energy statistics: a class of statistics based on distances", Journal of Statistical
// Planning and Inference 143 (2013) 1249-1272: the energy distance
//   D(F, G) = 2 E|X - Y| - E|X - X'| - E|Y - Y'|,
// in the unit of the values, 0 if and only if F = G. (Some programs return its root.) On a line it is twice the
// integral of (F - G)^2.

#include <cstddef>
#include <span>
#include <vector>

#include "talus/core/vec.hpp"

namespace talus {

/// Whose mean distance E|X - X'| a score subtracts. `sample`: that of the values themselves, which is too small for the
/// population that they were drawn from, by the factor 1 - 1/n. `population`: the unbiased estimate, so that scores of
/// samples of different sizes can be compared: C. A. T. Ferro, "Fair scores for ensemble forecasts", Quarterly Journal
/// of the Royal Meteorological Society 140 (2014) 1917-1923. It expects two values of positive weight, and a score may
/// then be negative.
enum class SpreadOf { sample, population };

/// The distribution of a finite sample of numbers.
class LineSample {
 public:
  /// Expects finite values, at least one, in any order; weights (or none, for equal ones) that are finite, not negative
  /// and not all zero. O(n log n).
  explicit LineSample(std::span<const double> values, std::span<const double> weights = {});

  /// In ascending order.
  [[nodiscard]] std::span<const double> values() const { return values_; }
  /// The share of values up to the value with this number, in [0, 1].
  [[nodiscard]] double share_up_to(std::size_t number) const { return shares_[number]; }
  /// The share of values up to `value`. O(log n).
  [[nodiscard]] double share_up_to_value(double value) const;
  /// E|X - X'|.
  [[nodiscard]] double spread(SpreadOf of = SpreadOf::sample) const;

 private:
  friend double crps(const LineSample& sample, double observed, SpreadOf spread);

  std::vector<double> values_, shares_;
  std::vector<double> below_, above_;  // integrals of F^2 up to each value and of (1 - F)^2 from it
  double squared_weights_ = 0;         // sum of the squares of weights that add up to 1
};

/// The continuous ranked probability score of an observed value. O(log n).
[[nodiscard]] double crps(const LineSample& sample, double observed, SpreadOf spread = SpreadOf::sample);
/// O(n + m).
[[nodiscard]] double energy_distance(const LineSample& a, const LineSample& b);
/// The statistic of Kolmogorov and Smirnov: the maximum of |F - G|, in [0, 1]. O(n + m).
[[nodiscard]] double kolmogorov_smirnov(const LineSample& a, const LineSample& b);

/// The distribution of a finite sample of points.
class PlaneSample {
 public:
  /// Expects as LineSample. O(n^2).
  explicit PlaneSample(std::vector<Vec2> points, std::span<const double> weights = {});

  [[nodiscard]] std::span<const Vec2> points() const { return points_; }
  /// Add up to 1.
  [[nodiscard]] std::span<const double> weights() const { return weights_; }
  /// E|X - X'|.
  [[nodiscard]] double spread(SpreadOf of = SpreadOf::sample) const;
  /// E|X - point|. O(n).
  [[nodiscard]] double mean_distance(const Vec2& point) const;

 private:
  std::vector<Vec2> points_;
  std::vector<double> weights_;
  double spread_ = 0, squared_weights_ = 0;
};

/// The energy score of an observed point. O(n).
[[nodiscard]] double energy_score(const PlaneSample& sample, const Vec2& observed, SpreadOf spread = SpreadOf::sample);
/// O(n m).
[[nodiscard]] double energy_distance(const PlaneSample& a, const PlaneSample& b);

}  // namespace talus
