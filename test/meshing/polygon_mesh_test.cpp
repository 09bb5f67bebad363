#include "talus/meshing/polygon_mesh.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/dice.hpp"
#include "talus/core/problems.hpp"
#include "talus/meshing/cleaning.hpp"

namespace talus::polygon_mesh_test {
namespace {

using namespace testing_tools;
using ::testing::HasSubstr;

SpacePolygon polygon(std::vector<Vec3> ring, const std::string& name = "polylines[0]") {
  return {name, {std::move(ring)}};
}

RawMesh cut(const std::vector<SpacePolygon>& polygons, PolygonReport* report = nullptr) {
  PolygonReport own;
  return triangulated(polygons, "bowl.toml", report ? *report : own);
}

std::string refusal(const std::vector<SpacePolygon>& polygons) {
  try {
    static_cast<void>(cut(polygons));
  } catch (const BadInput& bad) {
    return bad.what();
  }
  return "accepted";
}

Vec3 area_of(const RawMesh& mesh) {
  Vec3 sum;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += 0.5 * (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]);
  }
  return sum;
}

double surface_of(const RawMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += 0.5 * (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm();
  }
  return sum;
}

TEST(PolygonMesh, ATriangleIsKept) {
  const RawMesh mesh = cut({polygon({{-10, 10, 16.32993}, {10, 10, 16.32993}, {0, 4.226497, 0}})});
  ASSERT_EQ(mesh.triangles.size(), 1U);
  EXPECT_EQ(mesh.vertices[0], Vec3(-10, 10, 16.32993));
  EXPECT_EQ(mesh.vertices[1], Vec3(10, 10, 16.32993));
  EXPECT_EQ(mesh.vertices[2], Vec3(0, 4.226497, 0));
}

// Star-shaped polygons in any plane, also vertical: n - 2 triangles, whose areas add up.
TEST(PolygonMesh, TriangulatesConcavePolygonsInAnyPlane) {
  Dice dice(41);
  for (int i = 0; i < 200; ++i) {
    const Map3 turn = i % 4 == 0 ? turn_about(unit_x, std::numbers::pi / 2) : dice.turn();
    const Vec3 move = dice.in_cube(1e4);
    const std::size_t corners = 3 + dice.below(60);
    std::vector<Vec3> ring;
    double area = 0;
    for (std::size_t k = 0; k < corners; ++k) {
      const double angle =
          2 * std::numbers::pi * (static_cast<double>(k) + 0.8 * dice.unit()) / static_cast<double>(corners);
      const double r = dice.between(1, 10);
      ring.emplace_back(r * std::cos(angle), r * std::sin(angle), 0);
    }
    for (std::size_t k = 0; k < corners; ++k) area += 0.5 * ring[k].cross(ring[(k + 1) % corners]).z();
    if (area < 0.1) continue;  // a ring of few corners may miss the centre
    for (Vec3& p : ring) p = turn * p + move;
    const RawMesh mesh = cut({polygon(ring)});
    EXPECT_EQ(mesh.triangles.size(), corners - 2);
    EXPECT_EQ(mesh.vertices, ring);
    EXPECT_NEAR(surface_of(mesh), area, 1e-6 * area);
    EXPECT_NEAR(area_of(mesh).norm(), area, 1e-6 * area);  // all face one way
  }
}

TEST(PolygonMesh, HolesStayOpen) {
  const SpacePolygon ring{
      "feature 1", {{{0, 0, 0}, {10, 0, 5}, {10, 10, 5}, {0, 10, 0}}, {{2, 2, 1}, {4, 2, 2}, {4, 4, 2}, {2, 4, 1}}}};
  const RawMesh mesh = cut({ring});
  EXPECT_EQ(mesh.triangles.size(), 8U);
  EXPECT_NEAR(std::abs(area_of(mesh).z()), 96, 1e-9);
}

