#include "talus/meshing/cleaning.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>

#include "talus/core/problems.hpp"
#include "talus/meshing/weld.hpp"

namespace talus {
namespace {

using Triangle = std::array<std::uint32_t, 3>;
using ::testing::ElementsAre;

Vec3 normal(const CleanMesh& mesh, std::size_t i) {
  const Triangle& t = mesh.triangles[i];
  const Vec3& a = mesh.vertices[t[0]];
  return (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).normalized();
}

// What must hold of every cleaned mesh: indices exist, neighbours know each other across one and the same edge, and run
// along it in opposite directions (unless the sheet has one side only).
void expect_sound(const CleanMesh& mesh) {
  ASSERT_EQ(mesh.neighbours.size(), mesh.triangles.size());
  ASSERT_EQ(mesh.original.size(), mesh.triangles.size());
  EXPECT_TRUE(std::is_sorted(mesh.original.begin(), mesh.original.end()));
  EXPECT_EQ(mesh.report.facets, mesh.triangles.size());
  EXPECT_EQ(mesh.report.vertices, mesh.vertices.size());
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      ASSERT_LT(mesh.triangles[i][k], mesh.vertices.size());
      if (!mesh.neighbours[i][k]) continue;
      const std::uint32_t from = mesh.triangles[i][k];
      const std::uint32_t to = mesh.triangles[i][(k + 1) % 3];
      const std::uint32_t j = (*mesh.neighbours[i][k]).index;
      ASSERT_LT(j, mesh.triangles.size());
      int found = 0;
      for (std::size_t m = 0; m < 3; ++m) {
        const std::uint32_t a = mesh.triangles[j][m];
        const std::uint32_t b = mesh.triangles[j][(m + 1) % 3];
        if (!((a == to && b == from) || (a == from && b == to))) continue;
        ++found;
        EXPECT_EQ(mesh.neighbours[j][m], Neighbour{FacetId{i}});
        if (mesh.report.one_sided_components.count == 0) {
          EXPECT_EQ(a, to) << "facets " << i << " and " << j;
        }
      }
      EXPECT_EQ(found, 1);
    }
  }
}

// A random TIN: a grid of n by n cells with jittered vertices and random heights; all windings up (vertices move by
// less than a quarter of a cell, so no triangle can turn over).
RawMesh random_tin(std::uint32_t n, std::mt19937_64& random, const Vec3& origin = Vec3::Zero()) {
  std::uniform_real_distribution<double> jitter{-0.2, 0.2};
  RawMesh mesh;
  for (std::uint32_t y = 0; y <= n; ++y) {
    for (std::uint32_t x = 0; x <= n; ++x) {
      mesh.vertices.push_back(origin + Vec3{x + jitter(random), y + jitter(random), 5 * jitter(random)});
    }
  }
  for (std::uint32_t y = 0; y < n; ++y) {
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t a = y * (n + 1) + x;
      mesh.triangles.push_back({a, a + 1, a + n + 2});
      mesh.triangles.push_back({a, a + n + 2, a + n + 1});
    }
  }
  return mesh;
}

void flip_at_random(RawMesh& mesh, std::mt19937_64& random) {
  for (Triangle& t : mesh.triangles) {
    if (random() % 2 == 0) std::swap(t[0], t[1]);
  }
}

// Every triangle with vertices of its own, as in STL.
RawMesh soup(const RawMesh& mesh) {
  RawMesh out;
  for (const Triangle& t : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(out.vertices.size());
    for (const std::uint32_t v : t) out.vertices.push_back(mesh.vertices[v]);
    out.triangles.push_back({first, first + 1, first + 2});
  }
  return out;
}

void add_quad(RawMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}

// A box with one corner at `at`; normals out.
RawMesh box(const Vec3& at, const Vec3& size) {
  RawMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.push_back(at + Vec3{i % 2 * size.x(), i / 2 % 2 * size.y(), i / 4 * size.z()});
  }
  add_quad(mesh, 0, 2, 3, 1);
  add_quad(mesh, 4, 5, 7, 6);
  add_quad(mesh, 0, 1, 5, 4);
  add_quad(mesh, 3, 2, 6, 7);
  add_quad(mesh, 2, 0, 4, 6);
  add_quad(mesh, 1, 3, 7, 5);
  return mesh;
}

