// The order in which a store keeps rocks: one of every 2^n neighbours, each with the same chance, without a pattern.

#include "talus/store/rock_choice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <vector>

namespace talus {
namespace {

/// The first `count` rocks of `rocks` in the order.
std::vector<std::uint64_t> first_rocks(std::uint64_t seed, std::uint64_t rocks, std::size_t count) {
  std::vector<std::uint64_t> order(rocks);
  std::iota(order.begin(), order.end(), std::uint64_t{0});
  std::ranges::sort(order, {}, [&](std::uint64_t rock) { return place_in_choice(seed, rock); });
  order.resize(count);
  std::ranges::sort(order);
  return order;
}

TEST(RockChoice, PlacesDiffer) {
  std::set<std::uint64_t> places;
  for (std::uint64_t rock = 0; rock < 100'000; ++rock) places.insert(place_in_choice(7, rock));
  EXPECT_EQ(places.size(), 100'000U);
}

TEST(RockChoice, HasOneOfEveryGroupOfNeighbours) {
  constexpr std::uint64_t rocks = 1 << 14;
  for (const unsigned rounds : {1U, 3U, 6U}) {
    const std::uint64_t group = std::uint64_t{1} << rounds;
    const auto chosen = first_rocks(5, rocks, rocks / group);
    for (std::size_t k = 0; k < chosen.size(); ++k) EXPECT_EQ(chosen[k] / group, k);
  }
}

/// Chi-squared over the places in groups of 8 that the chosen rocks have, which is 7 on average, with a standard
/// deviation of sqrt(14); of a choice of every eighth rock it is 7 times the number of groups.
double chi_squared(const std::vector<std::uint64_t>& chosen) {
  std::vector<double> counts(8);
  for (const std::uint64_t rock : chosen) ++counts[rock % 8];
  const double expected = static_cast<double>(chosen.size()) / 8;
  double sum = 0;
  for (const double count : counts) sum += (count - expected) * (count - expected) / expected;
  return sum;
}

TEST(RockChoice, EveryPlaceInAGroupHasTheSameChance) {
  constexpr std::uint64_t rocks = 1 << 16;
  const double most = 7 + 5 * std::sqrt(14);
  for (const std::uint64_t seed : {1U, 2U, 12345U}) EXPECT_LT(chi_squared(first_rocks(seed, rocks, rocks / 8)), most);
  std::vector<std::uint64_t> every_eighth(rocks / 8);
  for (std::size_t k = 0; k < every_eighth.size(); ++k) every_eighth[k] = 8 * k;
  EXPECT_GT(chi_squared(every_eighth), most) << "the comparison can fail";
}

TEST(RockChoice, HasNoPattern) {
  // Of rows of cells of any width, each column has its share.
  constexpr std::uint64_t rocks = 1 << 16;
  const auto chosen = first_rocks(3, rocks, rocks / 16);
  for (const std::uint64_t width : {3U, 16U, 21U, 34U, 64U, 100U}) {
    std::vector<double> counts(width);
    for (const std::uint64_t rock : chosen) ++counts[rock % width];
    const double expected = static_cast<double>(chosen.size()) / static_cast<double>(width);
    for (const double count : counts) EXPECT_LT(std::abs(count - expected), 5 * std::sqrt(expected)) << width;
  }
}

TEST(RockChoice, DependsOnTheSeed) { EXPECT_NE(first_rocks(1, 1000, 100), first_rocks(2, 1000, 100)); }

}  // namespace
}  // namespace talus
