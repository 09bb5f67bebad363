#include "talus/layers/contour_line.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace talus {
namespace {

/// 41 x 31 nodes, 5 m apart.
template <class Height>
Model on_raster(Height&& height) {
  RasterGrid grid{.columns = 41, .rows = 31, .x0 = 0, .y0 = 0, .dx = 5, .dy = 5, .z = {}};
  for (std::uint32_t row = 0; row < grid.rows; ++row)
    for (std::uint32_t column = 0; column < grid.columns; ++column)
      grid.z.push_back(static_cast<float>(height(5.0 * column, 5.0 * row)));
  Model model;
  model.surface = RasterSurface(std::move(grid));
  model.frame.origin = Vec3(1000, 2000, 100);
  return model;
}

TEST(ContourLine, OfAPlaneIsStraightFromBorderToBorder) {
  const Model model = on_raster([](double x, double y) { return 200 - x - 0.5 * y; });
  const auto found = contour_through(model, {1050, 2080}, std::nullopt, 500);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->elevation, 300 - 50 - 40, 1e-4);
  for (const Vec2& p : found->points) EXPECT_NEAR(p.x() - 1000 + 0.5 * (p.y() - 2000), 90, 1e-4);
  const Vec2 way = found->points.back() - found->points.front();
  EXPECT_NEAR(std::abs(way.y()), 150, 1e-3);
}

TEST(ContourLine, AroundASummitEndsWhereItBegins) {
  const Model model = on_raster([](double x, double y) { return 500 - std::hypot(x - 102, y - 71); });
  const auto found = contour_through(model, {1102 + 40, 2071}, std::nullopt, 5000);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->points.front(), found->points.back());
  for (const Vec2& p : found->points) EXPECT_NEAR((p - Vec2(1102, 2071)).norm(), 40, 0.5);
  EXPECT_GT(found->points.size(), 50U);
  const auto simple = contour_through(model, {1142, 2071}, std::nullopt, 20);
  ASSERT_TRUE(simple);
  EXPECT_LE(simple->points.size(), 20U);
  EXPECT_GE(simple->points.size(), 4U);
}

TEST(ContourLine, IsTheNearestOfItsElevation) {
  // Two ridges; every contour of a flank is a line of its own.
  const Model model = on_raster([](double x, double) { return 50 - 20 * std::cos(x * 6.2831853 / 100); });
  const auto left = contour_through(model, {1010, 2075}, 150.0, 500),
             right = contour_through(model, {1110, 2075}, 150.0, 500);
  ASSERT_TRUE(left && right);
  for (const Vec2& p : left->points) EXPECT_NEAR(p.x(), 1025, 1);
  for (const Vec2& p : right->points) EXPECT_NEAR(p.x(), 1125, 1);
}

TEST(ContourLine, EndsAtHoles) {
  const Model model = on_raster([](double x, double y) {
    return std::abs(x - 100) < 6 && y > 60 && y < 90 ? std::numeric_limits<double>::quiet_NaN() : 100 - 0.5 * y;
  });
  const auto found = contour_through(model, {1020, 2075}, std::nullopt, 500);
  ASSERT_TRUE(found);
  for (const Vec2& p : found->points) EXPECT_LE(p.x(), 1096);
  EXPECT_FALSE(contour_through(model, {1100, 2075}, std::nullopt, 500)) << "in the hole";
  EXPECT_FALSE(contour_through(model, {1020, 2075}, 900.0, 500)) << "above the terrain";
}

}  // namespace
}  // namespace talus
