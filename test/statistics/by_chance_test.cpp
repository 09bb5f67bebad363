#include "talus/statistics/by_chance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "support/dice.hpp"
#include "talus/statistics/order_statistics.hpp"
#include "talus/statistics/proper_scores.hpp"

namespace talus::by_chance_test {
namespace {

using testing_tools::Dice;

TEST(DrawMembers, IsAFunctionOfSeedAndDraw) {
  std::vector<std::size_t> few(5), many(9), other(9), later(9);
  draw_members(7, 3, 100, few);
  draw_members(7, 3, 100, many);
  draw_members(8, 3, 100, other);
  draw_members(7, 4, 100, later);
  EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
  EXPECT_NE(many, other);
  EXPECT_NE(many, later);
}

// Chi-squared over 10 members with 10,000 draws: 99.9 % of such sums are below 27.9.
TEST(DrawMembers, IsUniform) {
  std::vector<std::size_t> drawn(10'000);
  draw_members(1, 0, 10, drawn);
  std::vector<double> counts(10);
  for (const std::size_t member : drawn) counts.at(member) += 1;
  double chi_squared = 0;
  for (const double count : counts) chi_squared += (count - 1000) * (count - 1000) / 1000;
  EXPECT_LT(chi_squared, 27.9);
}

TEST(ByChance, CountsDrawsThatAreAsFar) {
  const ByChance chance = by_chance(3, {4, 1, 2, 3});
  EXPECT_DOUBLE_EQ(chance.p_value, 3.0 / 5);
  EXPECT_DOUBLE_EQ(chance.median, 2.5);
  EXPECT_DOUBLE_EQ(chance.p95, 3.85);
  EXPECT_EQ(chance.draws, 4U);
  EXPECT_DOUBLE_EQ(by_chance(5, {4, 1, 2, 3}).p_value, 1.0 / 5);
}

/// The p-value of the energy distance of 15 values from a population.
double p_value_of(const std::vector<double>& population, const std::vector<double>& sample, std::uint64_t seed) {
  const LineSample all(population);
  std::vector<double> distances, drawn(sample.size());
  std::vector<std::size_t> chosen(sample.size());
  for (std::uint64_t draw = 0; draw < 99; ++draw) {
    draw_members(seed, draw, population.size(), chosen);
    for (std::size_t k = 0; k < chosen.size(); ++k) drawn[k] = population[chosen[k]];
    distances.push_back(energy_distance(all, LineSample(drawn)));
  }
  return by_chance(energy_distance(all, LineSample(sample)), std::move(distances)).p_value;
}

// Samples of the same distribution have p-values up to 0.1 in a tenth of the cases, within the bounds of the binomial
// distribution at 99.9 %; samples that are shifted by one standard deviation nearly always.
TEST(ByChance, RejectsAsOftenAsItSays) {
  Dice dice(17);
  const auto draw = [&](double shift) {
    return shift + std::sqrt(-2 * std::log(1 - dice.unit())) * std::cos(2 * std::numbers::pi * dice.unit());
  };
  std::vector<double> population;
  for (int k = 0; k < 1500; ++k) population.push_back(draw(0));
  constexpr std::uint64_t rounds = 300;
  std::uint64_t rejected = 0, rejected_shifted = 0;
  for (std::uint64_t round = 0; round < rounds; ++round) {
    std::vector<double> same, shifted;
    for (int k = 0; k < 15; ++k) same.push_back(draw(0)), shifted.push_back(draw(1));
    rejected += p_value_of(population, same, round) <= 0.1 ? 1 : 0;
    rejected_shifted += p_value_of(population, shifted, round) <= 0.1 ? 1 : 0;
  }
  const ShareBounds bounds = share_bounds(rejected, rounds, 0.999);
  EXPECT_LT(bounds.low, 0.1);
  EXPECT_GT(bounds.high, 0.1);
  EXPECT_GT(share_bounds(rejected_shifted, rounds, 0.999).low, 0.85);
}

}  // namespace
}  // namespace talus::by_chance_test