TEST(PolygonMesh, TriangulatesManyCorners) {
  std::vector<Vec3> ring;
  for (int k = 0; k < 20000; ++k) {
    const double angle = 2 * std::numbers::pi * k / 20000;
    ring.emplace_back(100 * (1.5 + std::sin(40 * angle)) * std::cos(angle),
                      100 * (1.5 + std::sin(40 * angle)) * std::sin(angle), 3);
  }
  EXPECT_EQ(cut({polygon(ring)}).triangles.size(), 19998U);
}

TEST(PolygonMesh, ReportsBentPolygons) {
  PolygonReport report;
  static_cast<void>(cut({polygon({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0.004}}),
                         polygon({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 2}})},
                        &report));
  EXPECT_EQ(report.bent.count, 1U);
  EXPECT_NEAR(report.largest_departure_m, 0.5, 0.01);
  EXPECT_THAT(report.text(),
              HasSubstr("polygons: 2, cut into 4 triangles; corners lie within 0.5 m of their polygon's plane\n"
                        "warning: 1 polygon is not plane and bent along the cuts, at (5.000, 5.000, 0.500)"));
}

TEST(PolygonMesh, IsMergedWithinATolerance) {
  // Two squares that share a side, a millimetre apart.
  const RawMesh mesh = cut({polygon({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}}),
                            polygon({{10.0005, 0, 0}, {20, 0, 5}, {20, 10, 5}, {10, 10.0005, 0}})});
  EXPECT_EQ(clean(mesh, {.source = "", .weld_tolerance_m = 0}).report.components, 2U);
  const CleanMesh merged = clean(mesh, {.source = "", .weld_tolerance_m = 0.001});
  EXPECT_EQ(merged.report.components, 1U);
  EXPECT_EQ(merged.report.welded_vertices, 2U);
  EXPECT_EQ(merged.report.boundary_edges, 6U);
}

TEST(PolygonMesh, RefusesPolygonsThatCannotBeCutWithTheirPlaces) {
  EXPECT_EQ(refusal({polygon({{0, 0, 0}, {10, 10, 0}, {10, 0, 0}, {0, 10.5, 0}}, "polylines[3]")}),
            "bowl.toml: terrain: polylines[3] crosses itself at (5.122, 5.122, 0.000) (it cannot be triangulated). Are "
            "its vertices in order?");
  EXPECT_EQ(refusal({polygon({{0, 0, 0}, {1, 1, 1}})}),
            "bowl.toml: terrain: polylines[0] has 2 corners (a polygon has three or more)");
  EXPECT_EQ(refusal({polygon({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {7, 7, 7}})}),
            "bowl.toml: terrain: polylines[0] has no area (its corners lie on one line, its border doubles back, or "
            "its sides cross)");
  // A repeated corner, and a side through a corner.
  EXPECT_EQ(
      refusal({polygon({{0, 0, 0}, {4, 0, 0}, {2, 2, 0}, {4, 4, 0}, {0, 4, 0}, {2, 2, 0}})}),
      "bowl.toml: terrain: polylines[0] touches itself at (2.000, 2.000, 0.000) (a polygon may pass each place only "
      "once). Split it in two there");
  EXPECT_EQ(
      refusal({polygon({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 0, 0}, {0, 4, 0}})}),
      "bowl.toml: terrain: polylines[0] touches itself at (2.000, 0.000, 0.000) (a polygon may pass each place only "
      "once). Split it in two there");
  EXPECT_EQ(
      refusal({polygon({{0, 0, 0}, {4e9, 0, 0}, {4, 4, 0}})}),
      "bowl.toml: terrain: polylines[0] has the corner (4000000000.000, 0.000, 0.000) (coordinates must be smaller "
      "than 1e+09 m). Are they in metres?");
}

TEST(PolygonMesh, ReportsTenProblemsAndCountsTheOthers) {
  std::vector<SpacePolygon> polygons;
  for (int k = 0; k < 13; ++k) polygons.push_back(polygon({{0, 0, 0}, {1, 1, 1}}));
  const std::string text = refusal(polygons);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 10);
  EXPECT_THAT(text, HasSubstr("bowl.toml: terrain: 3 more polygons have problems"));
}

}  // namespace
}  // namespace talus::polygon_mesh_test
