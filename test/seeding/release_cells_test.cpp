#include "talus/seeding/release_cells.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "sampling/goodness_of_fit.hpp"
#include "talus/seeding/seeder.hpp"

namespace talus::release_cells_test {
namespace {

using namespace testing_tools;

// Every third cell of a grid of 7 columns, of 3 by 2 m.
ReleaseCells some_cells(std::uint32_t count) {
  ReleaseCells cells;
  cells.corner = {100, -50};
  cells.dx = 3;
  cells.dy = 2;
  cells.columns = 7;
  for (std::uint32_t k = 0; k < count; ++k) cells.cells.push_back(3 * k);
  cells.sources = {{0, SourceId{0}}};
  return cells;
}

Seeder seeder_of(ReleaseCells cells, std::uint64_t rocks) {
  Seeder seeder;
  seeder.first_rock = 1000;
  seeder.rocks = rocks;
  seeder.where = std::move(cells);
  seeder.above_surface = 0;
  seeder.step = even_step(count_places(seeder));
  return seeder;
}

TEST(ReleaseCells, TheSourceOfACellIsThatOfItsRun) {
  ReleaseCells cells = some_cells(10);
  cells.sources = {{0, SourceId{4}}, {3, SourceId{1}}, {9, SourceId{8}}};
  for (std::size_t entry = 0; entry < 10; ++entry) {
    EXPECT_EQ(cells.source_of(entry), SourceId{entry < 3 ? 4U : entry < 9 ? 1U : 8U}) << entry;
  }
  EXPECT_EQ(cells.bytes(), 10 * 4 + 3 * 8U);
}

TEST(PlaceOf, ACellIsAPlaceInItWithItsMiddle) {
  for (const PlaceInCell place : {PlaceInCell::random, PlaceInCell::centre}) {
    ReleaseCells cells = some_cells(5);
    cells.place = place;
    const Seeder seeder = seeder_of(cells, 500);
    for (std::uint64_t rock = 1000; rock < 1500; ++rock) {
      const ReleasePlace start = place_of(seeder, SamplingPlan{9}, rock);
      const std::uint32_t cell = 3 * static_cast<std::uint32_t>(release_order(seeder, 9).place_of(rock));
      const double west = 100 + 3.0 * (cell % 7), south = -50 + 2.0 * (cell / 7);
      ASSERT_EQ(*start.middle, Vec2(west + 1.5, south + 1));
      ASSERT_GT(start.point.x(), west);
      ASSERT_LT(start.point.x(), west + 3);
      ASSERT_GT(start.point.y(), south);
      ASSERT_LT(start.point.y(), south + 2);
      if (place == PlaceInCell::centre) {
        ASSERT_EQ(start.point.xy(), *start.middle);
      }
    }
  }
}

// Places within a cell are uniform in x and in y, by a Kolmogorov test of 20,000 rocks each; and the test can fail.
TEST(PlaceOf, PlacesInACellAreUniform) {
  const Seeder seeder = seeder_of(some_cells(1), 20'000);
  std::vector<double> x, y, product;
  for (std::uint64_t rock = 1000; rock < 21'000; ++rock) {
    const Vec3 place = place_of(seeder, SamplingPlan{9}, rock).point;
    x.push_back((place.x() - 100) / 3);
    y.push_back((place.y() + 50) / 2);
  }
  const auto even = [](double u) { return std::clamp(u, 0.0, 1.0); };
  EXPECT_GT(kolmogorov_probability(kolmogorov_distance(x, even), x.size()), 1e-3);
  EXPECT_GT(kolmogorov_probability(kolmogorov_distance(y, even), y.size()), 1e-3);
  // x and y are independent: counts in 10 by 10 squares.
  for (std::size_t i = 0; i < x.size(); ++i) product.push_back((std::floor(10 * x[i]) + y[i]) / 10);
  EXPECT_GT(chi_square_probability(product, even, 100), 1e-3);
  // Places shifted slightly to the west are detected.
  for (double& u : x) u = std::pow(u, 1.06);
  EXPECT_LT(kolmogorov_probability(kolmogorov_distance(x, even), x.size()), 1e-3);
}

// With Latin hypercube sampling, the places of all rocks of the seeder are stratified within the cells.
TEST(PlaceOf, PlacesAreStratifiedOverTheSeeder) {
  const Seeder seeder = seeder_of(some_cells(4), 400);
  std::vector<int> hits(400);
  for (std::uint64_t rock = 1000; rock < 1400; ++rock) {
    const SamplingPlan plan{9, SamplingMethod::latin_hypercube, 1000, 400};
    const ReleasePlace start = place_of(seeder, plan, rock);
    const double u = (start.point.x() - (start.middle->x() - 1.5)) / 3;
    ++hits[static_cast<std::size_t>(std::min(399.0, 400 * u))];
  }
  for (const int hit : hits) EXPECT_EQ(hit, 1);
}

}  // namespace
}  // namespace talus::release_cells_test
