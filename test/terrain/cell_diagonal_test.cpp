// The diagonal of a raster's cell: against second derivatives, mirrored and turned grids, holes and rims.

#include "talus/terrain/cell_diagonal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "support/dice.hpp"

namespace talus::cell_diagonal_test {
namespace {

using testing_tools::Dice;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

struct Heights {
  std::uint32_t columns, rows;
  std::vector<double> z;  // row by row from the south

  template <class Height>
  Heights(std::uint32_t across, std::uint32_t along, Height&& height) : columns(across), rows(along) {
    for (std::uint32_t j = 0; j < rows; ++j) {
      for (std::uint32_t i = 0; i < columns; ++i) z.push_back(height(i, j));
    }
  }
  [[nodiscard]] double at(std::uint32_t i, std::uint32_t j) const { return z[j * columns + i]; }
  [[nodiscard]] bool is_north_east(std::uint32_t i, std::uint32_t j) const {
    return is_edge_north_east([&](std::uint32_t a, std::uint32_t b) { return at(a, b); }, columns, rows, i, j);
  }
  [[nodiscard]] double twist(std::uint32_t i, std::uint32_t j) const {
    return at(i, j) + at(i + 1, j + 1) - at(i + 1, j) - at(i, j + 1);
  }
};

// For every cell: at a rim, too, a quadratic surface has the second derivatives that are computed.
TEST(CellDiagonal, IsAlongTheLesserSecondDerivative) {
  Dice dice(611);
  int compared = 0, north_east = 0;
  for (int k = 0; k < 300; ++k) {
    const double uu = dice.between(-1, 1), uv = dice.between(-1, 1), vv = dice.between(-1, 1);
    const double p = dice.between(-3, 3), q = dice.between(-3, 3);
    const auto bend = [&](double u, double v) { return std::abs(uu * u * u + 2 * uv * u * v + vv * v * v); };
    if (std::abs(bend(1, 1) - bend(1, -1)) < 1e-6) continue;
    const Heights ground(5, 4, [&](double x, double y) {
      return 100 + p * x + q * y + 0.5 * (uu * x * x + 2 * uv * x * y + vv * y * y);
    });
    for (std::uint32_t j = 0; j < 3; ++j) {
      for (std::uint32_t i = 0; i < 4; ++i) {
        ASSERT_EQ(ground.is_north_east(i, j), bend(1, 1) < bend(1, -1));
        ++compared;
        north_east += ground.is_north_east(i, j) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(north_east, compared / 3);
  EXPECT_LT(north_east, 2 * compared / 3);
}

// Four nodes, 1 at south-west and north-east and 0 at the others, are a ridge or a gully.
TEST(CellDiagonal, OfTheSameFourNodesIsThatOfTheGroundAround) {
  const auto height = [](double around) {
    return [=](std::uint32_t i, std::uint32_t j) {
      return i == 0 || j == 0 || i == 3 || j == 3 ? around : i == j ? 1.0 : 0.0;
    };
  };
  EXPECT_TRUE(Heights(4, 4, height(-1)).is_north_east(1, 1));  // a ridge from south-west to north-east
  EXPECT_FALSE(Heights(4, 4, height(2)).is_north_east(1, 1));  // a gully from south-east to north-west
}

TEST(CellDiagonal, WithoutAnythingAroundIsTheLowerOne) {
  const auto alone = [](double sw, double se, double nw, double ne) { return is_edge_north_east({sw, se, nw, ne}, 0); };
  EXPECT_TRUE(alone(0, 1, 1, 0));
  EXPECT_FALSE(alone(1, 0, 0, 1));
  EXPECT_TRUE(alone(-7, 0, 0, 0));
  EXPECT_FALSE(alone(7, 0, 0, 0));
  EXPECT_TRUE(Heights(2, 2, [](std::uint32_t i, std::uint32_t j) { return i == j ? 0.0 : 1.0; }).is_north_east(0, 0));
}

// Whole numbers, so that many bends are 0 and many diagonals are level with each other; and holes.
TEST(CellDiagonal, TurnsAndIsMirroredWithTheGround) {
  Dice dice(612);
  int compared = 0;
  for (int k = 0; k < 40; ++k) {
    const double range = dice.between(1, 6);
    const Heights ground(9, 7, [&](std::uint32_t, std::uint32_t) {
      return dice.chance(0.05) ? nothing : std::floor(dice.between(0, range));
    });
    const Heights mirrored(9, 7, [&](std::uint32_t i, std::uint32_t j) { return ground.at(8 - i, j); });
    const Heights turned(7, 9, [&](std::uint32_t i, std::uint32_t j) { return ground.at(j, 6 - i); });
    // A plane is added, whose slopes are whole numbers.
    const Heights tilted(9, 7,
                         [&](std::uint32_t i, std::uint32_t j) { return ground.at(i, j) + 3. * i - 2. * j + 1000; });
    for (std::uint32_t j = 0; j < 6; ++j) {
      for (std::uint32_t i = 0; i < 8; ++i) {
        const double twist = ground.twist(i, j);
        if (std::isnan(twist)) continue;
        ASSERT_EQ(tilted.is_north_east(i, j), ground.is_north_east(i, j));
        if (twist == 0) continue;  // a plane
        ASSERT_NE(mirrored.is_north_east(7 - i, j), ground.is_north_east(i, j));
        ASSERT_NE(turned.is_north_east(5 - j, i), ground.is_north_east(i, j));
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 500);
}

TEST(CellDiagonal, BesideAHoleFollowsTheNodesThatAreThere) {
  // A gully from south-west to north-east, with holes on one side, then on both, of one cell.
  const auto gully = [](std::uint32_t i, std::uint32_t j) { return std::abs(double{1} * i - j) - 0.5 * (i + j); };
  const auto with_holes = [&](bool west, bool east) {
    return Heights(4, 4, [&](std::uint32_t i, std::uint32_t j) {
      return (west && i == 0) || (east && i == 3) ? nothing : gully(i, j);
    });
  };
  for (const bool west : {false, true}) {
    for (const bool east : {false, true}) EXPECT_TRUE(with_holes(west, east).is_north_east(1, 1));
  }
  EXPECT_EQ(bend_along(4, 1, 0, 1), 4);
  EXPECT_EQ(bend_along(nothing, 1, 0, 1), 4);
  EXPECT_EQ(bend_along(1, 0, 1, nothing), 4);
  EXPECT_EQ(bend_along(nothing, 0, 1, nothing), 0);
}

}  // namespace
}  // namespace talus::cell_diagonal_test
