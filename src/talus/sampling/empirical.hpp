#pragma once
// A distribution given by a sample: every draw is one of its values.

#include <cstddef>
#include <vector>

namespace talus {

/// The inverse of the empirical distribution function, a step function: with n values of equal weight, u in
/// ((k - 1) / n, k / n) gives the k-th smallest (definition 1 of R. J. Hyndman and Y. Fan, "Sample quantiles in
/// statistical packages", The American Statistician 50 (1996) 361-365). Nothing is interpolated, so that draws have
/// exactly the sample's mean, spread and gaps, and no value that was not measured.
class EmpiricalSample {
 public:
  struct Value {
    double value;
    double weight = 1;
  };
  /// Expects one finite value or more, with finite weights that are not negative, of which one is positive.
  explicit EmpiricalSample(std::vector<Value> values);

  /// The value for a uniform number in (0, 1). Increases with it.
  [[nodiscard]] double quantile(double u) const;
  [[nodiscard]] double least() const { return values_.front(); }
  [[nodiscard]] double most() const { return values_.back(); }
  [[nodiscard]] double mean() const;
  [[nodiscard]] std::size_t count() const { return values_.size(); }  // without values of weight 0
  [[nodiscard]] const std::vector<double>& values() const { return values_; }
  /// The sum of the weights up to each value; empty if all weights are equal.
  [[nodiscard]] const std::vector<double>& weights_up_to() const { return weights_up_to_; }

 private:
  std::vector<double> values_;  // ascending
  std::vector<double> weights_up_to_;
};

}  // namespace talus