RawMesh joined(RawMesh a, const RawMesh& b) {
  const auto offset = static_cast<std::uint32_t>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const Triangle& t : b.triangles) a.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  return a;
}

// A profile (x, z) extruded along y by one step of 1 m; strips of two triangles.
RawMesh extruded(const std::vector<Vec2>& profile, bool closed = false) {
  RawMesh mesh;
  for (const Vec2& p : profile) {
    mesh.vertices.emplace_back(p.x(), 0, p.y());
    mesh.vertices.emplace_back(p.x(), 1, p.y());
  }
  const auto n = static_cast<std::uint32_t>(profile.size());
  for (std::uint32_t i = 0; i + (closed ? 0 : 1) < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    add_quad(mesh, 2 * i, 2 * j, 2 * j + 1, 2 * i + 1);
  }
  return mesh;
}

RawMesh moebius_strip(std::uint32_t steps) {
  RawMesh mesh;
  for (std::uint32_t i = 0; i < steps; ++i) {
    const double angle = 2 * std::numbers::pi * i / steps;
    for (const double side : {-1.0, 1.0}) {
      const double radius = 3 + side * std::cos(angle / 2);
      mesh.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle), side * std::sin(angle / 2));
    }
  }
  for (std::uint32_t i = 0; i + 1 < steps; ++i) add_quad(mesh, 2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1);
  add_quad(mesh, 2 * steps - 2, 1, 0, 2 * steps - 1);
  return mesh;
}

std::string refusal(RawMesh mesh, const CleaningOptions& options = {.source = "slope.obj"}) {
  try {
    static_cast<void>(clean(std::move(mesh), options));
  } catch (const BadInput& error) {
    return error.what();
  }
  return "was cleaned";
}

// ---- winding ----

TEST(Cleaning, RandomWindingsOfATinAllComeBackUp) {
  std::mt19937_64 random{1};
  for (int trial = 0; trial < 20; ++trial) {
    RawMesh mesh = random_tin(12, random, Vec3{2'600'000, 1'200'000, 500});
    const RawMesh original = mesh;
    flip_at_random(mesh, random);
    std::size_t flipped = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) flipped += mesh.triangles[i] != original.triangles[i];
    const CleanMesh cleaned = clean(mesh);
    expect_sound(cleaned);
    EXPECT_EQ(cleaned.report.flipped.count, flipped);
    EXPECT_TRUE(cleaned.report.every_facet_faces_up());
    EXPECT_EQ(cleaned.report.components, 1U);
    EXPECT_EQ(cleaned.report.closed_components, 0U);
    EXPECT_EQ(cleaned.report.boundary_edges, 48U);
    EXPECT_FALSE(cleaned.report.has_warnings());
    for (std::size_t i = 0; i < cleaned.triangles.size(); ++i) ASSERT_GT(normal(cleaned, i).z(), 0);
  }
}

TEST(Cleaning, NeighboursAreThoseAcrossEachEdge) {
  // The second triangle is given the wrong way round: after it is turned, its edges stand in another order.
  const CleanMesh mesh = clean({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {2, 0, 3}, {0, 3, 2}}});
  expect_sound(mesh);
  EXPECT_THAT(mesh.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{2, 3, 0}));
  const Neighbour none;
  EXPECT_EQ(mesh.neighbours[0], (std::array<Neighbour, 3>{none, none, Neighbour{FacetId{1}}}));
  EXPECT_EQ(mesh.neighbours[1], (std::array<Neighbour, 3>{none, none, Neighbour{FacetId{0}}}));
  EXPECT_FALSE(none.has_value());
}

