#include "talus/statistics/fixed_sum.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "support/dice.hpp"

namespace talus::fixed_sum_test {
namespace {

using testing_tools::Dice;

TEST(FixedSum, AddsWholeNumbersExactly) {
  FixedSum sum;
  double expected = 0;
  for (int k = 1; k <= 1000; ++k) {
    sum.add(k);
    expected += k;
  }
  EXPECT_EQ(sum.value(), expected);
}

TEST(FixedSum, TruncatesToItsUnit) {
  FixedSum sum;
  sum.add(0x1p-24);
  sum.add(0x1.8p-25);
  EXPECT_EQ(sum.value(), 0x1p-24);
}

TEST(FixedSum, CarriesFromOneWordToTheOther) {
  FixedSum sum;
  for (int k = 0; k < 64; ++k) sum.add(0x1p39);  // 2^63 units each
  EXPECT_EQ(sum.value(), 0x1p45);
  sum.add(FixedSum::largest_term);
  EXPECT_EQ(sum.value(), 0x1p70 + 0x1p45);
}

TEST(FixedSum, DoesNotDependOnOrderOrSplit) {
  Dice dice(3);
  std::vector<double> terms(5000);
  for (double& term : terms) term = dice.magnitude(1e-9, 1e18);
  FixedSum whole;
  double rounded = 0;
  for (const double term : terms) {
    whole.add(term);
    rounded += term;
  }
  EXPECT_NEAR(whole.value(), rounded, 1e-9 * rounded);
  for (int trial = 0; trial < 10; ++trial) {
    std::vector<FixedSum> parts(4);
    for (std::size_t k = terms.size(); k-- > 0;) parts[dice.below(4)].add(terms[k]);
    FixedSum merged;
    for (const FixedSum& part : parts) merged.merge(part);
    EXPECT_EQ(merged, whole);
  }
}

}  // namespace
}  // namespace talus::fixed_sum_test
