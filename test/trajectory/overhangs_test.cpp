// Terrain that folds back over itself: there is also ground under an overhang, and its end is a rim.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "support/meshes.hpp"
#include "support/scenes.hpp"
#include "talus/terrain/profile.hpp"

namespace talus::overhangs_test {
namespace {

using namespace testing_tools;

const Vec3 gravity(0, 0, -standard_gravity);
const Rock rock = sphere_of_diameter(0.8, 2700);

Laws laws_of(RockModel model) {
  Laws laws;
  set_model(laws, model, false);
  laws.sliding = SlidingMethod::closed_form;
  return laws;
}

// Two lips over two floors, and a vertical step.
const std::vector<Vec2> folded{{0, 10}, {8, 9}, {7, 5}, {6, 4.5}, {14, 3}, {13, 0}, {20, -1}, {20, -4}, {40, -5}};

template <class Surface>
double greatest_by_sampling(const Surface& surface, const Parabola& path, double t_end) {
  double highest = 0;
  constexpr int samples = 20000;
  for (int k = 0; k <= samples; ++k) {
    const Vec3 p = path.at(t_end * k / samples);
    if (const auto z = surface.elevation(p.x(), p.y(), p.z() + 1e-9)) highest = std::max(highest, p.z() - *z);
  }
  return highest;
}

template <class Surface>
void expect_heights_as_sampled(const Surface& surface, Dice& dice, double y) {
  for (int k = 0; k < 300; ++k) {
    const double x = dice.between(0.5, 39);
    // On top, or on one of both floors.
    const auto z = surface.elevation(x, y, std::array{100.0, 4.5, 0.0}[dice.below(3)]);
    if (!z) continue;
    const double start = *z + dice.magnitude(1e-3, 3);
    if (surface.elevation(x, y, start) != z) continue;  // the start is in the roof
    const Parabola path{{x, y, start}, {dice.between(-12, 12), 0, dice.between(-2, 9)}, gravity};
    const auto contact = surface.first_contact(path, 0, 100);
    const double t_end = contact ? contact->t : surface.exit(path).t;
    const double sampled = greatest_by_sampling(surface, path, t_end);
    const double found = surface.max_height(path, t_end, 0);
    ASSERT_GE(found, sampled - 1e-6) << text(path.p) << text(path.v);
    // Samples are up to 0.2 ms apart, at less than 100 m/s relative to steep ground.
    ASSERT_LE(found, sampled + 0.02) << text(path.p) << text(path.v);
  }
}

TEST(Overhang, HeightIsMeasuredFromVisibleGround) {
  Dice dice(201);
  expect_heights_as_sampled(Profile(folded), dice, 0);
  expect_heights_as_sampled(extruded(folded, 20, 5, dice).mesh(), dice, 10.3);
}

// With enough segments for a tree.
TEST(Overhang, HeightOverALongFoldedSectionIsMeasuredFromVisibleGround) {
  Dice dice(202);
  std::vector<Vec2> fine;
  for (std::size_t k = 0; k + 1 < folded.size(); ++k) {
    for (int part = 0; part < 12; ++part) fine.push_back(folded[k] + part / 12.0 * (folded[k + 1] - folded[k]));
  }
  fine.push_back(folded.back());
  expect_heights_as_sampled(Profile(fine), dice, 0);
}

// Roof and floor bend at the same place.
const std::vector<Vec2> bent_together{{0, 30}, {5, 26}, {10, 25}, {2, 10}, {5, 8}, {30, 0}};

template <class Surface>
void expect_floor_hidden_over_a_shared_edge(const Surface& surface, double y) {
  for (const double height : {0.0, 0.7}) {
    const Vec3 over_the_edge(5, y, 26 + height);
    for (const double vx : {-3.0, -0.1, 0.1, 3.0}) {
      const Parabola from{over_the_edge, {vx, 0, 5}, gravity};
      const double t_end = 1e-3;
      const double sampled = greatest_by_sampling(surface, from, t_end);
      EXPECT_NEAR(surface.max_height(from, t_end, 0), sampled, 1e-4) << height << ' ' << vx;
      // The reverse path ends there.
      const Parabola back{from.at(t_end), -from.velocity(t_end), gravity};
      EXPECT_NEAR(surface.max_height(back, t_end, 0), sampled, 1e-4) << height << ' ' << vx;
    }
    for (const double t_end : {0.0, 1e-12, 1e-9}) {
      const Parabola path{over_the_edge, {3, 0, 2}, gravity};
      EXPECT_NEAR(surface.max_height(path, t_end, 0), height, 1e-7) << height << ' ' << t_end;
    }
  }
}

TEST(Overhang, AFloorThatBendsUnderABendOfTheRoofIsHidden) {
  Dice dice(206);
  expect_floor_hidden_over_a_shared_edge(Profile(bent_together), 0);
  expect_floor_hidden_over_a_shared_edge(extruded(bent_together, 20, 5, dice).mesh(), 10.3);
}

// The height of a rock launched off a face of 10 m is that of the face plus its rise and fall, at once.
TEST(Overhang, TheFootOfAVerticalFaceCountsAtOnce) {
  const Profile cliff(std::vector<Vec2>{{0, 10}, {5, 10}, {5, 0}, {40, 0}});
  const Parabola path{{1, 0, 11}, {10, 0, 0}, gravity};
  EXPECT_NEAR(cliff.max_height(path, 1, 0), 11 - 0.5 * standard_gravity * 0.4 * 0.4, 1e-12);
}

// ---- exits ----

TEST(Overhang, ARockThatSlidesOverABrowWithoutGroundBeyondLeaves) {
  Dice dice(203);
  Soil soil;
  soil.phi = 0.05;
  const std::array shapes{extruded(std::vector<Vec2>{{0, 10}, {20, 5}, {19.9, 2}}, 10, 3, dice),
                          extruded(std::vector<Vec2>{{0, 10}, {20, 5}, {20, 2}, {0, 2}}, 10, 3, dice)};
  for (const Shape& shape : shapes) {
    const TriangleMesh mesh = shape.mesh();
    for (const RockModel model : {RockModel::lumped_mass, RockModel::rigid_sphere}) {
      for (const Vec3& velocity : {Vec3(1, 0, 0), Vec3(12, 0, 0), Vec3(25, 0.3, 3)}) {
        const Followed path = follow(mesh, ground_of(soil), laws_of(model), {{{2, 5, 10.4}, velocity}, rock});
        EXPECT_EQ(path.outcome.reason, EndReason::left_model);
        EXPECT_NEAR(path.outcome.end.position.x(), 20, 1e-6);
      }
    }
  }
}

// A floor that falls to its rim at y = 10, under a roof that extends beyond it.
TEST(Overhang, ASphereLeavesAtTheRimOfItsFloorUnderAWiderRoof) {
  for (const double roof : {10.0, 11.0, 13.0}) {
    Shape shape;
    shape.vertices = {{0, 0, 1},   {20, 0, 1},    {20, 10, 0}, {0, 10, 0},    {0, -3, 6},   {0, roof, 6},
                      {15, -3, 6}, {15, roof, 6}, {15, -3, 7}, {15, roof, 7}, {-10, -3, 9}, {-10, roof, 9}};
    shape.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 5}, {0, 5, 4},  {4, 5, 7},
                       {4, 7, 6}, {6, 7, 9}, {6, 9, 8}, {8, 9, 11}, {8, 11, 10}};
    const Followed path =
        follow(shape.mesh(), ground_of({}), laws_of(RockModel::rigid_sphere), {{{5, 5, 1.2}, {0, 2, 0}}, rock});
    EXPECT_EQ(path.outcome.reason, EndReason::left_model) << roof;
    EXPECT_NEAR(path.outcome.end.position.y(), 10, 1e-6) << roof;
  }
}