TEST(Cleaning, ABoxFacesOut) {
  std::mt19937_64 random{2};
  for (int trial = 0; trial < 20; ++trial) {
    const Vec3 at{2'600'000, 1'200'000, 500};
    RawMesh mesh = box(at, {1, 2, 3});
    if (trial > 0) flip_at_random(mesh, random);
    const CleanMesh cleaned = clean(mesh);
    expect_sound(cleaned);
    EXPECT_EQ(cleaned.report.closed_components, 1U);
    EXPECT_EQ(cleaned.report.boundary_edges, 0U);
    EXPECT_EQ(cleaned.report.vertical.count, 8U);
    EXPECT_EQ(cleaned.report.overhanging.count, 2U);
    EXPECT_FALSE(cleaned.report.every_facet_faces_up());
    const Vec3 middle = at + Vec3{0.5, 1, 1.5};
    for (std::size_t i = 0; i < cleaned.triangles.size(); ++i) {
      EXPECT_GT(normal(cleaned, i).dot(cleaned.vertices[cleaned.triangles[i][0]] - middle), 0);
    }
  }
}

TEST(Cleaning, ABowlFacesUpAndIn) {
  RawMesh bowl{{{0, 0, -10}, {10, 0, 0}, {-5, 8, 0}, {-5, -8, 0}}, {{0, 2, 1}, {0, 2, 3}, {3, 0, 1}}};
  const CleanMesh cleaned = clean(bowl);
  expect_sound(cleaned);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_GT(normal(cleaned, i).z(), 0);
    EXPECT_GT(normal(cleaned, i).dot(Vec3{0, 0, 0} - cleaned.vertices[0]), 0);
  }
}

TEST(Cleaning, AnOverhangFacesDown) {
  // A plateau, a lip that overhangs the foot of a cliff, and the ground below it: along x, z goes 10, 10, 4, 0, 0.
  std::mt19937_64 random{3};
  RawMesh cliff = extruded({{0, 10}, {6, 10}, {4, 4}, {4, 0}, {20, 0}});
  flip_at_random(cliff, random);
  const CleanMesh cleaned = clean(cliff);
  expect_sound(cleaned);
  EXPECT_EQ(cleaned.report.overhanging.count, 2U);
  EXPECT_EQ(cleaned.report.vertical.count, 2U);
  EXPECT_GT(normal(cleaned, 0).z(), 0.99);
  EXPECT_LT(normal(cleaned, 2).z(), 0);
  EXPECT_GT(normal(cleaned, 2).x(), 0);  // the overhang faces away from the rock, towards the valley
  EXPECT_GT(normal(cleaned, 4).x(), 0.99);
  EXPECT_GT(normal(cleaned, 6).z(), 0.99);
}

TEST(Cleaning, AnArchIsASolidAndFacesOut) {
  // The outline of a gate (x, z) with its opening, extruded, with both ends shut by strips from outer to inner line.
  const std::vector<Vec2> gate{{0, 0}, {0, 4}, {6, 4}, {6, 0}, {4, 0}, {4, 3}, {2, 3}, {2, 0}};
  RawMesh arch = extruded(gate, true);
  for (const std::uint32_t side : {0U, 1U}) {
    const auto at = [&](std::uint32_t i) { return 2 * i + side; };
    add_quad(arch, at(0), at(1), at(6), at(7));
    add_quad(arch, at(1), at(2), at(5), at(6));
    add_quad(arch, at(2), at(3), at(4), at(5));
  }
  std::mt19937_64 random{4};
  flip_at_random(arch, random);
  const CleanMesh cleaned = clean(arch);
  expect_sound(cleaned);
  EXPECT_EQ(cleaned.report.closed_components, 1U);
  double volume = 0;
  for (const Triangle& t : cleaned.triangles) {
    volume += cleaned.vertices[t[0]].dot(cleaned.vertices[t[1]].cross(cleaned.vertices[t[2]])) / 6;
  }
  EXPECT_NEAR(volume, 6 * 4 - 2 * 3, 1e-12);
  EXPECT_LT(normal(cleaned, 10).z(), -0.99);  // the soffit of the opening
}

TEST(Cleaning, ComponentsAreTurnedEachForItself) {
  std::mt19937_64 random{5};
  RawMesh mesh = random_tin(4, random);
  for (Triangle& t : mesh.triangles) std::swap(t[0], t[1]);
  const CleanMesh cleaned = clean(joined(mesh, box({0, 0, 20}, {1, 1, 1})));
  expect_sound(cleaned);
  EXPECT_EQ(cleaned.report.components, 2U);
  EXPECT_EQ(cleaned.report.closed_components, 1U);
  EXPECT_EQ(cleaned.report.flipped.count, 32U);
}

