#include "talus/rocks/separation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/dice.hpp"
#include "talus/core/orientation.hpp"

namespace talus::separation_test {
namespace {

using testing_tools::Dice;

std::vector<Vec3> box_corners(const Vec3& size) {
  std::vector<Vec3> corners;
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      for (const double z : {-0.5, 0.5}) corners.push_back(size.times({x, y, z}));
    }
  }
  return corners;
}

Posture posture(const std::vector<Vec3>& corners, const Vec3& centre, const Orientation& turned = {}) {
  double reach = 0;
  for (const Vec3& corner : corners) reach = std::max(reach, corner.norm());
  return {corners, turned.matrix(), centre, reach};
}

const std::vector<Vec3> square{{0, -1, 0}, {0, 1, 0}, {0, 1, 2}, {0, -1, 2}};

TEST(Separation, OfAFaceAnEdgeAndACornerFromASquare) {
  const auto corners = box_corners({1, 1, 1});
  const auto face = separation(posture(corners, {-1, 0.2, 0.7}), square);
  ASSERT_TRUE(face);
  EXPECT_NEAR(face->distance, 0.5, 1e-9);
  EXPECT_NEAR(face->direction.x(), -1, 1e-9);
  const auto above = separation(posture(corners, {0.1, 0, 2.75}), square);
  ASSERT_TRUE(above);
  EXPECT_NEAR(above->distance, 0.25, 1e-9);
  EXPECT_NEAR(above->direction.z(), 1, 1e-9);
  EXPECT_NEAR(above->nearest.z(), 2, 1e-9);
  const auto aside = separation(posture(corners, {-0.8, 1.9, 2.9}), square);
  ASSERT_TRUE(aside);
  EXPECT_NEAR(aside->distance, std::sqrt(0.3 * 0.3 + 0.4 * 0.4 + 0.4 * 0.4), 1e-9);
  EXPECT_NEAR((aside->nearest - Vec3(0, 1, 2)).norm(), 0, 1e-9);
  EXPECT_FALSE(separation(posture(corners, {-0.4, 0, 1}), square));
  EXPECT_FALSE(separation(posture(corners, {0, 1.4, 2.4}), square));
}

// The plane across the direction at the nearest point separates both, and no point of the polygon is nearer to the
// body.
TEST(Separation, HasASeparatingPlane) {
  Dice dice(3);
  int apart = 0;
  for (int k = 0; k < 2000; ++k) {
    const auto corners = box_corners({dice.between(0.1, 2), dice.between(0.1, 2), dice.between(0.1, 2)});
    const Orientation turned = Orientation::of_turn(dice.between(0, 3) * dice.direction());
    const Posture body = posture(corners, dice.in_cube(2.5), turned);
    const auto found = separation(body, square);
    if (!found) continue;
    ++apart;
    double body_from = 1e9, square_to = -1e9;
    for (std::size_t i = 0; i < corners.size(); ++i)
      body_from = std::min(body_from, found->direction.dot(body.place(i)));
    for (const Vec3& corner : square) square_to = std::max(square_to, found->direction.dot(corner));
    EXPECT_NEAR(body_from - square_to, found->distance, 2e-6 * found->distance + 1e-12) << k;
    EXPECT_NEAR(found->direction.dot(found->nearest), square_to, 1e-6) << k;
    EXPECT_NEAR(found->nearest.x(), 0, 1e-9);
    // And the body reaches over the whole gap.
    const Vec3 across = found->nearest + (found->distance + 1e-5) * found->direction;
    EXPECT_FALSE(separation(body, std::vector<Vec3>{found->nearest, across})) << k;
  }
  EXPECT_GT(apart, 500);
}

}  // namespace
}  // namespace talus::separation_test
