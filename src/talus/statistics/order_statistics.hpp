#pragma once
// How well a sample knows a quantile, and a share: confidence intervals that assume nothing of the distribution.
//
// Of n independent values the number B below the quantile p of a continuous distribution is binomial (n, p). So the
// order statistic of rank r (from 0) lies above that quantile with probability P(B <= r), and below it with P(B > r):
// H. A. David and H. N. Nagaraja, Order Statistics, 3rd ed. (2003), section 7.1; G. J. Hahn and W. Q. Meeker,
// Statistical Intervals (1991), section 5.2. Each end errs with at most half of what the confidence leaves, so that the
// upper end alone holds with (1 + confidence)/2.

#include <cstdint>
#include <optional>
#include <vector>

#include "talus/statistics/quantile_sketch.hpp"

namespace talus {

/// Ranks, from 0, of the order statistics between which the quantile lies. Nothing where the sample is too small for an
/// end: one above the quantile p needs p^n <= (1 - confidence)/2, with 95 % thus 72 values for p = 0.95 and 368 for
/// 0.99.
struct RankBounds {
  std::optional<std::uint64_t> low, high;
};

/// Expects p in [0, 1], confidence in (0, 1).
[[nodiscard]] RankBounds quantile_rank_bounds(double p, std::uint64_t count, double confidence);

struct ShareBounds {
  double low, high;
};

/// Of the probability behind `hits` among `trials`, at least one: C. J. Clopper and E. S. Pearson, "The use of
/// confidence or fiducial limits illustrated in the case of the binomial", Biometrika 26 (1934) 404-413.
[[nodiscard]] ShareBounds share_bounds(std::uint64_t hits, std::uint64_t trials, double confidence);

/// An estimate and its confidence interval; an end that the sample is too small for is empty.
struct Estimate {
  double value = 0;
  std::optional<double> low, high;
  friend bool operator==(const Estimate&, const Estimate&) = default;
};

/// The values of a sketch in ascending order, put into order once for many questions.
class RankedValues {
 public:
  /// Expects at least one value. The sketch must outlive it.
  explicit RankedValues(const QuantileSketch& sketch);

  /// Of rank `rank`, from 0.
  [[nodiscard]] double at(std::uint64_t rank) const;
  /// As QuantileSketch::quantile().
  [[nodiscard]] double quantile(double p) const;
  /// The quantile and its interval. Definition 7 looks for it among the values alone: where these are so few that even
  /// the greatest lies below it with this confidence (two values for p = 0.99), it interpolates to less than that. Then
  /// the estimate is the end of the interval, which is the greatest value; likewise at the other end.
  [[nodiscard]] Estimate estimate(double p, double confidence) const;

 private:
  std::uint64_t count_;
  double minimum_, maximum_;
  std::vector<QuantileSketch::Counted> up_to_;  // each value with how many are at most as large
};

}  // namespace talus
