#include "talus/statistics/exact_sum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace talus::exact_sum_test {
namespace {

ExactSum sum_of(const std::vector<double>& terms) {
  ExactSum sum;
  for (const double term : terms) sum.add(term);
  return sum;
}

// Terms of all magnitudes of a double, with both signs.
std::vector<double> wild_terms(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 bits(seed);
  std::vector<double> terms;
  while (terms.size() < count) {
    const auto term = std::bit_cast<double>(bits());
    if (std::isfinite(term)) terms.push_back(term / 65536);  // so that the sum is finite
  }
  return terms;
}

TEST(ExactSum, OfNothingIsZero) {
  EXPECT_EQ(ExactSum().value(), 0);
  EXPECT_FALSE(std::signbit(ExactSum().value()));
  EXPECT_EQ(sum_of({-0.0}).value(), 0);
}

TEST(ExactSum, OfOneTermIsTheTerm) {
  const double largest = std::numeric_limits<double>::max(), least_normal = std::numeric_limits<double>::min();
  const double least = std::numeric_limits<double>::denorm_min();
  for (const double term : {1.0, 0.1, 1e300, largest, least_normal, least, 3 * least, least_normal - least, 0x1p52,
                            0x1p31, 0x1p32, 0x1p33, 1 + 0x1p-52}) {
    EXPECT_EQ(sum_of({term}).value(), term);
    EXPECT_EQ(sum_of({-term}).value(), -term);
  }
  for (const double term : wild_terms(20'000, 5)) ASSERT_EQ(sum_of({term}).value(), term);
}

TEST(ExactSum, SurvivesCatastrophicCancellation) {
  EXPECT_EQ(sum_of({1e308, 1, -1e308}).value(), 1);
  EXPECT_EQ(sum_of({1, 1e100, 1, -1e100}).value(), 2);
  EXPECT_EQ(sum_of({1e16, 1, -1e16, 0x1p-1074}).value(), 1);
  EXPECT_EQ(sum_of({1e308, 1e308, -1e308, -1e308, 0x1p-1074}).value(), 0x1p-1074) << "passes through 2e308";
  // S. M. Rump's: plain summation in double gives -1.18e21.
  EXPECT_EQ(sum_of({0x1p120, 3, -0x1p120, 0x1p-60, -3, -0x1p-60}).value(), 0);
}

TEST(ExactSum, RoundsToNearestAndTiesToEven) {
  const double ulp = 0x1p-52;
  EXPECT_EQ(sum_of({1, ulp / 2}).value(), 1) << "a tie goes to the even one, here down";
  EXPECT_EQ(sum_of({1 + ulp, ulp / 2}).value(), 1 + 2 * ulp) << "a tie goes to the even one, here up";
  EXPECT_EQ(sum_of({1, ulp / 2, 0x1p-1074}).value(), 1 + ulp) << "one bit a thousand places down breaks the tie";
  EXPECT_EQ(sum_of({1, ulp / 2, -0x1p-1074}).value(), 1);
  EXPECT_EQ(sum_of({-1, -ulp / 2, -0x1p-1074}).value(), -1 - ulp);
  EXPECT_EQ(sum_of({2 - ulp, ulp / 2}).value(), 2) << "rounding up may carry through all bits";
}

TEST(ExactSum, BeyondTheLargestDoubleIsInfinite) {
  const double largest = std::numeric_limits<double>::max();
  EXPECT_EQ(sum_of({largest, largest}).value(), HUGE_VAL);
  EXPECT_EQ(sum_of({-largest, -largest}).value(), -HUGE_VAL);
  EXPECT_EQ(sum_of({largest, 0x1p970}).value(), HUGE_VAL) << "half a unit in the last place rounds to even, up";
  EXPECT_EQ(sum_of({largest, 0x1p969}).value(), largest);
}

TEST(ExactSum, IsTheSameInAnyOrder) {
  std::vector<double> terms = wild_terms(3000, 1);
  const ExactSum first = sum_of(terms);
  std::mt19937_64 shuffler(2);
  for (int i = 0; i < 30; ++i) {
    std::shuffle(terms.begin(), terms.end(), shuffler);
    const ExactSum sum = sum_of(terms);
    ASSERT_TRUE(sum == first);
    ASSERT_EQ(sum.value(), first.value());
  }
  EXPECT_NE(std::accumulate(terms.begin(), terms.end(), 0.0), first.value()) << "which plain addition does not do";
}

TEST(ExactSum, IsTheSameForAnySplit) {
  const std::vector<double> terms = wild_terms(5000, 3);
  const ExactSum whole = sum_of(terms);
  std::mt19937_64 chooser(4);
  for (const std::size_t parts : {2u, 3u, 8u, 100u}) {
    std::vector<ExactSum> sums(parts);
    for (const double term : terms) sums[chooser() % parts].add(term);
    std::shuffle(sums.begin(), sums.end(), chooser);
    ExactSum merged;
    for (const ExactSum& sum : sums) merged.merge(sum);
    ASSERT_TRUE(merged == whole) << parts;
    ASSERT_EQ(merged.value(), whole.value());
  }
}

TEST(ExactSum, IsZeroAgainAfterEveryTermIsSubtracted) {
  std::vector<double> terms = wild_terms(2000, 6);
  for (std::size_t i = 0; i < 2000; ++i) terms.push_back(-terms[i]);
  std::mt19937_64 shuffler(7);
  std::shuffle(terms.begin(), terms.end(), shuffler);
  EXPECT_TRUE(sum_of(terms) == ExactSum());
  EXPECT_EQ(sum_of(terms).value(), 0);
}

TEST(ExactSum, DistinguishesDifferentSums) {
  EXPECT_FALSE(sum_of({1e300}) == sum_of({1e300, 0x1p-1074})) << "though both round to the same double";
}

TEST(ExactSum, AgreesWithIntegersOverMillionsOfTerms) {
  // Multiples of 2^-20 below 2^11 in size: the sum of 3,000,000 fits in a 64-bit integer.
  std::mt19937_64 bits(8);
  ExactSum sum;
  std::int64_t integer = 0;
  for (int i = 0; i < 3'000'000; ++i) {
    const std::int64_t term = static_cast<std::int64_t>(bits() >> 32) - (std::int64_t{1} << 31) + 1000;
    integer += term;
    sum.add(static_cast<double>(term) * 0x1p-20);
  }
  EXPECT_EQ(sum.value(), static_cast<double>(integer) * 0x1p-20);
}

// Merging doubles the number of terms: 2^70 of them without adding one by one, far beyond the capacity of the limbs.
TEST(ExactSum, CarriesManyTerms) {
  ExactSum ones = sum_of({1}), minus = sum_of({-1});
  for (int i = 0; i < 70; ++i) {
    ones.merge(ExactSum(ones));
    minus.merge(ExactSum(minus));
  }
  EXPECT_EQ(ones.value(), 0x1p70);
  EXPECT_EQ(minus.value(), -0x1p70);
}

TEST(ExactSum, HasLeadingPartsWithMoreBitsThanADouble) {
  const auto parts = sum_of({1e40, 1, -0x1p-70, 0x1p-900}).leading();
  EXPECT_EQ(parts[0], 1e40);
  EXPECT_EQ(parts[1], 1);
  EXPECT_EQ(parts[2], -0x1p-70);
  EXPECT_EQ(parts[3], 0x1p-900);
  EXPECT_EQ(parts[4], 0);
}

}  // namespace
}  // namespace talus::exact_sum_test
