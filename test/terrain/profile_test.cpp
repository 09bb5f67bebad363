#include "talus/terrain/profile.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/dice.hpp"
#include "support/meshes.hpp"

namespace talus::profile_test {
namespace {

using namespace testing_tools;

const Vec3 gravity(0, 0, -standard_gravity);

std::vector<Vec2> random_section(Dice& dice, int segments) {
  std::vector<Vec2> section{{0, 0}};
  for (int k = 0; k < segments; ++k)
    section.emplace_back(section.back() + Vec2(dice.between(0.5, 4), dice.between(-4, 2)));
  return section;
}

TEST(Profile, SegmentsOfTheTutorial) {
  const std::vector<Vec2> section{{0, 0}, {3.1, -12.2}, {6.7, -12.2}, {9.8, -24.4}, {13.4, -25}, {26, -22.5}};
  const Profile profile(section);
  EXPECT_EQ(profile.facet_count(), 5U);
  EXPECT_EQ(profile.source(FacetId{3}), 3U);
  EXPECT_EQ(profile.bounds().low, Vec3(0, 0, -25));
  EXPECT_EQ(profile.bounds().high, Vec3(26, 0, 0));
  EXPECT_LT((profile.normal(FacetId{1}) - unit_z).norm(), 1e-15);
  const Outline outline = profile.outline(FacetId{2});
  EXPECT_EQ(outline.edge_count, 2);
  EXPECT_EQ(outline.edges[0].beyond, FacetId{1});
  EXPECT_EQ(outline.edges[1].beyond, FacetId{3});
  EXPECT_GT((Vec3(8, 0, -18) - outline.edges[0].point).dot(outline.edges[0].inward), 0);
  EXPECT_GT((Vec3(8, 0, -18) - outline.edges[1].point).dot(outline.edges[1].inward), 0);
  EXPECT_FALSE(profile.outline(FacetId{0}).edges[0].beyond);
  EXPECT_FALSE(profile.outline(FacetId{4}).edges[1].beyond);
}

// Short profiles are searched one by one, long ones through a tree: both must agree with the extruded mesh.
TEST(Profile, ContactsAreThoseOfTheExtrusion) {
  Dice dice(131);
  int contacts = 0;
  for (const int segments : {3, 12, 47, 60, 200}) {
    for (int slope = 0; slope < 6; ++slope) {
      const auto section = random_section(dice, segments);
      const Profile profile(section);
      const TriangleMesh mesh = extruded(section, 40, 3, dice).mesh();
      for (int i = 0; i < 100; ++i) {
        const double radius = i % 2 == 0 ? 0.0 : dice.magnitude(0.02, 3);
        const double x = dice.between(0, 1) * section.back().x();
        Parabola path{{x, 0, *profile.elevation(x) + 4 * radius + dice.between(1, 20)},
                      {dice.between(-15, 15), 0, dice.between(-10, 10)},
                      gravity};
        const auto flat = profile.first_contact(path, radius, 1e3);
        path.p.y() = 21.7;
        const auto wide = mesh.first_contact(path, radius, 1e3);
        // At the outermost end of the slope, the sphere meets the rim of the mesh's last triangles.
        ASSERT_EQ(flat.has_value(), wide.has_value()) << segments << ' ' << slope << ' ' << i;
        if (!flat) continue;
        ++contacts;
        ASSERT_NEAR(flat->t, wide->t, 1e-9);
        ASSERT_LT((flat->normal - wide->normal).norm(), 1e-6);
        ASSERT_EQ(flat->feature, wide->feature);
      }
    }
  }
  EXPECT_GT(contacts, 1500);
}

TEST(Profile, HeightsAndExitsAreThoseOfTheExtrusion) {
  Dice dice(132);
  for (const int segments : {5, 30, 100}) {
    const auto section = random_section(dice, segments);
    const Profile profile(section);
    const TriangleMesh mesh = extruded(section, 40, 3, dice).mesh();
    for (int i = 0; i < 200; ++i) {
      const double x = dice.between(0, 1) * section.back().x();
      ASSERT_NEAR(*profile.elevation(x), *mesh.elevation(x, 11.3), 1e-9);
      Parabola path{{x, 0, *profile.elevation(x) + 1}, {dice.between(-15, 15), 0, dice.between(0, 15)}, gravity};
      const auto contact = profile.first_contact(path, 0, 1e3);
      const double end = contact ? contact->t : profile.exit(path).t;
      const double height = profile.max_height(path, end, 0);
      Parabola shifted = path;
      shifted.p.y() = 11.3;
      ASSERT_NEAR(height, mesh.max_height(shifted, end, 0), 1e-9);
      if (!contact) {
        ASSERT_NEAR(end, mesh.exit(shifted).t, 1e-9);
        EXPECT_FALSE(profile.exit(path).beneath);
      }
    }
  }
}

TEST(Profile, MaximumHeightAgreesWithSampling) {
  Dice dice(133);
  for (int slope = 0; slope < 20; ++slope) {
    const Profile profile(random_section(dice, 20));
    const Parabola path{{1, 0, *profile.elevation(1) + 2}, {dice.between(3, 10), 0, dice.between(0, 10)}, gravity};
    const auto contact = profile.first_contact(path, 0, 1e3);
    const double end = contact ? contact->t : profile.exit(path).t;
    double expected = 0;
    for (int k = 0; k <= 10'000; ++k) {
      const Vec3 q = path.at(end * k / 10'000);
      if (const auto z = profile.elevation(q.x())) expected = std::max(expected, q.z() - *z);
    }
    ASSERT_NEAR(profile.max_height(path, end, 0), expected, 0.01);
    ASSERT_GE(profile.max_height(path, end, 0), expected - 1e-9);
  }
}

// An overhanging section: the ground is on its right-hand side, also below the nose.
TEST(Profile, Overhang) {
  const Profile profile(std::vector<Vec2>{{0, 10}, {6, 10}, {4, 5}, {12, 4}});
  EXPECT_DOUBLE_EQ(*profile.elevation(5), 10);
  EXPECT_NEAR(*profile.elevation(5, 0, 7), 4.875, 1e-12);
  // Launched up from below the nose it hits the underside.
  const auto under = profile.first_contact({{5.6, 0, 5.5}, {0, 0, 20}, gravity}, 0, 10);
  ASSERT_TRUE(under);
  EXPECT_LT(under->normal.z(), 0);
  EXPECT_EQ(under->facet, FacetId{1});
}

TEST(Profile, WithMovedVerticesEqualsANewOne) {
  Dice dice(134);
  Profile moved(random_section(dice, 12));
  const auto section = random_section(dice, 12);
  moved.move_vertices(section);
  const Profile fresh(section);
  for (int i = 0; i < 200; ++i) {
    const double x = dice.between(0, section.back().x());
    EXPECT_EQ(moved.elevation(x), fresh.elevation(x));
    const Parabola path{{x, 0, 50}, {dice.between(-5, 5), 0, 0}, gravity};
    const auto a = moved.first_contact(path, 0.3, 1e3), b = fresh.first_contact(path, 0.3, 1e3);
    ASSERT_EQ(a.has_value(), b.has_value());
    if (a) {
      EXPECT_EQ(a->t, b->t);
    }
  }
  EXPECT_EQ(moved.bounds().low, fresh.bounds().low);
}

TEST(Profile, SupportsOfADisc) {
  const Profile valley(std::vector<Vec2>{{-10, 10}, {0, 0}, {10, 10}});
  int touching = 0;
  const double radius = 1;
  valley.supports({0, 0, std::sqrt(2.0)}, radius, 1e-6, [&](const Vec3& n, auto&&...) {
    EXPECT_NEAR(n.z(), std::sqrt(0.5), 1e-6);
    ++touching;
  });
  EXPECT_EQ(touching, 2);
}

}  // namespace
}  // namespace talus::profile_test
