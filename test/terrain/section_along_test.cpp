#include "talus/terrain/section_along.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "talus/terrain/raster_surface.hpp"
#include "talus/terrain/triangle_mesh.hpp"

namespace talus::section_along_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::uint32_t none = TriangleMesh::no_neighbour;

/// Two terraces with a wall of 5 m between them, at x = 10.
TriangleMesh terraces() {
  const std::vector<Vec3> vertices{{0, 0, 5},  {10, 0, 5}, {10, 10, 5}, {0, 10, 5},
                                   {10, 0, 0}, {20, 0, 0}, {20, 10, 0}, {10, 10, 0}};
  const std::vector<TriangleMesh::Corners> triangles{{0, 1, 2}, {0, 2, 3}, {1, 4, 7}, {1, 7, 2}, {4, 5, 6}, {4, 6, 7}};
  return {vertices, triangles, std::vector<TriangleMesh::Corners>(6, {none, none, none})};
}

RasterSurface waves(std::uint32_t side) {
  RasterGrid grid{.columns = side, .rows = side};
  for (std::uint32_t row = 0; row < side; ++row) {
    for (std::uint32_t column = 0; column < side; ++column)
      grid.z.push_back(static_cast<float>(std::sin(column * 0.7) + std::cos(row * 1.3)));
  }
  return RasterSurface(std::move(grid));
}

TEST(SectionAlong, HasTheStepsOfTheGround) {
  const TriangleMesh mesh = terraces();
  const std::vector<Vec2> line{{2, 5}, {18, 5}};
  const auto section = section_along(mesh, line, 100);
  double last_z = 5;
  int steps = 0;
  for (const SectionPoint& point : section) {
    ASSERT_TRUE(point.z);
    if (point.place.x() != 10) {
      EXPECT_NEAR(*point.z, point.place.x() < 10 ? 5 : 0, 1e-9);
    }
    if (std::abs(*point.z - last_z) > 1) {
      ++steps;
      EXPECT_DOUBLE_EQ(point.place.x(), 10);  // the whole step is at one place
    }
    last_z = *point.z;
  }
  EXPECT_EQ(steps, 1);
  EXPECT_EQ(section.front().distance, 0);
  EXPECT_DOUBLE_EQ(section.back().distance, 16);
}

TEST(SectionAlong, IsTheElevationEverywhere) {
  const RasterSurface surface = waves(12);
  const std::vector<Vec2> line{{0.3, 0.2}, {10.1, 4.4}, {10.1, 4.4}, {2.2, 10.7}};
  const auto section = section_along(surface, line, 1000);
  // Between two neighbouring points the ground is straight.
  for (std::size_t k = 0; k + 1 < section.size(); ++k) {
    ASSERT_TRUE(section[k].z && section[k + 1].z);
    for (const double part : {0.25, 0.5, 0.75}) {
      const Vec2 at = section[k].place + part * (section[k + 1].place - section[k].place);
      EXPECT_NEAR(*section[k].z + part * (*section[k + 1].z - *section[k].z), *surface.elevation(at.x(), at.y()), 1e-5);
    }
  }
  const double length = (line[1] - line[0]).norm() + (line[3] - line[2]).norm();
  EXPECT_NEAR(section.back().distance, length, 1e-12);
}

TEST(SectionAlong, HasGapsOverHolesAndBeyondTheEdge) {
  RasterGrid grid{.columns = 6, .rows = 2};
  grid.z = {0, 1, 2, nan, 4, 5, 0, 1, 2, 3, 4, 5};
  const RasterSurface surface(std::move(grid));
  const std::vector<Vec2> line{{-1, 0.5}, {6, 0.5}};
  std::vector<std::pair<double, double>> ground;  // from, to
  const auto section = section_along(surface, line, 100);
  for (std::size_t k = 0; k + 1 < section.size(); ++k) {
    if (!section[k].z || !section[k + 1].z) continue;
    const double from = section[k].place.x(), to = section[k + 1].place.x();
    if (!ground.empty() && ground.back().second == from) {
      ground.back().second = to;
    } else {
      ground.emplace_back(from, to);
    }
  }
  ASSERT_EQ(ground.size(), 2U);
  EXPECT_NEAR(ground[0].first, 0, 1e-12);
  EXPECT_NEAR(ground[0].second, 2, 1e-12);
  EXPECT_NEAR(ground[1].first, 4, 1e-12);
  EXPECT_NEAR(ground[1].second, 5, 1e-12);
  EXPECT_FALSE(section.front().z);
  EXPECT_FALSE(section.back().z);
}

TEST(SectionAlong, IsEvenlySpacedIfItWouldHaveTooManyPoints) {
  const RasterSurface surface = waves(100);
  const std::vector<Vec2> line{{0, 0}, {99, 99}, {0, 99}};
  ASSERT_GT(section_along(surface, line, 1000).size(), 150U);
  const auto section = section_along(surface, line, 50);
  EXPECT_LE(section.size(), 50U);
  EXPECT_GE(section.size(), 40U);
  bool has_corner = false;
  for (const SectionPoint& point : section) {
    EXPECT_EQ(point.z, surface.elevation(point.place.x(), point.place.y()));
    has_corner = has_corner || point.place == line[1];
  }
  EXPECT_TRUE(has_corner);
  EXPECT_EQ(section.back().place, line[2]);
}

}  // namespace
}  // namespace talus::section_along_test
