#include "talus/meshing/weld.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/raw_meshes.hpp"

namespace talus::weld_test {
namespace {

using namespace testing_tools;
using ::testing::ElementsAre;

TEST(Weld, UnsharedVerticesBecomeTheIndexedMesh) {
  std::mt19937_64 random{6};
  RawMesh mesh = random_tin(10, random);
  flip_at_random(mesh, random);
  const CleanMesh indexed = clean(mesh);
  const CleanMesh welded_soup = clean(soup(mesh));
  expect_sound(welded_soup);
  EXPECT_EQ(welded_soup.report.welded_vertices, 600U - 121U);
  EXPECT_EQ(welded_soup.vertices.size(), indexed.vertices.size());
  ASSERT_EQ(welded_soup.triangles.size(), indexed.triangles.size());
  EXPECT_EQ(welded_soup.neighbours, indexed.neighbours);
  for (std::size_t i = 0; i < indexed.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(welded_soup.vertices[welded_soup.triangles[i][k]], indexed.vertices[indexed.triangles[i][k]]);
    }
  }
}

TEST(Weld, ZeroEqualsMinusZero) {
  EXPECT_THAT(welded({{0.0, 1, 2}, {-0.0, 1, 2}, {0.0, 1, 3}}, 0), ElementsAre(0U, 0U, 2U));
}

TEST(Weld, MergesVerticesOnlyWithinTheTolerance) {
  std::mt19937_64 random{8};
  std::uniform_real_distribution<double> shake{-1e-4, 1e-4};
  RawMesh mesh = soup(random_tin(10, random, Vec3{2'600'000, 1'200'000, 500}));
  for (Vec3& v : mesh.vertices) v += Vec3{shake(random), shake(random), shake(random)};
  const CleanMesh apart = clean(mesh);
  EXPECT_EQ(apart.report.components, 200U);
  EXPECT_EQ(apart.report.welded_vertices, 0U);
  const CleanMesh together = clean(mesh, {.source = "", .weld_tolerance_m = 1e-3});
  expect_sound(together);
  EXPECT_EQ(together.report.components, 1U);
  EXPECT_EQ(together.vertices.size(), 121U);
  EXPECT_EQ(together.report.boundary_edges, 40U);
}

TEST(Weld, VerticesMoveNoFurtherThanTheToleranceAndKeptOnesAreFurtherApart) {
  std::mt19937_64 random{9};
  std::uniform_real_distribution<double> place{-1, 1};
  std::vector<Vec3> vertices;
  for (int i = 0; i < 600; ++i) vertices.emplace_back(place(random), place(random), 0.1 * place(random));
  const double tolerance = 0.1;
  const std::vector<std::uint32_t> representative = welded(vertices, tolerance);
  std::size_t kept = 0;
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    EXPECT_LE((vertices[representative[i]] - vertices[i]).norm(), tolerance);
    EXPECT_EQ(representative[representative[i]], representative[i]);
    if (representative[i] != i) continue;
    ++kept;
    for (std::uint32_t j = 0; j < i; ++j) {
      if (representative[j] == j) {
        EXPECT_GT((vertices[i] - vertices[j]).norm(), tolerance);
      }
    }
  }
  EXPECT_GT(kept, 50U);
  EXPECT_LT(kept, 400U);
}

}  // namespace
}  // namespace talus::weld_test
