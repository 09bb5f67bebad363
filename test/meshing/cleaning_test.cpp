#include "talus/meshing/cleaning.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "support/raw_meshes.hpp"

namespace talus::cleaning_test {
namespace {

using namespace testing_tools;
using ::testing::ElementsAre;

// ---- facets that are left out ----

TEST(Cleaning, DropsDegenerateAndRepeatedFacetsAndKeepsTheOrder) {
  RawMesh mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 5e-10, 0}, {9, 9, 9}, {0, 0, 0}},
               {{0, 1, 1},    // a repeated corner
                {0, 1, 2},    //
                {0, 4, 1},    // a sliver, half a nanometre high
                {2, 0, 1},    // repeats the second
                {1, 0, 2},    // repeats it with the other winding
                {0, 6, 3},    // two corners at one place
                {3, 0, 2}}};  //
  const CleanMesh cleaned = clean(mesh);
  expect_sound(cleaned);
  EXPECT_THAT(cleaned.original, ElementsAre(1U, 6U));
  EXPECT_THAT(cleaned.triangles, ElementsAre(RawTriangle{0, 1, 2}, RawTriangle{3, 0, 2}));
  EXPECT_EQ(cleaned.report.degenerate.count, 3U);
  EXPECT_EQ(cleaned.report.duplicates.count, 2U);
  EXPECT_EQ(cleaned.report.welded_vertices, 1U);
  EXPECT_EQ(cleaned.report.unused_vertices, 2U);
  EXPECT_EQ(cleaned.vertices.size(), 4U);
  EXPECT_EQ(cleaned.report.text(),
            "2 facets, 4 vertices, 1 component (0 closed), 4 boundary edges; every facet faces up\n"
            "welded: 1 vertex at the position of another\n"
            "left out: 2 vertices that no facet uses\n"
            "left out: 3 facets without area, at (0.667, 0.000, 0.000), (0.500, 0.000, 0.000), (0.000, 0.333, 0.000)\n"
            "left out: 2 facets that repeat another, at (0.667, 0.333, 0.000), (0.667, 0.333, 0.000)");
}

TEST(Cleaning, SliversAreMeasuredByTheirHeight) {
  const auto with_height = [](double height, const Vec3& at) {
    const RawMesh mesh{{at, at + Vec3{100, 0, 0}, at + Vec3{0, 100, 0}, at + Vec3{50, -height, 0}},
                       {{0, 1, 2}, {0, 3, 1}}};
    return clean(mesh).report.degenerate.count;
  };
  EXPECT_EQ(with_height(0.9e-9, Vec3{}), 1U);
  EXPECT_EQ(with_height(1.1e-9, Vec3{}), 0U);
  // Far from the origin such heights are below the rounding of the coordinates.
  EXPECT_EQ(with_height(1.1e-9, {2'600'000, 1'200'000, 0}), 1U);
  EXPECT_EQ(with_height(1e-8, {2'600'000, 1'200'000, 0}), 0U);
}

TEST(Cleaning, LeavesLargeCoordinatesUnchanged) {
  std::mt19937_64 random{10};
  const RawMesh mesh = random_tin(8, random, Vec3{2'600'000.123456, 1'200'000.654321, 450});
  const CleanMesh cleaned = clean(mesh);
  EXPECT_EQ(cleaned.vertices, mesh.vertices);
  EXPECT_EQ(cleaned.triangles, mesh.triangles);
}

// ---- report and refusals ----

TEST(Cleaning, ReportsWhatToCheck) {
  RawMesh fin{{{0, -1, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 0}, {0, 0, 1}}, {{0, 1, 2}, {0, 3, 1}, {0, 1, 4}}};
  EXPECT_EQ(
      clean(joined(fin, moebius_strip(4))).report.text(),
      "11 facets, 13 vertices, 4 components (0 closed), 14 boundary edges; 3 vertical and 0 overhanging\n"
      "vertical: 3 facets, at (0.000, 0.000, 0.333), (-2.000, 0.764, -0.236), (-2.000, -0.764, 0.236)\n"
      "flipped to face out of the ground: 3 facets, at (0.667, 2.000, 0.000), (2.000, 1.236, 0.236), (-1.000, "
      "2.000, 0.333)\n"
      "warning: 1 edge has more than two facets (it is not known which of them are neighbours), at (0.000, 0.000, "
      "0.000)\n"
      "warning: 1 boundary edge lies below another facet and above none (a rock that slides or rolls to it leaves the "
      "model there), at (-1.500, 1.146, -0.854)\n"
      "warning: 1 component has one side only, like a Moebius strip (each facet was turned to face up), at (0.667, "
      "2.000, 0.000)\n"
      "warning: 1 component has no clear outer side (no area in plan, or no volume; the winding of most facets was "
      "kept), at (0.000, 0.000, 0.333)");
  EXPECT_EQ(clean(raw_box({0, 0, 0}, {1, 1, 1})).report.text(),
            "12 facets, 8 vertices, 1 component (1 closed), 0 boundary edges; 8 vertical and 2 overhanging\n"
            "vertical: 8 facets, for example at (0.667, 0.000, 0.333), (0.333, 0.000, 0.667), (0.333, 1.000, 0.333)\n"
            "overhanging: 2 facets, at (0.333, 0.667, 0.000), (0.667, 0.333, 0.000)");
}