TEST(Cleaning, AWallKeepsTheWindingOfMostAndSaysSo) {
  RawMesh wall = extruded({{0, 0}, {0, 1}, {0, 2}, {0, 3}});
  std::swap(wall.triangles[0][0], wall.triangles[0][1]);
  const CleanMesh cleaned = clean(wall);
  expect_sound(cleaned);
  EXPECT_EQ(cleaned.report.flipped.count, 1U);
  for (std::size_t i = 0; i < cleaned.triangles.size(); ++i) EXPECT_EQ(normal(cleaned, i), Vec3(-1, 0, 0));
  EXPECT_EQ(cleaned.report.undecided_components.count, 1U);
  EXPECT_TRUE(cleaned.report.has_warnings());
}

TEST(Cleaning, AMoebiusStripIsReportedAndEachFacetTurnedUp) {
  const CleanMesh cleaned = clean(moebius_strip(40));
  expect_sound(cleaned);
  EXPECT_EQ(cleaned.triangles.size(), 80U);
  EXPECT_EQ(cleaned.report.components, 1U);
  EXPECT_EQ(cleaned.report.one_sided_components.count, 1U);
  EXPECT_TRUE(cleaned.report.has_warnings());
  for (std::size_t i = 0; i < cleaned.triangles.size(); ++i) EXPECT_GE(normal(cleaned, i).z(), -vertical_n_z);
}

TEST(Cleaning, AFinOnASlopeIsNonManifold) {
  // Two facets of ground, and a fin that stands on the edge between them.
  const RawMesh mesh{{{0, -1, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 0}, {0, 0, 1}}, {{0, 1, 2}, {0, 3, 1}, {0, 1, 4}}};
  const CleanMesh cleaned = clean(mesh);
  expect_sound(cleaned);
  EXPECT_EQ(cleaned.report.non_manifold_edges.count, 1U);
  EXPECT_THAT(cleaned.report.non_manifold_edges.examples, ElementsAre(Vec3{0, 0, 0}));
  EXPECT_EQ(cleaned.report.components, 3U);
  EXPECT_EQ(cleaned.report.boundary_edges, 6U);
  EXPECT_EQ(cleaned.report.vertical.count, 1U);
  EXPECT_GT(normal(cleaned, 0).z(), 0.99);
  EXPECT_GT(normal(cleaned, 1).z(), 0.99);
  for (const auto& neighbours : cleaned.neighbours) {
    EXPECT_EQ(neighbours, (std::array<Neighbour, 3>{}));
  }
}

// ---- welding ----

