#pragma once
// Tests whether draws come from a distribution; each returns a p-value. With the fixed seeds of the tests it is always
// the same.

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <functional>
#include <vector>

namespace talus::testing_tools {

/// The largest difference between the sample's distribution function and F.
inline double kolmogorov_distance(std::vector<double> draws, const std::function<double(double)>& F) {
  std::sort(draws.begin(), draws.end());
  const auto n = static_cast<double>(draws.size());
  double distance = 0;
  for (std::size_t i = 0; i < draws.size(); ++i) {
    const double f = F(draws[i]);
    distance = std::max({distance, static_cast<double>(i + 1) / n - f, f - static_cast<double>(i) / n});
  }
  return distance;
}

/// The probability of such a distance or a larger one by chance. Kolmogorov's series with Stephens' correction for
/// finite n (M. A. Stephens, JRSS B 32 (1970) 115-122), accurate to three digits from n = 5 on; for the 20,000 draws
/// and more of these tests to 1e-4.
inline double kolmogorov_probability(double distance, std::size_t count) {
  const double root = std::sqrt(static_cast<double>(count));
  const double x = (root + 0.12 + 0.11 / root) * distance;
  if (x < 0.3) return 1;  // within 1e-5; the series converges slowly there
  double sum = 0;
  for (int k = 1; k <= 100; ++k) sum += (k % 2 == 1 ? 2 : -2) * std::exp(-2.0 * k * k * x * x);
  return std::clamp(sum, 0.0, 1.0);
}

/// The probability of so large a chi-square of F(draw) (Pearson), in `cells` equally probable cells, by chance.
inline double chi_square_probability(const std::vector<double>& draws, const std::function<double(double)>& F,
                                     std::size_t cells) {
  std::vector<double> counts(cells);
  for (const double x : draws) {
    const double place = F(x) * static_cast<double>(cells);
    counts[std::min(static_cast<std::size_t>(std::max(place, 0.0)), cells - 1)] += 1;
  }
  const double expected = static_cast<double>(draws.size()) / static_cast<double>(cells);
  double sum = 0;
  for (const double count : counts) sum += (count - expected) * (count - expected) / expected;
  return cdf(complement(boost::math::chi_squared(static_cast<double>(cells - 1)), sum));
}

}  // namespace talus::testing_tools
