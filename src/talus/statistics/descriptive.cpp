#include "talus/statistics/descriptive.hpp"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <vector>

#include "talus/core/check.hpp"
#include "talus/statistics/quantile.hpp"

namespace talus {

namespace {

// 237 bits: central moments are small differences of large sums. Used once for a table, never for each rock.
using Long = boost::multiprecision::cpp_bin_float_oct;

Long as_long(const ExactSum& sum) {
  Long value = 0;
  for (const double part : sum.leading()) value += part;
  return value;
}

// A product of doubles as two: the rounded product and its rounding error, which the fma finds (Dekker 1971).
struct Product {
  double rounded, lost;
  Product(double x, double y) : rounded(x * y), lost(std::fma(x, y, -rounded)) {}
};

void add(ExactSum& sum, Product product) {
  sum.add(product.rounded);
  sum.add(product.lost);
}

}  // namespace

void Moments::add(double x) {
  TALUS_PROMISE(std::abs(x) < 1e75, "the fourth power of a value must be finite");
  x += 0.0;  // turns -0 into 0: extremes must not depend on which came first
  // Without rounding: x^2 = a + b, x^3 = a x + b x, x^4 = a^2 + 2 a b + b^2.
  const Product square(x, x);
  const double a = square.rounded, b = square.lost;
  first_.add(x);
  talus::add(second_, square);
  talus::add(third_, {a, x});
  talus::add(third_, {b, x});
  talus::add(fourth_, {a, a});
  talus::add(fourth_, {2 * a, b});
  talus::add(fourth_, {b, b});
  minimum_ = count_ == 0 ? x : std::min(minimum_, x);
  maximum_ = count_ == 0 ? x : std::max(maximum_, x);
  ++count_;
}

void Moments::merge(const Moments& other) {
  if (other.count_ == 0) return;
  first_.merge(other.first_);
  second_.merge(other.second_);
  third_.merge(other.third_);
  fourth_.merge(other.fourth_);
  minimum_ = count_ == 0 ? other.minimum_ : std::min(minimum_, other.minimum_);
  maximum_ = count_ == 0 ? other.maximum_ : std::max(maximum_, other.maximum_);
  count_ += other.count_;
}

void Moments::save(ByteWriter& out) const {
  out.put(count_);
  out.put(minimum_);
  out.put(maximum_);
  for (const ExactSum* sum : {&first_, &second_, &third_, &fourth_}) sum->save(out);
}

void Moments::merge_saved(ByteReader& in) {
  Moments saved;
  saved.count_ = in.get<std::uint64_t>();
  saved.minimum_ = in.get<double>();
  saved.maximum_ = in.get<double>();
  for (ExactSum* sum : {&saved.first_, &saved.second_, &saved.third_, &saved.fourth_}) sum->merge_saved(in);
  expect_bytes(std::isfinite(saved.minimum_) && std::isfinite(saved.maximum_) && saved.minimum_ <= saved.maximum_,
               "the extremes of a quantity are damaged");
  merge(saved);
}

Descriptive Moments::describe(std::optional<double> median) const {
  Descriptive rows;
  rows.count = count_;
  if (count_ == 0) return rows;
  const Long n = count_;
  const Long mean = as_long(first_) / n;
  rows.mean = static_cast<double>(mean);
  rows.median = median;
  rows.sum = first_.value();
  rows.minimum = minimum_;
  rows.maximum = maximum_;
  rows.range = maximum_ - minimum_;
  if (count_ < 2) return rows;

  const bool is_constant = minimum_ == maximum_;
  const Long mean2 = mean * mean;
  const Long second = as_long(second_), third = as_long(third_);
  // Sums of (x - mean)^k.
  const Long m2 = is_constant ? Long(0) : Long(second - n * mean2);
  const Long variance = m2 / (n - 1);
  rows.sample_variance = static_cast<double>(variance);
  rows.standard_deviation = static_cast<double>(Long(sqrt(variance)));
  rows.standard_error = static_cast<double>(Long(sqrt(Long(variance / n))));
  rows.confidence_half_width_95 = student_t_975(count_ - 1) * *rows.standard_error;
  if (is_constant || variance <= 0) return rows;

  if (count_ >= 3) {
    const Long m3 = third - 3 * mean * second + 2 * n * mean2 * mean;
    rows.skewness = static_cast<double>(Long(n / ((n - 1) * (n - 2)) * m3 / (variance * sqrt(variance))));
  }
  if (count_ >= 4) {
    const Long m4 = as_long(fourth_) - 4 * mean * third + 6 * mean2 * second - 3 * n * mean2 * mean2;
    rows.kurtosis = static_cast<double>(Long(n * (n + 1) / ((n - 1) * (n - 2) * (n - 3)) * m4 / (variance * variance) -
                                             3 * (n - 1) * (n - 1) / ((n - 2) * (n - 3))));
  }
  return rows;
}

Descriptive describe(std::span<const double> sample) {
  if (sample.empty()) return {};
  Moments moments;
  for (const double x : sample) moments.add(x);
  std::vector<double> values(sample.begin(), sample.end());
  const auto [rank, fraction] = quantile_place(0.5, values.size());
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), middle, values.end());
  const double low = *middle;
  const double high = fraction > 0 ? *std::min_element(middle + 1, values.end()) : low;
  return moments.describe(between(low, high, fraction));
}

double student_t_975(std::uint64_t degrees_of_freedom) {
  TALUS_PROMISE(degrees_of_freedom > 0, "one value has no spread");
  return quantile(boost::math::students_t(static_cast<double>(degrees_of_freedom)), 0.975);
}

}  // namespace talus
