#include "talus/terrain/triangle_mesh.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "support/dice.hpp"
#include "support/meshes.hpp"
#include "talus/rocks/touch.hpp"

namespace talus::triangle_mesh_test {
namespace {

using namespace testing_tools;
using Long3 = Eigen::Matrix<long double, 3, 1>;

Long3 precise(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

const Vec3 gravity(0, 0, -standard_gravity);

// ---- contacts compared to brute force ----

// The first time at which a point falls through a triangle from its outer side, in long double. Undecided if the point
// passes so near to the triangle's border that rounding decides.
struct Brute {
  std::optional<double> t;
  std::size_t triangle = 0;
  bool is_clear = true;  // not decided by rounding
};

Brute point_by_brute_force(const Shape& shape, const Parabola& path) {
  const Long3 p = precise(path.p), v = precise(path.v), a = precise(path.a);
  Brute best;
  for (std::size_t i = 0; i < shape.triangles.size(); ++i) {
    Long3 corner[3];
    for (std::size_t k = 0; k < 3; ++k) corner[k] = precise(shape.vertices[shape.triangles[i][k]]);
    const Long3 n = (corner[1] - corner[0]).cross(corner[2] - corner[0]).normalized();
    const long double h = n.dot(p - corner[0]), vn = n.dot(v), an = n.dot(a), d = vn * vn - 2 * an * h;
    if (d < 0) continue;
    // Both roots; the one at which the height falls.
    for (const long double sign : {1.0L, -1.0L}) {
      const long double t = an != 0 ? (-vn + sign * std::sqrt(d)) / an : -h / vn;
      if (!(t >= 0) || vn + an * t >= 0) continue;
      const Long3 q = p + t * v + 0.5L * t * t * a;
      long double inside = 1e30L;
      for (int k = 0; k < 3; ++k) {
        const Long3 side = corner[(k + 1) % 3] - corner[k];
        inside = std::min(inside, n.dot(side.cross(q - corner[k])) / side.norm());
      }
      if (std::abs(inside) < 1e-4L) best.is_clear = false;
      if (inside < 0) continue;
      if (best.t && std::abs(t - static_cast<long double>(*best.t)) < 1e-9L) best.is_clear = false;
      if (!best.t || t < static_cast<long double>(*best.t)) {
        best.t = static_cast<double>(t);
        best.triangle = i;
      }
    }
  }
  return best;
}

double distance_to_triangle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  const Vec3 n = (b - a).cross(c - a).normalized();
  const Vec3 corner[3] = {a, b, c};
  bool inside = true;
  double least = 1e300;
  for (int k = 0; k < 3; ++k) {
    const Vec3 side = corner[(k + 1) % 3] - corner[k];
    inside = inside && n.dot(side.cross(p - corner[k])) >= 0;
    const double s = std::clamp((p - corner[k]).dot(side) / side.squared_norm(), 0.0, 1.0);
    least = std::min(least, (p - corner[k] - s * side).norm());
  }
  return inside ? std::abs(n.dot(p - a)) : least;
}

double distance_to(const Shape& shape, const Vec3& p) {
  double least = 1e300;
  for (const auto& [a, b, c] : shape.triangles) {
    least = std::min(least, distance_to_triangle(shape.vertices[a], shape.vertices[b], shape.vertices[c], p));
  }
  return least;
}

Parabola flight_over(Dice& dice, const TriangleMesh& mesh) {
  const Vec3 low = mesh.bounds().low, high = mesh.bounds().high, size = high - low;
  const Vec3 from = low + Vec3(dice.unit() * size.x(), dice.unit() * size.y(), dice.between(1, 1.3) * size.z() + 2);
  Parabola path{from, dice.direction(), gravity};
  path.v *= dice.between(0, 15);
  return path;
}

TEST(TriangleMeshContact, OfAPointAgreesWithBruteForce) {
  Dice dice(101);
  int clear = 0;
  for (int m = 0; m < 40; ++m) {
    const Shape shape = m % 2 == 0 ? random_slope(dice, 12, 30, 0.5, 1.5) : random_boulder(dice, 2, 8, 0.2);
    const TriangleMesh mesh = shape.mesh();
    for (int i = 0; i < 200; ++i) {
      const Parabola path = flight_over(dice, mesh);
      const Brute expected = point_by_brute_force(shape, path);
      const auto contact = mesh.first_contact(path, 0, 1e6);
      if (!expected.is_clear) continue;
      ++clear;
      ASSERT_EQ(contact.has_value(), expected.t.has_value()) << m << ' ' << i;
      if (!contact) continue;
      ASSERT_NEAR(contact->t, *expected.t, 1e-9);
      ASSERT_EQ(mesh.source(contact->facet), expected.triangle);
      ASSERT_EQ(contact->feature, Feature::facet);
      ASSERT_LT((contact->normal - shape.normal(expected.triangle)).norm(), 1e-12);
    }
  }
  EXPECT_GT(clear, 7000);
}

// Until the contact a sphere touches nothing; at the contact it touches along the normal, and moves in.
TEST(TriangleMeshContact, OfASphereAgreesWithBruteForce) {
  Dice dice(102);
  int touched = 0;
  for (int m = 0; m < 30; ++m) {
    const Shape shape = m % 3 == 0   ? random_slope(dice, 8, 20, 0.5, 1.5)
                        : m % 3 == 1 ? random_boulder(dice, 1, 6, 0.2)
                                     : box({-3, -2, -1}, {3, 2, 1});
    const TriangleMesh mesh = shape.mesh();
    for (int i = 0; i < 40; ++i) {
      const double radius = dice.magnitude(0.05, 4);
      Parabola path = flight_over(dice, mesh);
      path.p.z() += radius;
      if (distance_to(shape, path.p) < radius) continue;
      const auto contact = mesh.first_contact(path, radius, 1e6);
      const double end = contact ? contact->t : 3.0;
      // It may come arbitrarily close without touching, but not deeper.
      for (int k = 0; k < 200; ++k) {
        ASSERT_GT(distance_to(shape, path.at(end * k / 200)), radius - 1e-7) << m << ' ' << i << ' ' << k;
      }
      if (!contact) continue;
      ++touched;
      const Vec3 centre = path.at(contact->t);
      ASSERT_NEAR(distance_to(shape, centre), radius, 1e-7) << m << ' ' << i;
      ASSERT_NEAR(contact->normal.norm(), 1, 1e-12);
      ASSERT_NEAR(distance_to(shape, centre - radius * contact->normal), 0, 1e-7);
      ASSERT_LT(path.velocity(contact->t).dot(contact->normal), 1e-9);
    }
  }
  EXPECT_GT(touched, 500);
}

TEST(TriangleMeshContact, TiesGoToTheFirstTriangleOfTheInput) {
  const Shape shape = box({-1, -1, -1}, {1, 1, 1});
  const TriangleMesh mesh = shape.mesh();
  // Straight down on the diagonal of the upper side, which is triangles 2 and 3.
  const auto contact = mesh.first_contact({{0, 0, 5}, {0, 0, -1}, {0, 0, 0}}, 0, 100);
  ASSERT_TRUE(contact);
  EXPECT_EQ(mesh.source(contact->facet), 2U);
  const auto sphere = mesh.first_contact({{0, 0, 5}, {0, 0, -1}, {0, 0, 0}}, 0.5, 100);
  ASSERT_TRUE(sphere);
  EXPECT_EQ(mesh.source(sphere->facet), 2U);
  EXPECT_EQ(sphere->feature, Feature::facet);
  EXPECT_DOUBLE_EQ(sphere->t, 3.5);
}

TEST(TriangleMeshContact, FeaturesOfABox) {
  const TriangleMesh mesh = box({-1, -1, -1}, {1, 1, 1}).mesh();
  const auto edge = mesh.first_contact({{1.3, 0.2, 5}, {0, 0, -1}, {0, 0, 0}}, 0.5, 100);
  ASSERT_TRUE(edge);
  EXPECT_EQ(edge->feature, Feature::edge);
  EXPECT_LT((edge->normal - Vec3(0.6, 0, 0.8)).norm(), 1e-12);
  EXPECT_NEAR(edge->t, 4 - 0.4, 1e-12);
  const auto vertex = mesh.first_contact({{1.2, 1.2, 5}, {0, 0, -1}, {0, 0, 0}}, 0.5, 100);
  ASSERT_TRUE(vertex);
  EXPECT_EQ(vertex->feature, Feature::vertex);
  EXPECT_LT((vertex->normal - Vec3(0.4, 0.4, std::sqrt(1 - 0.32))).norm(), 1e-12);
  EXPECT_FALSE(mesh.first_contact({{1.6, 0, 5}, {0, 0, -1}, {0, 0, 0}}, 0.5, 100));
  // Facets are one-sided: from inside, the rock leaves.
  EXPECT_FALSE(mesh.first_contact({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}, 0, 100));
}

TEST(TriangleMeshContact, IsNotAfterTheMaximumTime) {
  const TriangleMesh mesh = box({-1, -1, -1}, {1, 1, 1}).mesh();
  const Parabola path{{0, 0, 5}, {0, 0, -1}, {0, 0, 0}};
  EXPECT_FALSE(mesh.first_contact(path, 0, 3.9));
  EXPECT_TRUE(mesh.first_contact(path, 0, 4.1));
}

// ---- facets and their neighbours ----

TEST(TriangleMesh, OutlinesHaveTheirNeighbours) {
  Dice dice(103);
  const Shape shape = random_slope(dice, 9, 30, 0.5, 1.0);
  const TriangleMesh mesh = shape.mesh();
  int rims = 0;
  for (std::uint32_t k = 0; k < mesh.facet_count(); ++k) {
    const Outline outline = mesh.outline({k});
    ASSERT_EQ(outline.edge_count, 3);
    const auto& corners = shape.triangles[mesh.source({k})];
    Vec3 middle;
    for (const std::uint32_t v : corners) middle += shape.vertices[v] / 3;
    ASSERT_LT((outline.normal - shape.normal(mesh.source({k}))).norm(), 1e-12);
    for (const OutlineEdge& edge : outline.edges) {
      ASSERT_NEAR(edge.inward.norm(), 1, 1e-12);
      ASSERT_NEAR(edge.inward.dot(outline.normal), 0, 1e-12);
      ASSERT_GT((middle - edge.point).dot(edge.inward), 0);
      if (!edge.beyond) {
        ++rims;
        continue;
      }
      // This facet is the neighbour's neighbour, and both share two corners.
      const Outline other = mesh.outline(*edge.beyond);
      const bool knows = std::any_of(other.edges.begin(), other.edges.end(),
                                     [&](const OutlineEdge& e) { return e.beyond == FacetId{k}; });
      ASSERT_TRUE(knows);
      int shared = 0;
      for (const std::uint32_t v : corners) {
        const auto& theirs = shape.triangles[mesh.source(*edge.beyond)];
        shared += static_cast<int>(std::count(theirs.begin(), theirs.end(), v));
      }
      ASSERT_EQ(shared, 2);
    }
  }
  EXPECT_EQ(rims, 4 * 9);
  EXPECT_EQ(mesh.facet_count(), shape.triangles.size());
  EXPECT_GT(mesh.bytes(), mesh.facet_count() * 9 * sizeof(double));
}

TEST(TriangleMesh, SourcesAreAPermutation) {
  Dice dice(104);
  const Shape shape = random_slope(dice, 30, 30, 0.5, 1.0);
  const TriangleMesh mesh = shape.mesh();
  std::vector<bool> seen(shape.triangles.size(), false);
  for (std::uint32_t k = 0; k < mesh.facet_count(); ++k) {
    ASSERT_FALSE(seen[mesh.source({k})]);
    seen[mesh.source({k})] = true;
  }
}

TEST(TriangleMesh, SupportsAreAllFacetsWithinReach) {
  Dice dice(105);
  const Shape shape = random_slope(dice, 10, 20, 0.5, 1.0);
  const TriangleMesh mesh = shape.mesh();
  for (int i = 0; i < 300; ++i) {
    const double x = dice.between(1, 19), y = dice.between(1, 19), radius = dice.between(0, 2);
    const Vec3 centre(x, y, *mesh.elevation(x, y) + dice.between(-0.2, 1.2) * radius + 0.001);
    int expected = 0, found = 0;
    bool is_clear = true;
    for (const auto& [a, b, c] : shape.triangles) {
      const double d = distance_to_triangle(shape.vertices[a], shape.vertices[b], shape.vertices[c], centre);
      is_clear = is_clear && std::abs(d - radius - 0.1) > 1e-9;
      if (d <= radius + 0.1) ++expected;
    }
    mesh.supports(centre, radius, 0.1, [&](const Vec3& n, auto&&...) {
      EXPECT_NEAR(n.norm(), 1, 1e-9);
      ++found;
    });
    if (is_clear) {
      ASSERT_EQ(found, expected);
    }
  }
}

// ---- heights ----

TEST(TriangleMesh, ElevationOfAHeightField) {
  Dice dice(106);
  const auto height = [](double x, double y) { return 3 - 0.7 * x + 0.2 * y; };
  const TriangleMesh mesh = irregular_field(dice, 12, 12, 30, 30, height).mesh();
  for (int i = 0; i < 3000; ++i) {
    const double x = dice.between(0, 30), y = dice.between(0, 30);
    const auto z = mesh.elevation(x, y);
    ASSERT_TRUE(z);
    ASSERT_NEAR(*z, height(x, y), 1e-12);
  }
  EXPECT_FALSE(mesh.elevation(-0.1, 10));
  EXPECT_FALSE(mesh.elevation(10, 30.1));
}

// An overhang: a roof over a floor. Below the roof, the floor is the ground.
TEST(TriangleMesh, ElevationBelowAnOverhang) {
  Shape shape = box({-1, -1, 4}, {1, 1, 5});
  const std::uint32_t first = static_cast<std::uint32_t>(shape.vertices.size());
  shape.vertices.insert(shape.vertices.end(), {{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}});
  shape.triangles.push_back({first, first + 1, first + 2});
  shape.triangles.push_back({first, first + 2, first + 3});
  const TriangleMesh mesh = shape.mesh();
  EXPECT_DOUBLE_EQ(*mesh.elevation(0.3, 0.1), 5);
  EXPECT_DOUBLE_EQ(*mesh.elevation(0.3, 0.1, 3), 0);
  EXPECT_DOUBLE_EQ(*mesh.elevation(3, 3), 0);
}

template <class Surface>
double greatest_by_sampling(const Surface& surface, const Parabola& path, double t_end) {
  double highest = 0;
  for (int k = 0; k <= 20'000; ++k) {
    const Vec3 q = path.at(t_end * k / 20'000);
    if (const auto z = surface.elevation(q.x(), q.y(), q.z() + 1e-9)) highest = std::max(highest, q.z() - *z);
  }
  return highest;
}

TEST(TriangleMesh, MaximumHeightAgreesWithSampling) {
  Dice dice(107);
  for (int m = 0; m < 6; ++m) {
    const TriangleMesh mesh = random_slope(dice, 15, 40, 0.6, 1.0).mesh();
    for (int i = 0; i < 15; ++i) {
      const double x = dice.between(10, 30), y = dice.between(10, 30);
      Parabola path{{x, y, *mesh.elevation(x, y) + 1}, dice.in_cube(12), gravity};
      path.v.z() = std::abs(path.v.z());
      const auto contact = mesh.first_contact(path, 0, 1e6);
      const double end = contact ? contact->t : mesh.exit(path).t;
      const double expected = greatest_by_sampling(mesh, path, end), found = mesh.max_height(path, end, 0);
      ASSERT_GE(found, expected - 1e-9);
      ASSERT_NEAR(found, expected, 0.01);
      EXPECT_EQ(mesh.max_height(path, end, 1e4), 1e4);  // a larger known height is returned
    }
  }
}

// ---- exits ----

TEST(TriangleMesh, ExitIsWhereTheCentreCrossesTheRim) {
  Dice dice(108);
  const TriangleMesh mesh = random_slope(dice, 10, 40, 0.2, 0.2).mesh();
  for (int i = 0; i < 500; ++i) {
    Parabola path{{dice.between(1, 39), dice.between(1, 39), 200}, dice.in_cube(30), gravity};
    if (mesh.first_contact(path, 0, 1e6)) continue;
    const Exit exit = mesh.exit(path);
    EXPECT_FALSE(exit.beneath);
    const Vec3 q = path.at(exit.t);
    const double out = std::max({-q.x(), q.x() - 40, -q.y(), q.y() - 40});
    ASSERT_NEAR(out, 0, 1e-9);
  }
}

TEST(TriangleMesh, ExitBelowTheSurfaceIsLost) {
  Dice dice(109);
  const TriangleMesh mesh = random_slope(dice, 10, 40, 0.2, 0.2).mesh();
  const Exit exit = mesh.exit({{20, 20, mesh.bounds().low.z() - 1}, {0, 0, 0}, gravity});
  EXPECT_TRUE(exit.beneath);
}

TEST(TriangleMesh, ExitOfACentreBeyondTheRimIsAtOnce) {
  Dice dice(110);
  const TriangleMesh mesh = random_slope(dice, 10, 40, 0.2, 0.2).mesh();
  const Exit exit = mesh.exit({{40.2, 20, -5}, {1, 0, 0}, gravity});
  EXPECT_EQ(exit.t, 0);
  EXPECT_FALSE(exit.beneath);
}

// ---- draping ----

TEST(TriangleMesh, DrapedFollowsTheGround) {
  Dice dice(111);
  const Shape shape = random_slope(dice, 14, 30, 0.5, 1.0);
  const TriangleMesh mesh = shape.mesh();
  for (int i = 0; i < 100; ++i) {
    const Vec2 from(dice.between(0, 30), dice.between(0, 30)), to(dice.between(0, 30), dice.between(0, 30));
    const auto line = mesh.draped(from, to);
    ASSERT_GE(line.size(), 2U);
    ASSERT_LT((line.front().xy() - from).norm(), 1e-6);
    ASSERT_LT((line.back().xy() - to).norm(), 1e-6);
    for (std::size_t k = 0; k + 1 < line.size(); ++k) {
      // The ground is straight between two bends.
      for (const double s : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const Vec3 q = line[k] + s * (line[k + 1] - line[k]);
        ASSERT_NEAR(*mesh.elevation(q.x(), q.y()), q.z(), 1e-6) << i << ' ' << k;
      }
      ASSERT_GT((line[k + 1] - line[k]).xy().dot(to - from), 0);
    }
  }
}

TEST(TriangleMesh, DrapedEndsWhereTheGroundEnds) {
  Dice dice(112);
  const TriangleMesh mesh = random_slope(dice, 14, 30, 0.5, 1.0).mesh();
  const auto line = mesh.draped({-10, 15}, {50, 15});
  ASSERT_GE(line.size(), 2U);
  EXPECT_NEAR(line.front().x(), 0, 1e-6);
  EXPECT_NEAR(line.back().x(), 30, 1e-6);
}

}  // namespace
}  // namespace talus::triangle_mesh_test
