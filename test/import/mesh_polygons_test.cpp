#include "talus/import/mesh_polygons.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

#include "support/mesh_files.hpp"

namespace talus {
namespace {

using namespace testing_tools;
using Corners = std::array<std::uint32_t, 3>;
using ::testing::ElementsAre;

double area_in_plan(const RawMesh& mesh) {
  double sum = 0;
  for (const Corners& t : mesh.triangles) {
    const Vec3 a = mesh.vertices[t[1]] - mesh.vertices[t[0]];
    const Vec3 b = mesh.vertices[t[2]] - mesh.vertices[t[0]];
    sum += a.cross(b).z() / 2;
  }
  return sum;
}

class MeshPolygons : public MeshFiles {};

TEST_F(MeshPolygons, ConvexFacesBecomeFans) {
  EXPECT_THAT(read("a.obj", square_obj + "f 1 2 3 4\n").triangles, ElementsAre(Corners{0, 1, 2}, Corners{0, 2, 3}));
}

TEST_F(MeshPolygons, ConcaveFacesAreCutIntoTrianglesInside) {
  // An L, which a fan from its first corner does not cover.
  const std::string vertices = "v 2 1 5\nv 1 1 5\nv 1 2 5\nv 0 2 5\nv 0 0 5\nv 2 0 5\n";
  const RawMesh mesh = read("a.obj", vertices + "f 1 2 3 4 5 6\n");
  EXPECT_EQ(mesh.triangles.size(), 4U);
  EXPECT_DOUBLE_EQ(area_in_plan(mesh), 3.0);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    RawMesh one{mesh.vertices, {mesh.triangles[i]}};
    EXPECT_GT(area_in_plan(one), 0) << i;
  }
  EXPECT_DOUBLE_EQ(area_in_plan(read("b.obj", vertices + "f 6 5 4 3 2 1\n")), -3.0);
}

TEST_F(MeshPolygons, RandomStarShapedFacesKeepTheirAreaInAnyPlane) {
  std::mt19937_64 random{7};
  std::uniform_real_distribution<double> radius{0.1, 10};
  for (int trial = 0; trial < 200; ++trial) {
    const int corners = 4 + trial % 30;
    const Vec3 u = Vec3{radius(random), radius(random), radius(random)}.normalized();
    const Vec3 v = u.cross(unit_z).normalized();
    std::string bytes;
    std::string face = "f";
    std::vector<Vec3> points;
    Vec3 doubled_area;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners;
      const Vec3 p = Vec3{2'600'000, 1'200'000, 500} + radius(random) * (std::cos(angle) * u + std::sin(angle) * v);
      points.push_back(p);
      std::array<char, 120> line{};
      std::snprintf(line.data(), line.size(), "v %.17g %.17g %.17g\n", p.x(), p.y(), p.z());
      bytes += line.data();
      face += " " + std::to_string(i + 1);
    }
    for (int i = 0; i < corners; ++i)
      doubled_area += (points[i] - points[0]).cross(points[(i + 1) % corners] - points[0]);
    const RawMesh mesh = read("a.obj", bytes + face + "\n");
    ASSERT_EQ(mesh.triangles.size(), static_cast<std::size_t>(corners) - 2);
    double sum = 0;  // of absolute areas: equal to the face's only if no triangles overlap
    for (const Corners& t : mesh.triangles) {
      sum += (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]).norm();
    }
    EXPECT_NEAR(sum, doubled_area.norm(), 1e-6) << trial;
  }
}

TEST_F(MeshPolygons, CornersInLineWithTheirNeighboursGetTrianglesWithArea) {
  // (1 0 0) is on the side of the square; a fan from (0 0 0) would have a triangle without area.
  const RawMesh mesh = read("a.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4 5\n");
  EXPECT_EQ(mesh.triangles.size(), 3U);
  for (const Corners& t : mesh.triangles) EXPECT_GT(area_in_plan({mesh.vertices, {t}}), 0.5);
}

TEST_F(MeshPolygons, RepeatedCornersAreDropped) {
  EXPECT_THAT(read("a.obj", square_obj + "f 1 2 2 3 1\n").triangles, ElementsAre(Corners{0, 1, 2}));
  EXPECT_THAT(read("b.obj", square_obj + "f 1 2 2 1\n").triangles, ElementsAre(Corners{0, 1, 1}));
}

TEST_F(MeshPolygons, RefusesFacesThatCannotBeCut) {
  EXPECT_EQ(refusal("a.obj", "v 0 0 0\nv 2 2 0\nv 2 0 0\nv 0 1 0\nf 1 2 3 4\n"),
            "a.obj:5: a face with 4 corners crosses itself (it cannot be triangulated). Triangulate it in the program "
            "that made it");
  EXPECT_EQ(refusal("a.obj", "v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 4\n"),
            "a.obj:5: a face with 4 corners crosses itself (it cannot be triangulated). Triangulate it in the program "
            "that made it");
  std::string many = "f";
  for (int i = 0; i < 1001; ++i) many += i % 2 == 0 ? " 1" : " 2";
  EXPECT_EQ(refusal("a.obj", square_obj + many + "\n"),
            "a.obj:5: a face with 1001 corners (Talus triangulates faces of up to 1000). Triangulate it in the "
            "program that made it");
}

}  // namespace
}  // namespace talus