TEST(Cleaning, SoupBecomesTheIndexedMesh) {
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

TEST(Cleaning, ZeroAndMinusZeroAreOnePlace) {
  EXPECT_THAT(welded({{0.0, 1, 2}, {-0.0, 1, 2}, {0.0, 1, 3}}, 0), ElementsAre(0U, 0U, 2U));
}

TEST(Cleaning, NearVerticesAreWeldedOnlyWithinTheTolerance) {
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

TEST(Cleaning, WeldedVerticesMoveNoFurtherThanTheToleranceAndKeptOnesAreFurtherApart) {
  std::mt19937_64 random{9};
  std::uniform_real_distribution<double> place{-1, 1};
  std::vector<Vec3> vertices;
  for (int i = 0; i < 600; ++i) vertices.emplace_back(place(random), place(random), 0.1 * place(random));
  const double tolerance = 0.1;
  const std::vector<std::uint32_t> stands_for = welded(vertices, tolerance);
  std::size_t kept = 0;
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    EXPECT_LE((vertices[stands_for[i]] - vertices[i]).norm(), tolerance);
    EXPECT_EQ(stands_for[stands_for[i]], stands_for[i]);
    if (stands_for[i] != i) continue;
    ++kept;
    for (std::uint32_t j = 0; j < i; ++j) {
      if (stands_for[j] == j) {
        EXPECT_GT((vertices[i] - vertices[j]).norm(), tolerance);
      }
    }
  }
  EXPECT_GT(kept, 50U);
  EXPECT_LT(kept, 400U);
}

// ---- what is left out ----

TEST(Cleaning, DegenerateAndRepeatedFacetsAreLeftOutAndTheOthersKeepTheirOrder) {
  RawMesh mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 5e-10, 0}, {9, 9, 9}, {0, 0, 0}},
               {{0, 1, 1},    // a corner twice
                {0, 1, 2},    //
                {0, 4, 1},    // a sliver, half a nanometre high
                {2, 0, 1},    // the second again
                {1, 0, 2},    // and the other way round
                {0, 6, 3},    // corners at one place
                {3, 0, 2}}};  //
  const CleanMesh cleaned = clean(mesh);
  expect_sound(cleaned);
  EXPECT_THAT(cleaned.original, ElementsAre(1U, 6U));
  EXPECT_THAT(cleaned.triangles, ElementsAre(Triangle{0, 1, 2}, Triangle{3, 0, 2}));
  EXPECT_EQ(cleaned.report.degenerate.count, 3U);
  EXPECT_EQ(cleaned.report.duplicates.count, 2U);
  EXPECT_EQ(cleaned.report.welded_vertices, 1U);
  EXPECT_EQ(cleaned.report.unused_vertices, 2U);
  EXPECT_EQ(cleaned.vertices.size(), 4U);
  EXPECT_EQ(cleaned.report.text(),
            "2 facets, 4 vertices, 1 component (0 closed), 4 boundary edges; every facet faces up\n"
            "welded: 1 vertex, which lies where another does\n"
            "left out: 2 vertices of no facet\n"
            "left out: 3 facets without area, at (0.667, 0.000, 0.000), (0.500, 0.000, 0.000), (0.000, 0.333, 0.000)\n"
            "left out: 2 facets that repeat another, at (0.667, 0.333, 0.000), (0.667, 0.333, 0.000)");
}

TEST(Cleaning, SliversAreMeasuredByTheirHeight) {
  const auto with_height = [](double height, const Vec3& at) {
    const RawMesh mesh{{at, at + Vec3{100, 0, 0}, at + Vec3{0, 100, 0}, at + Vec3{50, -height, 0}},
                       {{0, 1, 2}, {0, 3, 1}}};
    return clean(mesh).report.degenerate.count;
  };
  EXPECT_EQ(with_height(0.9e-9, Vec3::Zero()), 1U);
  EXPECT_EQ(with_height(1.1e-9, Vec3::Zero()), 0U);
  // Far from the origin such heights drown in the rounding of the coordinates.
  EXPECT_EQ(with_height(1.1e-9, {2'600'000, 1'200'000, 0}), 1U);
  EXPECT_EQ(with_height(1e-8, {2'600'000, 1'200'000, 0}), 0U);
}

TEST(Cleaning, LargeCoordinatesComeThroughUnchanged) {
  std::mt19937_64 random{10};
  const RawMesh mesh = random_tin(8, random, Vec3{2'600'000.123456, 1'200'000.654321, 450});
  const CleanMesh cleaned = clean(mesh);
  EXPECT_EQ(cleaned.vertices, mesh.vertices);
  EXPECT_EQ(cleaned.triangles, mesh.triangles);
}

// ---- report and refusals ----

