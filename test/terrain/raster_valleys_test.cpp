// Gullies and ridges of formulas as rasters: in all directions, steep and gentle, straight and bent, with sides of
// several shapes.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "talus/terrain/raster_surface.hpp"

namespace talus::raster_valleys_test {
namespace {

constexpr std::uint32_t nodes_across = 41;
constexpr double middle = 20;

/// A valley floor that falls in a direction on plan, through the middle of the grid (`off` it, to the side).
struct Valley {
  double direction;  // [rad]
  double gradient;
  double radius = 0;  // of the bent floor on plan; 0: straight
  double off = 0;
  std::function<double(double)> side;  // the height over the floor, by the distance from it on plan

  [[nodiscard]] double height(double x, double y) const {
    const double c = std::cos(direction), s = std::sin(direction);
    const double along = c * x + s * y, aside = c * y - s * x;
    if (radius == 0) return side(std::abs(aside + off)) - gradient * along;
    const double way = radius * std::atan2(along, radius - aside);
    return side(std::abs(radius - std::hypot(along, radius - aside) + off)) - gradient * way;
  }
};

struct Side {
  const char* name;
  std::function<double(double)> height;
};
const std::vector<Side> sides{
    {"V", [](double d) { return d; }},
    {"gentle V", [](double d) { return 0.3 * d; }},
    {"V of one cell in a plane", [](double d) { return 0.7 * std::min(d, 1.0); }},
    {"U", [](double d) { return d < 1.5 ? d * d / 3 : d - 0.75; }},
    {"flat floor", [](double d) { return std::max(0.0, d - 1.2); }},
};

/// `sense` is 1 for the valley, -1 for the ridge that is its mirror image.
RasterSurface raster_of(const Valley& valley, int sense) {
  RasterGrid grid;
  grid.columns = grid.rows = nodes_across;
  for (std::uint32_t j = 0; j < nodes_across; ++j) {
    for (std::uint32_t i = 0; i < nodes_across; ++i) {
      grid.z.push_back(static_cast<float>(sense * valley.height(i - middle, j - middle)));
    }
  }
  return RasterSurface(std::move(grid));
}

/// Of the inner nodes: how many are below all nodes to which the surface has an edge, and how many below all eight
/// around, which no choice of diagonals can drain. (With `sense` -1, above.)
struct Pits {
  int of_surface = 0, of_nodes = 0;
};
Pits pits(const RasterSurface& raster, int sense) {
  const RasterGrid& grid = raster.grid();
  Pits count;
  for (std::uint32_t j = 1; j + 1 < grid.rows; ++j) {
    for (std::uint32_t i = 1; i + 1 < grid.columns; ++i) {
      const auto is_higher = [&](int di, int dj) {
        const auto a = static_cast<std::uint32_t>(static_cast<int>(i) + di),
                   b = static_cast<std::uint32_t>(static_cast<int>(j) + dj);
        return sense * double{grid.z[grid.index(a, b)]} > sense * double{grid.z[grid.index(i, j)]};
      };
      if (!is_higher(1, 0) || !is_higher(-1, 0) || !is_higher(0, 1) || !is_higher(0, -1)) continue;
      const bool ne = is_higher(1, 1), nw = is_higher(-1, 1), se = is_higher(1, -1), sw = is_higher(-1, -1);
      count.of_nodes += ne && nw && se && sw ? 1 : 0;
      const bool drains = (raster.is_cut_north_east(i, j) && !ne) || (!raster.is_cut_north_east(i - 1, j) && !nw) ||
                          (!raster.is_cut_north_east(i, j - 1) && !se) ||
                          (raster.is_cut_north_east(i - 1, j - 1) && !sw);
      count.of_surface += drains ? 0 : 1;
    }
  }
  return count;
}

// The surface is exact where the floor leads through nodes along rows, columns or diagonals: elevations all along the
// floor, and on both sides of it, are those of the formula.
TEST(RasterValleys, InEightDirectionsAreThoseOfTheFormula) {
  for (int eighth = 0; eighth < 8; ++eighth) {
    for (const double gradient : {0.0, 0.05, 0.3, 1.0, 3.0}) {
      for (const double steepness : {0.1, 0.5, 2.0}) {
        for (const int sense : {1, -1}) {
          const Valley valley{eighth * std::numbers::pi / 4, gradient, 0, 0, [=](double d) { return steepness * d; }};
          const RasterSurface raster = raster_of(valley, sense);
          for (double along = -12; along <= 12; along += 0.37) {
            for (const double aside : {0.0, 0.02, -0.4, 1.3}) {
              const double c = std::cos(valley.direction), s = std::sin(valley.direction);
              const double x = c * along - s * aside, y = s * along + c * aside;
              ASSERT_NEAR(raster.elevation(x + middle, y + middle).value(), sense * valley.height(x, y), 2e-5)
                  << eighth << " eighths, gradient " << gradient << ", steepness " << steepness;
            }
          }
        }
      }
    }
  }
}

// In any direction, where nodes lie off the floor: no pit or notch beyond those that the nodes alone have.
TEST(RasterValleys, DrainWhereverTheirNodesDo) {
  int valleys = 0, pits_of_nodes = 0;
  for (int step = 0; step < 24; ++step) {
    for (const double gradient : {0.05, 0.3, 1.0}) {
      for (const double radius : {0.0, 40.0}) {
        for (const double off : {0.0, 0.25, 0.5}) {
          for (const Side& side : sides) {
            const Valley valley{step * std::numbers::pi / 12, gradient, radius, off, side.height};
            for (const int sense : {1, -1}) {
              const Pits count = pits(raster_of(valley, sense), sense);
              ASSERT_EQ(count.of_surface, count.of_nodes)
                  << (sense > 0 ? "valley " : "ridge ") << side.name << ", " << 15 * step << " degrees, gradient "
                  << gradient << ", radius " << radius << ", off " << off;
              ++valleys;
              pits_of_nodes += count.of_nodes;
            }
          }
        }
      }
    }
  }
  EXPECT_EQ(valleys, 24 * 3 * 2 * 3 * 5 * 2);
  EXPECT_GT(pits_of_nodes, 0);  // narrow ones between the directions of the grid
}

// A stepped cliff keeps its foot and its brow straight.
TEST(RasterValleys, ACliffAlongADiagonalIsStraight) {
  for (const int sense : {1, -1}) {
    RasterGrid grid;
    grid.columns = grid.rows = 12;
    for (std::uint32_t j = 0; j < 12; ++j) {
      for (std::uint32_t i = 0; i < 12; ++i) grid.z.push_back(i > j ? 5.0F * static_cast<float>(sense) : 0);
    }
    const RasterSurface raster(std::move(grid));
    for (double x = 2; x < 9; x += 0.13) {
      EXPECT_NEAR(raster.elevation(x, x).value(), 0, 1e-12);
      EXPECT_NEAR(raster.elevation(x + 0.5, x).value(), 2.5 * sense, 1e-12);
      EXPECT_NEAR(raster.elevation(x + 1, x).value(), 5 * sense, 1e-12);
    }
  }
}

// A natural surface, known between its nodes: the diagonals that are chosen are nearer to it than the others.
TEST(RasterValleys, TheMiddlesOfCellsAreNearTheGround) {
  const auto ground = [](double x, double y) {
    return 6 * std::sin(x / 3.1 + 0.4) * std::cos(y / 4.3) + 3 * std::sin((x + 2 * y) / 2.9) +
           2 * std::cos((2.3 * x - y) / 3.7) - 0.6 * x;
  };
  RasterGrid grid;
  grid.columns = grid.rows = 81;
  for (std::uint32_t j = 0; j < 81; ++j) {
    for (std::uint32_t i = 0; i < 81; ++i) grid.z.push_back(static_cast<float>(ground(i, j)));
  }
  const RasterSurface raster(grid);
  double chosen = 0, other = 0;
  int nearer = 0, cells = 0;
  for (std::uint32_t j = 0; j < 80; ++j) {
    for (std::uint32_t i = 0; i < 80; ++i) {
      const double z = ground(i + 0.5, j + 0.5), here = raster.elevation(i + 0.5, j + 0.5).value();
      const double sum = double{grid.z[grid.index(i, j)]} + grid.z[grid.index(i + 1, j)] +
                         grid.z[grid.index(i, j + 1)] + grid.z[grid.index(i + 1, j + 1)];
      const double there = sum / 2 - here;  // the middle of the other diagonal
      chosen += (here - z) * (here - z);
      other += (there - z) * (there - z);
      nearer += std::abs(here - z) <= std::abs(there - z) ? 1 : 0;
      ++cells;
    }
  }
  EXPECT_GT(nearer, 0.95 * cells);
  EXPECT_LT(chosen, 0.4 * other);
}

}  // namespace
}  // namespace talus::raster_valleys_test
