#include "talus/statistics/binomial.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace talus::binomial_test {
namespace {

double probability_between(int n, double p, int low, int high) {
  double sum = 0;
  for (int k = low; k <= high; ++k) {
    sum += std::exp(std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0) + k * std::log(p) +
                    (n - k) * std::log(1 - p));
  }
  return sum;
}

TEST(CentralCounts, AreAtMostOneCountTooWide) {
  for (const int n : {1, 5, 39, 40, 400}) {
    for (const double p : {0.5, 0.9}) {
      const auto [low, high] = central_counts(static_cast<std::uint64_t>(n), p, 0.95);
      const int least = static_cast<int>(low), most = static_cast<int>(high);
      EXPECT_EQ(low, least);
      EXPECT_EQ(high, most);
      EXPECT_GE(probability_between(n, p, least, most), 0.95);
      // One count further in on either side, more than 2.5 % would be outside.
      EXPECT_GT(probability_between(n, p, 0, least + 1), 0.025);
      EXPECT_GT(probability_between(n, p, most - 1, n), 0.025);
    }
  }
}

}  // namespace
}  // namespace talus::binomial_test
