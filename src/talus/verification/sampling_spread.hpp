#pragma once
// Do published statistics of a small sample agree with ours of very many rocks?
//
// A table made from 50 draws of another program's generator has a sampling error of its own. So many samples of the
// table's size are drawn from our rocks, each is described as the table describes its own, and every published number
// has to lie within the central part of what those samples give. This is a bootstrap of the parent population (Efron
// and Tibshirani, An Introduction to the Bootstrap, 1993, chapter 6), valid as the rocks are many times the table's.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "talus/statistics/descriptive.hpp"

namespace talus::verification {

/// The rows of a table of descriptive statistics.
enum class Statistic {
  mean,
  standard_error,
  median,
  standard_deviation,
  sample_variance,
  kurtosis,
  skewness,
  range,
  minimum,
  maximum,
  sum,
  count,
  confidence_level_95
};
inline constexpr int statistic_count = 13;

[[nodiscard]] std::string_view name(Statistic statistic);
[[nodiscard]] std::optional<Statistic> statistic_of(std::string_view name);
/// Nothing where the sample was too small for it.
[[nodiscard]] std::optional<double> value(const Descriptive& rows, Statistic statistic);

struct Interval {
  double low = 0, high = 0;
  [[nodiscard]] bool contains(double x) const { return x >= low && x <= high; }
};

struct SpreadOptions {
  std::uint64_t samples = 4000;
  double central = 0.99;   // the share of the samples inside the interval
  std::uint64_t seed = 1;  // the same numbers every time
};

class SamplingSpread {
 public:
  /// Draws samples of `size` values, with replacement, from the values of many rocks. Expects values.
  SamplingSpread(std::span<const double> many, std::uint64_t size, const SpreadOptions& options = {});

  /// Where the central part of the samples has this statistic; nothing where too few samples have it at all.
  [[nodiscard]] std::optional<Interval> interval(Statistic statistic) const;
  /// The median of the samples: what a table of this size typically has.
  [[nodiscard]] std::optional<double> typical(Statistic statistic) const;

 private:
  [[nodiscard]] const std::vector<double>* enough(Statistic statistic) const;

  SpreadOptions options_;
  std::array<std::vector<double>, statistic_count> values_;  // ascending
};

/// Where the central part of counts lies if each of `trials` rocks does something with this probability: the quantiles
/// of the binomial distribution. Source: any textbook; a rock's hit is independent of the others'.
[[nodiscard]] Interval binomial_interval(std::uint64_t trials, double probability, double central = 0.99);

}  // namespace talus::verification
