// The order in which places release rocks: quotas, even spread of any first part, no bias over seeds.

#include "talus/seeding/release_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <vector>

#include "support/dice.hpp"
#include "talus/seeding/hilbert_curve.hpp"
#include "talus/seeding/seeder.hpp"

namespace talus::release_order_test {
namespace {

using namespace testing_tools;

TEST(ReleaseOrder, GivesEveryPlaceItsTurnBeforeAnyHasItsNext) {
  Dice dice(17);
  for (int round = 0; round < 300; ++round) {
    ReleaseOrder order{.first_rock = dice.below(50), .rocks = 1 + dice.below(2000), .rocks_at_once = 1 + dice.below(5)};
    order.places = 1 + dice.below(300);
    order.step = even_step(order.places);
    order.start = dice.below(order.places);
    std::vector<std::uint64_t> of_place(order.places);
    for (std::uint64_t turn = 0; turn < order.turns(); ++turn) {
      const std::uint64_t place = order.place_of_turn(turn);
      ASSERT_LT(place, order.places);
      ++of_place[place];
      const auto [least, most] = std::ranges::minmax(of_place);
      ASSERT_LE(most - least, 1u) << order.places << " places, turn " << turn;
    }
  }
}

TEST(ReleaseOrder, CountsTheRocksOfPlacesInAdvance) {
  Dice dice(18);
  for (int round = 0; round < 300; ++round) {
    ReleaseOrder order{.first_rock = 7, .rocks = 1 + dice.below(400), .rocks_at_once = 1 + dice.below(4)};
    order.places = 1 + dice.below(60);
    order.step = even_step(order.places);
    order.start = dice.below(order.places);
    const std::uint64_t begin = dice.below(order.places + 1), end = begin + dice.below(order.places + 1 - begin);
    const std::uint64_t released = dice.below(order.rocks + 1);
    std::uint64_t count = 0;
    for (std::uint64_t rock = 7; rock < 7 + released; ++rock)
      count += order.place_of(rock) >= begin && order.place_of(rock) < end ? 1 : 0;
    ASSERT_EQ(order.rocks_from(begin, end, released), count);
  }
}

TEST(ReleaseOrder, ProductsBeyond64BitsDoNotOverflow) {
  constexpr std::uint64_t places = 1'000'000'000'000;
  const ReleaseOrder order{.rocks = places, .places = places, .step = even_step(places), .start = places - 1};
  EXPECT_EQ(order.place_of(1), order.step - 1);
  // The last turn is one step before the first.
  EXPECT_EQ((order.place_of(places - 1) + order.step) % places, order.start);
  EXPECT_EQ(order.rocks_from(0, places, places), places);
  EXPECT_EQ(order.rocks_from(5, 6, places), 1u);
}

/// The largest difference, over all intervals from 0, between the turns there and their share of the first n.
double discrepancy(const ReleaseOrder& order, std::uint64_t n) {
  std::vector<std::uint64_t> places;
  for (std::uint64_t turn = 0; turn < n; ++turn) places.push_back(order.place_of_turn(turn));
  std::ranges::sort(places);
  double most = 0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const double share = static_cast<double>(n * places[k]) / static_cast<double>(order.places);
    most = std::max({most, std::abs(static_cast<double>(k) - share), std::abs(static_cast<double>(k + 1) - share)});
  }
  return most;
}

// A lattice with partial quotients of at most A has a discrepancy of about A log n turns; places in their order have
// one of up to n.
TEST(EvenStep, SpreadsAnyFirstTurnsOverAllPlaces) {
  for (const std::uint64_t places : {2u, 3u, 10u, 97u, 100u, 1000u, 4096u, 9973u, 10'000u, 123'456u}) {
    ReleaseOrder order{.places = places, .step = even_step(places)};
    EXPECT_EQ(std::gcd(order.step, places), 1u) << places;
    for (std::uint64_t n = 1; n <= std::min<std::uint64_t>(places, 20'000); n = n * 3 / 2 + 1)
      EXPECT_LT(discrepancy(order, n), 3 + std::log2(static_cast<double>(n))) << n << " of " << places;
  }
  EXPECT_GT(discrepancy({.places = 10'000, .step = 1}, 500), 400);
}

TEST(HilbertCurve, GoesFromNeighbourToNeighbour) {
  std::vector<std::pair<std::uint64_t, std::array<int, 2>>> cells;
  for (int row = 0; row < 16; ++row) {
    for (int column = 0; column < 16; ++column)
      cells.push_back(
          {along_hilbert_curve(static_cast<std::uint32_t>(column), static_cast<std::uint32_t>(row)), {column, row}});
  }
  std::ranges::sort(cells);
  for (std::size_t k = 0; k + 1 < cells.size(); ++k) {
    ASSERT_EQ(cells[k].first, k);
    const auto &here = cells[k].second, &next = cells[k + 1].second;
    ASSERT_EQ(std::abs(next[0] - here[0]) + std::abs(next[1] - here[1]), 1) << k;
  }
}

/// All cells of a grid of 100 by 100 cells of 1 m.
Seeder square(std::uint64_t rocks) {
  ReleaseCells cells;
  cells.columns = 100;
  for (std::uint32_t cell = 0; cell < 10'000; ++cell) cells.cells.push_back(cell);
  std::ranges::sort(cells.cells, {}, [](std::uint32_t cell) { return along_hilbert_curve(cell % 100, cell / 100); });
  cells.sources = {{0, SourceId{0}}};
  Seeder seeder;
  seeder.rocks = rocks;
  seeder.where = std::move(cells);
  seeder.step = even_step(count_places(seeder));
  return seeder;
}

Vec2 place_in(const Seeder& seeder, std::uint64_t seed, std::uint64_t rock) {
  return place_of(seeder, {seed, {}, seeder.first_rock, seeder.rocks}, rock).point.xy();
}

// 500 rocks on 10,000 cells: in each of 100 squares between 2 and 9 rocks where 5 are due, for the whole run; and in
// each of 25 squares after the first fifth.
TEST(PlaceOf, AnyFirstRocksLeaveNoGapOnPlan) {
  const Seeder seeder = square(500);
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    std::vector<int> small(100), large(25);
    for (std::uint64_t rock = 0; rock < 500; ++rock) {
      const Vec2 at = place_in(seeder, seed, rock);
      ++small[static_cast<std::size_t>(at.y() / 10) * 10 + static_cast<std::size_t>(at.x() / 10)];
      if (rock < 100) ++large[static_cast<std::size_t>(at.y() / 20) * 5 + static_cast<std::size_t>(at.x() / 20)];
    }
    const auto [least, most] = std::ranges::minmax(small);
    EXPECT_GE(least, 2) << seed;
    EXPECT_LE(most, 9) << seed;
    EXPECT_GE(std::ranges::min(large), 1) << seed;
    EXPECT_LE(std::ranges::max(large), 8) << seed;
  }
}

// The mean of a function over the first rocks of many seeds is that over all cells, within four standard errors; and
// one run is much nearer to it than as many random places would be.
TEST(PlaceOf, MeansOverAnyFirstRocksAreUnbiased) {
  const auto f = [](const Vec2& at) { return at.x() + at.y() * at.y() / 100 + (at.x() < 30 ? 40 : 0); };
  const double expected = 50 + 100.0 / 3 + 0.3 * 40;
  constexpr double deviation = 47;  // of f over the square, at least
  for (const auto& [rocks, first] : {std::pair{500, 500}, {500, 37}, {20, 20}, {20, 7}, {12'000, 11'000}}) {
    const Seeder seeder = square(static_cast<std::uint64_t>(rocks));
    const int seeds = first > 1000 ? 40 : 400;
    double sum = 0, squares = 0;
    for (int seed = 1; seed <= seeds; ++seed) {
      double mean = 0;
      for (int rock = 0; rock < first; ++rock)
        mean += f(place_in(seeder, static_cast<std::uint64_t>(seed), static_cast<std::uint64_t>(rock))) / first;
      sum += mean;
      squares += (mean - expected) * (mean - expected);
    }
    const double error = std::sqrt(squares / seeds);  // of one seed
    EXPECT_LT(std::abs(sum / seeds - expected), 4 * error / std::sqrt(seeds)) << rocks << ", the first " << first;
    EXPECT_LT(error, 0.6 * deviation / std::sqrt(first)) << rocks << ", the first " << first;
  }
}

// All ensembles have the same places, which are spread evenly as well.
TEST(PlaceOf, RocksAtOnceShareTheirPlace) {
  Seeder seeder = square(1000);
  seeder.first_rock = 30;
  seeder.rocks_at_once = 7;
  std::set<std::pair<double, double>> places;
  for (std::uint64_t rock = 30; rock < 1030; ++rock) {
    const Vec2 at = place_in(seeder, 3, rock);
    places.emplace(at.x(), at.y());
    EXPECT_EQ(at, place_in(seeder, 3, 30 + (rock - 30) / 7 * 7)) << rock;
  }
  EXPECT_EQ(places.size(), 143u);
}

TEST(PlaceOf, LinesAreUnbiasedHoweverShort) {
  ReleaseLines lines;
  const std::vector<Vec3> shortest{{0, 0, 0}, {1, 0, 0}}, middle{{0, 5, 0}, {30, 5, 0}}, longest{{0, 9, 0}, {69, 9, 0}};
  lines.add(shortest, SourceId{0});
  lines.add(middle, SourceId{1});
  lines.add(longest, SourceId{2});
  Seeder seeder;
  seeder.rocks = 3;
  seeder.where = std::move(lines);
  seeder.step = even_step(count_places(seeder));
  constexpr int seeds = 20'000;
  double on_shortest = 0, mean_on_longest = 0, on_longest = 0;
  for (int seed = 0; seed < seeds; ++seed) {
    for (std::uint64_t rock = 0; rock < 3; ++rock) {
      const Vec2 at = place_in(seeder, static_cast<std::uint64_t>(seed), rock);
      on_shortest += at.y() == 0 ? 1 : 0;
      on_longest += at.y() == 9 ? 1 : 0;
      mean_on_longest += at.y() == 9 ? at.x() : 0;
    }
  }
  // Four standard errors; a third of the lines contains the shortest with probability 0.03.
  EXPECT_NEAR(on_shortest / (3 * seeds), 0.01, 4 * std::sqrt(0.03 * 0.97 / seeds) / 3);
  EXPECT_NEAR(on_longest / (3 * seeds), 0.69, 4 * std::sqrt(0.25 / seeds) / 3);
  EXPECT_NEAR(mean_on_longest / on_longest, 34.5, 4 * 20 / std::sqrt(2 * seeds));
}

}  // namespace
}  // namespace talus::release_order_test