TEST(Overhang, ARockBelowTheFloorIsLost) {
  Dice dice(204);
  const TriangleMesh mesh = extruded(folded, 20, 5, dice).mesh();
  // The release is between the lip and the floor under it; the flight starts below the floor.
  EXPECT_TRUE(mesh.exit({{7, 10, 4.2}, {1, 0, 0}, gravity}).beneath);
  EXPECT_FALSE(mesh.exit({{39.5, 10, 0}, {30, 0, 0}, gravity}).beneath);
}

// ---- lines on the ground ----

TEST(Overhang, ALineHasTheStepsOfTheGround) {
  Dice dice(205);
  const TriangleMesh mesh = extruded(folded, 20, 5, dice).mesh();
  const auto line = mesh.draped({2, 10}, {30, 10});
  for (const Vec3& p : line) {
    // The line is on the highest ground.
    EXPECT_GE(p.z(), *mesh.elevation(p.x() + 1e-7, p.y()) - 1e-6);
  }
  const auto has = [&](double x, double z) {
    return std::any_of(line.begin(), line.end(),
                       [&](const Vec3& p) { return std::hypot(p.x() - x, p.z() - z) < 1e-6; });
  };
  EXPECT_TRUE(has(8, 9) && has(8, 4.125) && has(14, 3) && has(14, -1.0 / 7) && has(20, -1) && has(20, -4));
}

TEST(Overhang, ABarrierCanStandAtTheFootOfAFace) {
  const std::array<Vec3, 4> foot{Vec3(2, 0, 10), Vec3(5, 0, 10), Vec3(5, 0, 0), Vec3(15, 0, 0)};
  const auto panels = panels_over(foot, 3, 0);
  ASSERT_EQ(panels.size(), 2U);
  EXPECT_EQ(panels[0].foot, foot[0]);
  EXPECT_EQ(panels[1].foot, foot[2]);
  EXPECT_FALSE(panels[1].has_previous);
  EXPECT_DOUBLE_EQ(panels[1].station, 3);
}

}  // namespace
}  // namespace talus::overhangs_test
