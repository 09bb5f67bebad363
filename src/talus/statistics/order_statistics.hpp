#pragma once
// Confidence intervals of a quantile and of a share, without assumptions about the distribution.
//
// Of n independent values the number B below the quantile p of a continuous distribution is binomial (n, p). So the
// order statistic of zero-based rank r is above that quantile with probability P(B <= r), and below it with P(B > r):
// H. A. David and H. N. Nagaraja, Order Statistics, 3rd ed. (2003), section 7.1; G. J. Hahn and W. Q. Meeker,
// Statistical Intervals (1991), section 5.2. Each end is wrong with a probability of at most (1 - confidence)/2, so
// that the upper end alone has a confidence of (1 + confidence)/2.

#include <cstdint>
#include <optional>
#include <vector>

#include "talus/statistics/quantile_sketch.hpp"

namespace talus {

/// Zero-based ranks of the order statistics between which the quantile is. An end is empty if the sample is too small
/// for it: an upper end for the quantile p needs p^n <= (1 - confidence)/2. With 95 % that takes 72 values for p = 0.95
/// and 368 for 0.99.
struct RankBounds {
  std::optional<std::uint64_t> low, high;
};

/// Expects p in [0, 1], confidence in (0, 1).
[[nodiscard]] RankBounds quantile_rank_bounds(double p, std::uint64_t count, double confidence);

struct ShareBounds {
  double low, high;
};

/// Confidence interval of the probability behind `hits` in `trials`, at least one: C. J. Clopper and E. S. Pearson,
/// "The use of confidence or fiducial limits illustrated in the case of the binomial", Biometrika 26 (1934) 404-413.
[[nodiscard]] ShareBounds share_bounds(std::uint64_t hits, std::uint64_t trials, double confidence);

/// An estimate and its confidence interval; an end is empty if the sample is too small for it.
struct Estimate {
  double value = 0;
  std::optional<double> low, high;
  friend bool operator==(const Estimate&, const Estimate&) = default;
};

/// The values of a sketch in ascending order, sorted once for many queries.
class RankedValues {
 public:
  /// Expects at least one value. The sketch must outlive it.
  explicit RankedValues(const QuantileSketch& sketch);

  /// The value of a zero-based rank.
  [[nodiscard]] double at(std::uint64_t rank) const;
  /// As QuantileSketch::quantile().
  [[nodiscard]] double quantile(double p) const;
  /// The quantile and its interval. Definition 7 interpolates between the values. With few values it can therefore fall
  /// outside the interval: with two values for p = 0.99 even the maximum is below the quantile at this confidence, and
  /// the interpolated value is lower still. Then the estimate is that end of the interval, here the maximum; likewise
  /// at the lower end.
  [[nodiscard]] Estimate estimate(double p, double confidence) const;

 private:
  std::uint64_t count_;
  double minimum_, maximum_;
  std::vector<QuantileSketch::Counted> up_to_;  // each value with the number of values up to it
};

}  // namespace talus
