#pragma once
// The thirteen rows of a spreadsheet's descriptive statistics, from a sample or from running sums.

#include <cstdint>
#include <optional>
#include <span>

#include "talus/core/bytes.hpp"
#include "talus/statistics/exact_sum.hpp"

namespace talus {

/// Empty if the sample is too small. All are of the sample kind (n - 1), as in the RocFall verification manual:
///  - sample variance s2 = sum (x - mean)^2 / (n - 1); standard error s / sqrt(n);
///  - skewness G1 and excess kurtosis G2, bias-corrected: D. N. Joanes and C. A. Gill, "Comparing measures of sample
///    skewness and kurtosis", The Statistician 47 (1998) 183-189; spreadsheets' SKEW and KURT. They need three and four
///    values that are not all equal;
///  - the half-width of the 95 % confidence interval of the mean by Student's t with n - 1 degrees of freedom.
/// Units: those of the values; the variance's squared; skewness and kurtosis have none.
struct Descriptive {
  std::optional<double> mean;
  std::optional<double> standard_error;
  std::optional<double> median;
  std::optional<double> standard_deviation;
  std::optional<double> sample_variance;
  std::optional<double> kurtosis;
  std::optional<double> skewness;
  std::optional<double> range;
  std::optional<double> minimum;
  std::optional<double> maximum;
  double sum = 0;
  std::uint64_t count = 0;
  std::optional<double> confidence_half_width_95;
};

/// Running sums of x, x^2, x^3 and x^4, and the extremes: enough for all rows but the median. Powers and sums are
/// exact. So values far from zero with a small spread lose nothing (coordinates of 2.6e6 m that differ by micrometres
/// keep their kurtosis), no reference value has to be chosen, and the order does not matter.
class Moments {
 public:
  /// Expects |x| < 1e75, so that its fourth power is finite. Below 1e-60 the powers lose digits under 1e-300.
  void add(double x);
  void merge(const Moments& other);
  void save(ByteWriter& out) const;
  /// Adds saved moments; throws BadBytes on anything else.
  void merge_saved(ByteReader& in);

  [[nodiscard]] std::uint64_t count() const { return count_; }
  /// All rows. The sums do not give the median: the caller passes it, or it stays empty.
  [[nodiscard]] Descriptive describe(std::optional<double> median = {}) const;

 private:
  ExactSum first_, second_, third_, fourth_;
  double minimum_ = 0, maximum_ = 0;  // valid if count is not 0
  std::uint64_t count_ = 0;
};

/// All rows of a sample, in any order.
[[nodiscard]] Descriptive describe(std::span<const double> sample);

/// The factor of the standard error in a 95 % confidence interval: Student's t at 0.975. Expects at least one degree of
/// freedom.
[[nodiscard]] double student_t_975(std::uint64_t degrees_of_freedom);

}  // namespace talus