TEST(Cleaning, TheReportTellsWhatToLookAt) {
  RawMesh fin{{{0, -1, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 0}, {0, 0, 1}}, {{0, 1, 2}, {0, 3, 1}, {0, 1, 4}}};
  EXPECT_EQ(
      clean(joined(fin, moebius_strip(4))).report.text(),
      "11 facets, 13 vertices, 4 components (0 closed), 14 boundary edges; 3 vertical and 0 overhanging\n"
      "vertical: 3 facets, at (0.000, 0.000, 0.333), (-2.000, 0.764, -0.236), (-2.000, -0.764, 0.236)\n"
      "turned over to face out of the ground: 3 facets, at (0.667, 2.000, 0.000), (2.000, 1.236, 0.236), (-1.000, "
      "2.000, 0.333)\n"
      "warning: 1 edge has more than two facets (which of them go on from each other is not known), at (0.000, 0.000, "
      "0.000)\n"
      "warning: 1 boundary edge lies below another facet and above none (what slides or rolls to it leaves the model "
      "there), at (-1.500, 1.146, -0.854)\n"
      "warning: 1 component has one side only, like a Moebius strip (each facet was turned up by itself), at (0.667, "
      "2.000, 0.000)\n"
      "warning: 1 component does not show which side is out of the ground (no area in plan, or no volume; the winding "
      "of most facets was kept), at (0.000, 0.000, 0.333)");
  EXPECT_EQ(clean(box({0, 0, 0}, {1, 1, 1})).report.text(),
            "12 facets, 8 vertices, 1 component (1 closed), 0 boundary edges; 8 vertical and 2 overhanging\n"
            "vertical: 8 facets, for example at (0.667, 0.000, 0.333), (0.333, 0.000, 0.667), (0.333, 1.000, 0.333)\n"
            "overhanging: 2 facets, at (0.333, 0.667, 0.000), (0.667, 0.333, 0.000)");
}

// Two facets on a side of a third, one of them beside it by 2 mm.
TEST(Cleaning, TheReportTellsOfCornersOnSidesAndOfCracks) {
  const RawMesh mesh{{{0, 0, 0}, {2, 0, 0}, {2, 4, 0}, {2, 2, 0}, {5, 1, 0}, {2.002, 2.1, 0}, {2.002, 4, 0}, {5, 3, 0}},
                     {{0, 1, 2}, {1, 4, 3}, {5, 7, 6}}};
  const CleanMesh cleaned = clean(mesh, {.source = "", .weld_tolerance_m = 0.001});
  expect_sound(cleaned);
  EXPECT_TRUE(cleaned.report.has_warnings());
  EXPECT_THAT(cleaned.original, ElementsAre(0U, 0U, 1U, 2U));
  EXPECT_EQ(
      cleaned.report.text(),
      "4 facets, 8 vertices, 2 components (0 closed), 8 boundary edges; every facet faces up\n"
      "joined: 1 corner that lies on the side of another facet, which was cut there, at (2.000, 2.000, 0.000)\n"
      "warning: 2 boundary edges lie within 0.01 m of another facet (a crack: what slides or rolls to it may leave "
      "the model there), at (2.000, 3.000, 0.000), (2.002, 3.050, 0.000)");
}

TEST(Cleaning, Refusals) {
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
  EXPECT_EQ(
      refusal(mesh),
      "slope.obj: vertex 1 (counted from 0): (1, nan, 0) is not a place (expected finite coordinates in metres)\n"
      "slope.obj: vertex 2 (counted from 0): (0, 1, -inf) is not a place (expected finite coordinates in metres)\n"
      "slope.obj: triangle 1 (counted from 0): vertex 3 does not exist (the mesh has 3, counted from 0)");
  mesh = good;
  mesh.vertices[0].x() = -1e9;
  EXPECT_EQ(
      refusal(mesh),
      "slope.obj: vertex 0 (counted from 0): (-1000000000, 0, 0) is too far away (coordinates must be smaller than "
      "1e+09 m). Are they in metres?");
  EXPECT_EQ(
      refusal({good.vertices, {{0, 1, 1}, {2, 2, 2}}}, {}),
      "terrain: the mesh has no facet with an area (all 2 have a corner twice or are lower than 1e-09 m). Are its "
      "coordinates in metres?");
}

TEST(Cleaning, ManyBadVerticesAreToldInPart) {
  RawMesh mesh{std::vector<Vec3>(1000, Vec3::Constant(std::numeric_limits<double>::quiet_NaN())), {{0, 1, 2}}};
  const std::string text = refusal(mesh);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 10);
  EXPECT_THAT(text, ::testing::EndsWith("\nslope.obj: 990 more of the kind"));
}

// Triangles between few vertices, many at one place or in line: every kind of defect at once.
TEST(Cleaning, RandomTanglesAreMendedOrRefused) {
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
      Triangle t{};
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
}  // namespace talus
