#include "talus/rocks/ridge.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "support/dice.hpp"
#include "talus/meshing/rock_shape.hpp"
#include "talus/rocks/separation.hpp"

namespace talus::ridge_test {
namespace {

using testing_tools::Dice;

constexpr double unbounded = std::numeric_limits<double>::infinity();

const std::vector<RockShape>& shapes() {
  static const std::vector<RockShape> all{box_shape({1, 1, 1}), box_shape({2, 0.6, 0.3}),
                                          regular_shape(RegularSolid::tetrahedron),
                                          regular_shape(RegularSolid::dodecahedron), ellipsoid_shape({1, 0.7, 0.5})};
  return all;
}

TEST(HullFaces, AreThoseOfTheSolid) {
  EXPECT_EQ(shapes()[0].hull.faces.size(), 6U);
  EXPECT_EQ(shapes()[2].hull.faces.size(), 4U);
  EXPECT_EQ(shapes()[3].hull.faces.size(), 12U);
  EXPECT_EQ(shapes()[4].hull.faces.size(), 44U) << "2 V - 4 triangles";
  for (const RockShape& shape : shapes()) {
    for (const HullFace& face : shape.hull.faces) {
      int on_face = 0;
      for (const Vec3& corner : shape.corners) {
        EXPECT_LT(face.normal.dot(corner) - face.offset, 1e-9);
        on_face += std::abs(face.normal.dot(corner) - face.offset) < 1e-9 ? 1 : 0;
      }
      EXPECT_GE(on_face, 3);
    }
    for (std::size_t i = 0; i < shape.corners.size(); ++i) {
      EXPECT_GE(shape.hull.at(i).size(), 3U);
      for (const HullFaces::AtCorner& at : shape.hull.at(i)) {
        EXPECT_NEAR(shape.hull.faces[at.face].normal.dot(shape.corners[i]), shape.hull.faces[at.face].offset, 1e-9);
        EXPECT_NE(at.along, i);
      }
    }
  }
}

TEST(HullFaces, OfASectionAreItsSides) {
  const RockShape hexagon = section_shape(regular_outline(6));
  ASSERT_EQ(hexagon.hull.faces.size(), 6U);
  for (const HullFace& side : hexagon.hull.faces) EXPECT_NEAR(side.offset, std::sqrt(0.5 / std::sqrt(3)), 1e-9);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(hexagon.hull.at(i).size(), 2U);
}

// On the spot: a cube of 1 m, from above, below its face, across its edge.
TEST(Ridge, TouchesAFaceOrAnEdge) {
  const Body cube = body_of(shapes()[0], sphere_of_mass(2700, 2700));
  const Posture flat = cube.at({0, 0, 1.5}, Orientation{}.matrix());
  const Ridge tip{{0.1, 0.2, 0.7}, {3, 0.2, -2}, {}, 0};
  const auto on_face = ridge_gap(flat, flat.hull->all, tip, unbounded);
  ASSERT_TRUE(on_face);
  EXPECT_NEAR(on_face->gap, 0.3, 1e-12);
  EXPECT_EQ(on_face->s, 0);
  EXPECT_NEAR((normal_at(flat, *on_face) - unit_z).norm(), 0, 1e-12);
  EXPECT_FALSE(ridge_gap(flat, flat.hull->all, tip, 0.29));

  const Orientation turn = Orientation::of_turn({std::atan(1.0), 0, 0});
  const Posture on_edge = cube.at({0, 0, 1.5}, turn.matrix());
  const Ridge across{{0.2, -1, 0.5}, {0.2, 1, 0.5}, {}, 0};
  const auto edges = ridge_gap(on_edge, on_edge.hull->all, across, unbounded);
  ASSERT_TRUE(edges);
  EXPECT_NEAR(edges->s, 0.5, 1e-12);
  EXPECT_NEAR(edges->gap, (1 - std::sqrt(0.5)) * std::sqrt(0.5), 1e-12)
      << "of both faces, not of the edge between them";
  EXPECT_NEAR((normal_at(on_edge, *edges) - unit_z).norm(), 0, 1e-12);
}

// The gap is above 0 when an independent search for the distance finds one, and never more than that. Where they touch,
// the normal parts them.
TEST(Ridge, AgreesWithTheDistance) {
  Dice dice(17);
  int apart = 0, inside = 0;
  for (int k = 0; k < 3000; ++k) {
    const RockShape& shape = shapes()[dice.below(shapes().size())];
    const Body body = body_of(shape, sphere_of_diameter(dice.between(0.5, 2), 2700));
    const Posture at = body.at(dice.in_cube(1), Orientation::of_turn(dice.between(0, 3) * dice.direction()).matrix());
    Ridge ridge{dice.in_cube(2), dice.in_cube(2), {}, 0};
    const auto found = ridge_gap(at, at.hull->all, ridge, unbounded);
    ASSERT_TRUE(found);
    const auto distance = separation(at, std::vector<Vec3>{ridge.from, ridge.to});
    if (!distance) {
      ++inside;
      EXPECT_LT(found->gap, 1e-8) << k;
      const RidgePart part = part_within(at, ridge, 0);
      EXPECT_LE(part.from, found->s + 1e-9) << k;
      EXPECT_GE(part.to, found->s - 1e-9) << k;
      continue;
    }
    ++apart;
    EXPECT_GT(found->gap, 0) << k;
    EXPECT_LE(found->gap, distance->distance * (1 + 1e-5)) << k;
    // Moved until they touch.
    const Vec3 way = distance->distance * distance->direction;
    ridge.from += way, ridge.to += way;
    const auto touch = ridge_gap(at, at.hull->all, ridge, unbounded);
    ASSERT_TRUE(touch);
    EXPECT_NEAR(touch->gap, 0, 3e-6 * distance->distance + 1e-9) << k;
    const Vec3 n = normal_at(at, *touch), place = ridge.from + touch->s * (ridge.to - ridge.from);
    double least = unbounded;
    for (std::size_t i = 0; i < at.corners.size(); ++i) least = std::min(least, n.dot(at.place(i) - place));
    EXPECT_NEAR(least, 0, 1e-5) << k;
    EXPECT_LT(std::max(n.dot(ridge.from - place), n.dot(ridge.to - place)), 1e-5) << k;
  }
  EXPECT_GT(apart, 500);
  EXPECT_GT(inside, 500);
}

}  // namespace
}  // namespace talus::ridge_test
