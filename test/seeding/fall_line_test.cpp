#include "talus/seeding/fall_line.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "talus/terrain/profile.hpp"
#include "talus/terrain/raster_surface.hpp"

namespace talus::fall_line_test {
namespace {

constexpr double rounding = 1e-12;

TEST(FallLine, OfASectionIsDownEitherSideOfARidge) {
  const Profile ridge(std::vector<Vec2>{{-4, 0}, {0, 3}, {12, -2}});
  EXPECT_LT((fall_line(ridge, {-1, 0, 9}) - Vec3(-4, 0, -3) / 5).norm(), rounding);
  EXPECT_LT((fall_line(ridge, {1, 0, 9}) - Vec3(12, 0, -5) / 13).norm(), rounding);
}

TEST(FallLine, IsThatOfThePlaneForAnyDiagonalsOfARaster) {
  RasterGrid grid;
  grid.columns = grid.rows = 5;
  for (int j = 0; j < 5; ++j) {
    for (int i = 0; i < 5; ++i) grid.z.push_back(static_cast<float>(3 * i - 4 * j));
  }
  const RasterSurface plane(grid);
  const Vec3 down = Vec3(-3, 4, -25).normalized();
  for (const Vec3& place : {Vec3(1.2, 1.7, 50), Vec3(1.7, 1.2, 50), Vec3(2, 3, -6)}) {  // the last one on a node
    EXPECT_LT((fall_line(plane, place) - down).norm(), rounding);
  }
}

TEST(FallLine, OfAPlaceInTheGroundIsThatAboveIt) {
  const Profile slope(std::vector<Vec2>{{0, 10}, {10, 0}});
  EXPECT_LT((fall_line(slope, {5, 0, 2}) - Vec3(1, 0, -1).normalized()).norm(), rounding);
}

// A shelf that rises, over a floor that falls.
TEST(FallLine, UnderAnOverhangIsThatOfTheFloor) {
  const Profile cave(std::vector<Vec2>{{0, 20}, {10, 22}, {2, 15}, {2, 10}, {32, 0}});
  EXPECT_LT((fall_line(cave, {6, 0, 30}) - Vec3(-10, 0, -2).normalized()).norm(), rounding);
  EXPECT_LT((fall_line(cave, {6, 0, 10}) - Vec3(3, 0, -1).normalized()).norm(), rounding);
}

TEST(FallLine, IsEastOnLevelGroundAndOffTheTerrain) {
  const Profile level(std::vector<Vec2>{{0, 3}, {10, 3}});
  EXPECT_EQ(fall_line(level, {5, 0, 4}), unit_x);
  EXPECT_EQ(fall_line(level, {50, 0, 4}), unit_x);
}

}  // namespace
}  // namespace talus::fall_line_test
