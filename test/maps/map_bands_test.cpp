// Ranges between ensembles in a cell of maps.

#include "talus/maps/map_bands.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <vector>

#include "support/dice.hpp"
#include "talus/maps/map_cells.hpp"

namespace talus {
namespace {

const MapGrid unit_grid({0, 0}, 1, {});
const MapContents counts_alone{MapContents::Choice{}, MapContents::Choice{}};

/// `passages` of `rocks` rocks were in cell (0, 0).
Maps maps_of(std::uint64_t rocks, std::uint64_t passages) {
  Maps maps(unit_grid, counts_alone);
  const std::vector<MapVisit> visits(1);
  const std::vector<std::span<const MapVisit>> by_rock(passages, std::span(visits));
  maps.add(rocks, by_rock);
  return maps;
}

/// Calls work(cell) with the cell (0, 0) of ensembles of `rocks` rocks each.
template <class Work>
auto with_cell(std::uint64_t rocks, const std::vector<std::uint64_t>& passages, Work&& work) {
  std::uint64_t sum = 0;
  std::vector<Maps> ensembles;
  for (const std::uint64_t each : passages) {
    sum += each;
    ensembles.push_back(maps_of(rocks, each));
  }
  const Maps all = maps_of(rocks * passages.size(), sum);
  MapCells cells({all, ensembles}, true);
  cells.enter(*all.tiles().front());
  EXPECT_FALSE(cells.find(1, 0));
  return work(*cells.find(0, 0));
}

double part_of(std::uint64_t rocks, const std::vector<std::uint64_t>& passages) {
  return with_cell(rocks, passages, parameter_part_of_reach);
}

std::array<double, 2> band_of(const std::vector<std::uint64_t>& passages) {
  return with_cell(100, passages, [](const MapCellTallies& cell) {
    std::array<double, 2> ends{};
    const MapCellValues share = [](const MapTally& tally, std::uint64_t rocks, std::span<double> out) {
      out[0] = static_cast<double>(tally.passages()) / static_cast<double>(rocks);
    };
    band_values(cell, share, 1, ends);
    return ends;
  });
}

/// The number of `rocks` rocks that come, each with the same probability.
std::uint64_t binomial(testing_tools::Dice& dice, std::uint64_t rocks, double probability) {
  std::uint64_t count = 0;
  for (std::uint64_t k = 0; k < rocks; ++k) count += dice.chance(probability) ? 1 : 0;
  return count;
}

// Probabilities of 0.3 and 0.5 have a variance of 0.01; shares of 40 rocks on average (0.21 + 0.25) / 2 / 40 = 0.00575.
TEST(MapBands, TellThePartOfTheParametersByTheLawOfTotalVariance) {
  testing_tools::Dice dice(3);
  std::vector<std::uint64_t> differ, same;
  for (int k = 0; k < 3000; ++k) {
    differ.push_back(binomial(dice, 40, k % 2 == 0 ? 0.3 : 0.5));
    same.push_back(binomial(dice, 40, 0.4));
  }
  // The standard error of a variance of 3000 nearly normal values is 2.6 %.
  EXPECT_NEAR(part_of(40, differ), 0.01 / 0.01575, 0.03);
  EXPECT_LT(part_of(40, same), 0.08);
  EXPECT_EQ(part_of(40, {0, 40, 0, 40, 0, 40}), 1) << "without chance";
  EXPECT_EQ(part_of(40, {20, 20, 21}), 0) << "less than by chance";
  EXPECT_TRUE(std::isnan(part_of(40, {20, 20, 20}))) << "no variance";
  EXPECT_TRUE(std::isnan(part_of(1, {1, 0, 1}))) << "chance of one rock is not known";
}

TEST(MapBands, AreQuantilesWithEnsemblesWithoutARockAsZero) {
  EXPECT_DOUBLE_EQ(band_of({10, 20, 30, 40, 50})[0], 0.12);
  EXPECT_DOUBLE_EQ(band_of({50, 10, 40, 20, 30})[1], 0.48);
  EXPECT_DOUBLE_EQ(band_of({0, 20, 30, 40, 50})[0], 0.04) << "a fifth of the way from 0 to 0.2";
  EXPECT_TRUE(std::isnan(band_of({0, 0, 30, 40, 50})[0]));
  EXPECT_DOUBLE_EQ(band_of({0, 0, 0, 0, 50})[1], 0.4);
  std::vector<std::uint64_t> rare(50, 0);
  rare[7] = 100;
  EXPECT_TRUE(std::isnan(band_of(rare)[1])) << "one of fifty is less than one in twenty";
}

}  // namespace
}  // namespace talus