// Two facets on a side of a third, one of them 2 mm off it.
TEST(Cleaning, ReportsCornersOnSidesAndCracks) {
  const RawMesh mesh{{{0, 0, 0}, {2, 0, 0}, {2, 4, 0}, {2, 2, 0}, {5, 1, 0}, {2.002, 2.1, 0}, {2.002, 4, 0}, {5, 3, 0}},
                     {{0, 1, 2}, {1, 4, 3}, {5, 7, 6}}};
  const CleanMesh cleaned = clean(mesh, {.source = "", .weld_tolerance_m = 0.001});
  expect_sound(cleaned);
  EXPECT_TRUE(cleaned.report.has_warnings());
  EXPECT_THAT(cleaned.original, ElementsAre(0U, 0U, 1U, 2U));
  EXPECT_EQ(
      cleaned.report.text(),
      "4 facets, 8 vertices, 2 components (0 closed), 8 boundary edges; every facet faces up\n"
      "joined: 1 corner on the side of another facet, which was split there, at (2.000, 2.000, 0.000)\n"
      "warning: 2 boundary edges lie within 0.01 m of another facet (a crack: a rock that slides or rolls to it may "
      "leave the model there), at (2.000, 3.000, 0.000), (2.002, 3.050, 0.000)");
}

TEST(Cleaning, RefusesMeshesThatCannotBeCleaned) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const RawMesh good{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  EXPECT_EQ(refusal({}),
            "slope.obj: terrain: the mesh has no vertices (expected at least three)\n"
            "slope.obj: terrain: the mesh has no triangles (expected at least one)");
  EXPECT_EQ(refusal({good.vertices, {}}), "slope.obj: terrain: the mesh has no triangles (expected at least one)");
  RawMesh mesh = good;
  mesh.vertices[1].y() = nan;
  mesh.vertices[2].z() = -inf;
  mesh.triangles.push_back({0, 1, 3});
  EXPECT_EQ(refusal(mesh),
            "slope.obj: vertex 1 (zero-based): (1, nan, 0) is not a position (expected finite coordinates in metres)\n"
            "slope.obj: vertex 2 (zero-based): (0, 1, -inf) is not a position (expected finite coordinates in metres)\n"
            "slope.obj: triangle 1 (zero-based): vertex 3 does not exist (the mesh has 3 vertices, numbered from 0)");
  mesh = good;
  mesh.vertices[0].x() = -1e9;
  EXPECT_EQ(
      refusal(mesh),
      "slope.obj: vertex 0 (zero-based): (-1000000000, 0, 0) is too far from the origin (coordinates must be smaller "
      "than 1e+09 m). Are they in metres?");
  EXPECT_EQ(refusal({good.vertices, {{0, 1, 1}, {2, 2, 2}}}, {}),
            "terrain: the mesh has no facet with an area (all 2 repeat a corner or are lower than 1e-09 m). Are its "
            "coordinates in metres?");
}

TEST(Cleaning, ReportsOnlyTheFirstOfManyBadVertices) {
  RawMesh mesh{std::vector<Vec3>(1000, Vec3::all(std::numeric_limits<double>::quiet_NaN())), {{0, 1, 2}}};
  const std::string text = refusal(mesh);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 10);
  EXPECT_THAT(text, ::testing::EndsWith("\nslope.obj: 990 more of this kind"));
}

// Triangles between few vertices, many at one place or in line: every kind of defect at once.
TEST(Cleaning, RandomTanglesAreRepairedOrRefused) {
  std::mt19937_64 random{11};
  int cleaned_count = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    RawMesh mesh;
    const std::size_t vertices = 3 + random() % 12;
    for (std::size_t i = 0; i < vertices; ++i) {
      mesh.vertices.emplace_back(static_cast<double>(random() % 3), static_cast<double>(random() % 3),
                                 static_cast<double>(random() % 3));
    }
    for (std::size_t i = 0; i < 30; ++i) {
      RawTriangle t{};
      for (std::uint32_t& v : t) v = static_cast<std::uint32_t>(random() % vertices);
      mesh.triangles.push_back(t);
    }
    try {
      const CleanMesh cleaned = clean(mesh);
      expect_sound(cleaned);
      EXPECT_FALSE(cleaned.report.text().empty());
      EXPECT_EQ(cleaned.report.facets + cleaned.report.degenerate.count + cleaned.report.duplicates.count, 30U);
      ++cleaned_count;
    } catch (const BadInput& error) {
      EXPECT_THAT(error.what(), ::testing::HasSubstr("no facet with an area"));
    }
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(cleaned_count, 1500);
}

}  // namespace
}  // namespace talus::cleaning_test
