#pragma once
// Whether published statistics of a small sample agree with ours of very many rocks.
//
// A table of 50 draws from another program's generator has a sampling error. Therefore, many samples of the same size
// are drawn from our rocks and described by the same statistics, and every published number has to lie within the
// central part of theirs. This is a bootstrap of the parent population (Efron and Tibshirani, An Introduction to the
// Bootstrap, 1993, chapter 6), valid because there are many times more rocks than in the table.

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
/// nullopt if the sample was too small for it.
[[nodiscard]] std::optional<double> value(const Descriptive& rows, Statistic statistic);

struct Interval {
  double low = 0, high = 0;
  [[nodiscard]] bool contains(double x) const { return x >= low && x <= high; }
};

struct SpreadOptions {
  std::uint64_t samples = 4000;
  double central = 0.99;   // share of the samples inside the interval
  std::uint64_t seed = 1;  // fixed, for reproducible numbers
};

class SamplingSpread {
 public:
  /// Draws samples of `size` values, with replacement, from the values of many rocks. Expects at least one value.
  SamplingSpread(std::span<const double> many, std::uint64_t size, const SpreadOptions& options = {});

  /// The central interval of the statistic over the samples; nullopt if too few samples have it.
  [[nodiscard]] std::optional<Interval> interval(Statistic statistic) const;
  /// The median of the statistic over the samples: a typical value for a table of this size.
  [[nodiscard]] std::optional<double> typical(Statistic statistic) const;

 private:
  [[nodiscard]] const std::vector<double>* values_if_enough(Statistic statistic) const;

  SpreadOptions options_;
  std::array<std::vector<double>, statistic_count> values_;  // ascending
};

/// The central interval of the number of successes in `trials` independent trials with this probability: quantiles of
/// the binomial distribution (any textbook).
[[nodiscard]] Interval binomial_interval(std::uint64_t trials, double probability, double central = 0.99);

}  // namespace talus::verification
