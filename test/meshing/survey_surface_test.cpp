#include "talus/meshing/survey_surface.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/dice.hpp"
#include "talus/core/problems.hpp"
#include "talus/meshing/cleaning.hpp"
#include "talus/meshing/survey_departures.hpp"
#include "talus/terrain/local_frame.hpp"
#include "talus/terrain/raster_surface.hpp"
#include "talus/terrain/triangle_mesh.hpp"

namespace talus::survey_surface_test {
namespace {

using namespace testing_tools;
using ::testing::HasSubstr;
using ::testing::Not;

double plan_area(const RawMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 u = mesh.vertices[b] - mesh.vertices[a], v = mesh.vertices[c] - mesh.vertices[a];
    sum += 0.5 * (u.x() * v.y() - u.y() * v.x());
  }
  return sum;
}

// The height of the surface at a place on plan.
std::optional<double> height_at(const RawMesh& mesh, double x, double y) {
  const auto turn = [&](const Vec3& a, const Vec3& b) {
    return (b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x());
  };
  for (const auto& [i, j, k] : mesh.triangles) {
    const Vec3 &a = mesh.vertices[i], &b = mesh.vertices[j], &c = mesh.vertices[k];
    const double u = turn(b, c), v = turn(c, a), w = turn(a, b);
    if (u >= -1e-9 && v >= -1e-9 && w >= -1e-9) return (u * a.z() + v * b.z() + w * c.z()) / (u + v + w);
  }
  return std::nullopt;
}

std::string refusal(const Survey& survey, SurveyOptions options = {}) {
  options.source = "survey.csv";
  try {
    static_cast<void>(surface_of(survey, options));
  } catch (const BadInput& bad) {
    return bad.what();
  }
  return "accepted";
}

PlanPolygon square(double low, double high) {
  const std::vector<std::vector<Vec3>> rings{{{low, low, 0}, {high, low, 0}, {high, high, 0}, {low, high, 0}}};
  return PlanPolygon(rings);
}

/// Grid points a metre apart, from 0 to `last` along x and y.
template <class Height>
Survey grid(int last, Height&& height) {
  Survey survey;
  for (int i = 0; i <= last; ++i) {
    for (int j = 0; j <= last; ++j) survey.points.emplace_back(i, j, height(i, j));
  }
  return survey;
}

// ---- properties ----

TEST(SurveySurface, APlaneStaysAPlane) {
  Dice dice(31);
  Survey survey;
  const auto height = [](double x, double y) { return 1200 - 0.5 * (x - 2.6e6) + 0.25 * (y - 1.2e6); };
  for (int i = 0; i < 2000; ++i) {
    const double x = 2.6e6 + dice.between(0, 1000), y = 1.2e6 + dice.between(0, 1000);
    survey.points.emplace_back(x, y, height(x, y));
  }
  for (int i = 0; i < 20; ++i) {
    auto& line = survey.lines.emplace_back();
    for (int k = 0; k < 30; ++k) {
      const double x = 2.6e6 + dice.between(0, 1000), y = 1.2e6 + dice.between(0, 1000);
      line.emplace_back(x, y, height(x, y));
    }
  }
  const SurveySurface surface = surface_of(survey);
  for (const Vec3& v : surface.mesh.vertices) EXPECT_NEAR(v.z(), height(v.x(), v.y()), 5e-6);
  EXPECT_GT(surface.report.constraints.crossings.count, 1000U);
  EXPECT_EQ(surface.report.constraints.crossings_at_odds.count, 0U);
  EXPECT_LT(surface.report.largest_departure_m, 5e-6);
  EXPECT_EQ(surface.report.outliers.count, 0U);
}

TEST(SurveySurface, WholeMetresAreKeptToTheBit) {
  const Survey survey = grid(20, [](int i, int j) { return 0.1 * i * j; });
  const SurveySurface surface = surface_of(survey);
  EXPECT_EQ(surface.mesh.vertices.size(), survey.points.size());
  for (std::size_t i = 0; i < survey.points.size(); ++i) EXPECT_EQ(surface.mesh.vertices[i], survey.points[i]);
  EXPECT_EQ(surface.mesh.triangles.size(), 800U);
  EXPECT_EQ(plan_area(surface.mesh), 400);
  EXPECT_EQ(surface.report.holes, 0U);
}

// A breakline on a ridge that the points miss: along the line the heights are the line's, not those of the Delaunay
// triangles across it.
TEST(SurveySurface, ABreaklineAcrossARidgeIsHonoured) {
  Survey survey = grid(20, [](int i, int) { return 10.0 - std::abs(i - 10); });
  // Along the ridge, 0.2 to 0.3 m off the points there and 3 m above them; only its ends are given.
  survey.lines.push_back({{10.3, 0.2, 13}, {9.8, 19.7, 14}});
  const RawMesh without = surface_of(Survey{survey.points, {}}).mesh, with = surface_of(survey).mesh;
  double largest_without = 0;
  for (int k = 0; k <= 1000; ++k) {
    const double share = k / 1000.0, x = std::lerp(10.3, 9.8, share), y = std::lerp(0.2, 19.7, share);
    const auto height = height_at(with, x, y);
    ASSERT_TRUE(height);
    // The line passes through no grid point, which would keep its own height.
    EXPECT_NEAR(*height, 13 + share, 1e-4);
    largest_without = std::max(largest_without, std::abs(*height_at(without, x, y) - (13 + share)));
  }
  EXPECT_GT(largest_without, 3);
}

TEST(SurveySurface, NeedsNoCleaning) {
  Dice dice(32);
  Survey survey;
  for (int i = 0; i < 3000; ++i) {
    const double x = dice.between(0, 300), y = dice.between(0, 300);
    survey.points.emplace_back(x, y, 20 * std::sin(x / 30) + 0.3 * y);
  }
  const SurveySurface surface = surface_of(survey);
  const CleanMesh cleaned = clean(surface.mesh);
  EXPECT_EQ(cleaned.report.facets, surface.mesh.triangles.size());
  EXPECT_EQ(cleaned.report.flipped.count, 0U);
  EXPECT_EQ(cleaned.report.components, 1U);
  EXPECT_TRUE(cleaned.report.every_facet_faces_up());
}

// Points on a grid make the same surface as a raster, including the diagonals; also when rotated (by 0.5 rad), where
// rounding would otherwise decide the diagonals.
TEST(SurveySurface, PointsOfAGridAreARaster) {
  Dice dice(35);
  constexpr std::uint32_t columns = 30, rows = 25;
  RasterGrid nodes;
  nodes.columns = columns;
  nodes.rows = rows;
  nodes.dx = nodes.dy = 4.997688906601;
  for (std::uint32_t k = 0; k < columns * rows; ++k) nodes.z.push_back(static_cast<float>(dice.between(100, 130)));
  const double cosine = std::cos(0.5), sine = std::sin(0.5);
  Survey straight, turned;
  for (std::uint32_t row = 0; row < rows; ++row) {
    for (std::uint32_t column = 0; column < columns; ++column) {
      const Vec3 p(column * nodes.dx, row * nodes.dy, nodes.z[nodes.index(column, row)]);
      straight.points.push_back(p);
      turned.points.push_back(talus::turned(p, cosine, sine));
    }
  }
  const RasterSurface raster(nodes);
  const RawMesh mesh = surface_of(straight).mesh, turned_mesh = surface_of(turned).mesh;
  EXPECT_EQ(mesh.triangles.size(), 2U * (columns - 1) * (rows - 1));
  EXPECT_EQ(turned_mesh.triangles.size(), mesh.triangles.size());
  for (int k = 0; k < 1000; ++k) {
    const double x = dice.between(0.1, (columns - 1) * nodes.dx - 0.1),
                 y = dice.between(0.1, (rows - 1) * nodes.dy - 0.1);
    const double z = raster.elevation(x, y).value();
    EXPECT_NEAR(height_at(mesh, x, y).value(), z, 1e-4);
    EXPECT_NEAR(height_at(turned_mesh, cosine * x - sine * y, sine * x + cosine * y).value(), z, 1e-4);
  }
}

// ---- coincident points ----

TEST(SurveySurface, PointsAtOnePlaceGetTheirMeanHeight) {
  Survey survey = grid(4, [](int, int) { return 0.0; });
  survey.points.emplace_back(2, 2, 0);
  survey.points.emplace_back(1, 1, 3);
  survey.points.emplace_back(1, 1, 6);
  const SurveySurface surface = surface_of(survey);
  EXPECT_EQ(surface.mesh.vertices.size(), 25U);
  EXPECT_EQ(surface.report.repeated, 3U);
  EXPECT_EQ(surface.report.at_odds.count, 1U);
  EXPECT_EQ(surface.report.largest_difference_m, 6);
  EXPECT_EQ(surface.mesh.vertices[6], Vec3(1, 1, 3));
  EXPECT_THAT(surface.report.text(),
              HasSubstr("warning: 1 place has several heights, up to 6 m apart (their mean is used; heights of lines "
                        "precede those of points), at (1.000, 1.000, 3.000)"));
}

TEST(SurveySurface, HeightsOfLinesPrecedeThoseOfPoints) {
  Survey survey = grid(4, [](int, int) { return 0.0; });
  survey.lines.push_back({{1, 1, 5}, {3, 1, 7}});
  const SurveySurface surface = surface_of(survey);
  EXPECT_EQ(surface.mesh.vertices[6].z(), 5);
  EXPECT_EQ(surface.mesh.vertices[16].z(), 7);
  EXPECT_EQ(surface.mesh.vertices[11].z(), 0);  // a point that the line passes keeps its height
  EXPECT_EQ(surface.report.constraints.vertices_at_odds.count, 1U);
  EXPECT_EQ(surface.report.constraints.largest_vertex_difference_m, 6);
}

// ---- the rim ----

// Points along the edge of a survey, out of line by millimetres, would make walls a millimetre wide.
TEST(SurveySurface, DropsTrianglesAtTheRimThatAreAlmostALine) {
  Dice dice(33);
  Survey survey;
  for (int i = 0; i <= 50; ++i) {
    for (int j = 0; j <= 50; ++j) {
      survey.points.emplace_back(i + dice.between(-0.005, 0.005), j + dice.between(-0.005, 0.005),
                                 0.2 * i + dice.unit());
    }
  }
  const SurveySurface surface = surface_of(survey);
  EXPECT_GT(surface.report.flat_at_rim, 20U);
  EXPECT_LT(surface.report.longest_side_m, 1.5);
  EXPECT_NEAR(plan_area(surface.mesh), 2500, 2);
  for (const auto& t : surface.mesh.triangles) {
    const Vec3 u = surface.mesh.vertices[t[1]] - surface.mesh.vertices[t[0]];
    const Vec3 v = surface.mesh.vertices[t[2]] - surface.mesh.vertices[t[0]];
    EXPECT_GT(u.x() * v.y() - u.y() * v.x(), 0.5);
  }
}

TEST(SurveySurface, KeepsABreaklineAtTheRim) {
  // The rim is slightly concave between two corners that a line joins.
  Survey survey{{{0, 0, 0}, {10, 0, 0}, {5, 0.01, 0}, {5, 8, 0}}, {}};
  EXPECT_EQ(surface_of(survey).mesh.triangles.size(), 2U);
  survey.lines.push_back({{0, 0, 0}, {10, 0, 0}});
  EXPECT_EQ(surface_of(survey).mesh.triangles.size(), 3U);
}

// All triangles of the strip are narrow, but none is almost a line.
TEST(SurveySurface, KeepsAStripOfNarrowTriangles) {
  Survey survey;
  for (int i = 0; i <= 100; ++i) {
    survey.points.emplace_back(0, 0.1 * i, 0);
    survey.points.emplace_back(20, 0.1 * i + 0.03, 1);
  }
  const SurveySurface surface = surface_of(survey);
  EXPECT_EQ(surface.report.flat_at_rim, 0U);
  EXPECT_EQ(surface.mesh.triangles.size(), 200U);
}

// An L-shaped survey, whose convex hull spans the bay with long triangles.
Survey bay() {
  Survey survey;
  for (int i = 0; i <= 40; ++i) {
    for (int j = 0; j <= 40; ++j) {
      if (i <= 10 || j <= 10) survey.points.emplace_back(i, j, 0.1 * i);
    }
  }
  return survey;
}

TEST(SurveySurface, DropsLongSidesFromTheRimInwards) {
  const SurveySurface hull = surface_of(bay()), cut = surface_of(bay(), {.max_edge_m = 2});
  EXPECT_NEAR(plan_area(hull.mesh), 700 + 450, 1);
  EXPECT_EQ(plan_area(cut.mesh), 700.5);  // and half a square in the inner corner
  EXPECT_EQ(cut.report.holes, 0U);
  EXPECT_GT(cut.report.with_long_sides, 10U);
  EXPECT_THAT(hull.report.text(),
              HasSubstr("warning: the longest side at the rim is 42.43 m, 42 times the median, at ("));
  EXPECT_THAT(cut.report.text(), Not(HasSubstr("warning")));
}

TEST(SurveySurface, KeepsLongSidesInTheInterior) {
  // A pond without points, in the middle of a grid.
  Survey survey;
  for (const Vec3& p : grid(40, [](int, int) { return 1.0; }).points) {
    if (std::hypot(p.x() - 20, p.y() - 20) > 8) survey.points.push_back(p);
  }
  const SurveySurface surface = surface_of(survey, {.max_edge_m = 2});
  EXPECT_EQ(plan_area(surface.mesh), 1600);
}

TEST(SurveySurface, DropsTrianglesBeyondTheBoundary) {
  const Survey survey = grid(40, [](int i, int) { return 0.1 * i; });
  EXPECT_EQ(plan_area(surface_of(survey, {.boundary = {square(10, 30)}}).mesh), 400);
  const SurveySurface two = surface_of(survey, {.boundary = {square(0, 10), square(20, 25)}});
  EXPECT_EQ(plan_area(two.mesh), 125);
  EXPECT_EQ(two.report.holes, 0U);
  EXPECT_EQ(two.report.beyond_boundary, 3200U - 250U);
  EXPECT_EQ(clean(two.mesh).report.unused_vertices, 1681U - 121U - 36U);
}

TEST(SurveySurface, CountsHoles) {
  const Survey survey = grid(40, [](int i, int) { return 0.1 * i; });
  const std::vector<std::vector<Vec3>> rings{{{0, 0, 0}, {40, 0, 0}, {40, 40, 0}, {0, 40, 0}},
                                             {{5, 5, 0}, {10, 5, 0}, {10, 10, 0}, {5, 10, 0}},
                                             // Two that touch in a corner: one loop leads around both.
                                             {{20, 20, 0}, {25, 20, 0}, {25, 25, 0}, {20, 25, 0}},
                                             {{25, 25, 0}, {30, 25, 0}, {30, 30, 0}, {25, 30, 0}}};
  const SurveySurface surface = surface_of(survey, {.boundary = {PlanPolygon(rings)}});
  EXPECT_EQ(plan_area(surface.mesh), 1600 - 75);
  EXPECT_EQ(surface.report.holes, 2U);
  EXPECT_THAT(surface.report.text(), HasSubstr("triangles around 2 holes;"));
}

// ---- spikes ----

TEST(SurveySurface, ReportsSpikesAndRemovesThemOnRequest) {
  Dice dice(34);
  Survey survey = grid(40, [&](int i, int j) { return 0.5 * i - 0.2 * j + dice.between(-0.05, 0.05); });
  survey.points[20 * 41 + 20].z() += 12;
  survey.points[5 * 41 + 30].z() -= 7;
  survey.points[5 * 41 + 31].z() -= 8;  // next to each other
  const SurveySurface kept = surface_of(survey);
  EXPECT_EQ(kept.report.removed_spikes.count, 0U);
  EXPECT_EQ(kept.report.outliers.count, 1U);  // the two adjacent ones mask each other
  EXPECT_NEAR(kept.report.largest_departure_m, 12, 0.2);
  ASSERT_TRUE(kept.report.largest_departure_at);
  EXPECT_EQ(kept.report.largest_departure_at->xy(), Vec2(20, 20));

  const SurveySurface cleaned = surface_of(survey, {.remove_spikes_m = 1});
  EXPECT_EQ(cleaned.report.removed_spikes.count, 3U);
  EXPECT_EQ(cleaned.mesh.vertices.size(), survey.points.size() - 3);
  EXPECT_LT(cleaned.report.largest_departure_m, 0.2);
  EXPECT_EQ(cleaned.report.outliers.count, 0U);
  EXPECT_EQ(plan_area(cleaned.mesh), 1600);
}

// Points at the edge of a cliff depart from the plane of their neighbours, but so do the neighbours.
TEST(SurveySurface, TheEdgeOfACliffIsNoOutlier) {
  const Survey survey =
      grid(40, [](int i, int j) { return (i < 20 ? 50.0 : 0.0) - 0.3 * i + 0.02 * ((i * 7 + j * 3) % 5); });
  const SurveySurface surface = surface_of(survey);
  EXPECT_GT(surface.report.largest_departure_m, 15);
  EXPECT_EQ(surface.report.outliers.count, 0U);
}

TEST(SurveySurface, ADepartureIsTheHeightAboveThePlaneOfTheNeighbours) {
  // Six neighbours on a plane; three neighbours at different distances have no spread.
  std::vector<GridPoint> points{{100, 100}, {110, 100}, {105, 110}, {95, 110}, {90, 100}, {95, 90}, {105, 90}};
  std::vector<double> heights{7, 10.0 + 1, 10 + 0.5, 10 - 0.5, 10 - 1, 10 - 0.5, 10 + 0.5};
  const auto plane = departure(Triangulation(points), heights, 0);
  ASSERT_TRUE(plane);
  EXPECT_NEAR(plane->height_m, -3, 1e-12);
  EXPECT_NEAR(plane->spread_m, 0, 1e-7);
  EXPECT_FALSE(departure(Triangulation(points), heights, 1));  // at the rim
  heights = {7, 1, -1, 1, -1, 1, -1};                          // a monkey saddle, whose plane is level
  const auto saddle = departure(Triangulation(points), heights, 0);
  EXPECT_NEAR(saddle->height_m, 7, 0.2);
  EXPECT_NEAR(saddle->spread_m, std::sqrt(6.0 / 3), 0.1);
  const std::vector<GridPoint> few{{100, 100}, {120, 100}, {90, 130}, {80, 60}};
  const auto three = departure(Triangulation(few), {5, 1, 2, 3}, 0);
  ASSERT_TRUE(three);
  EXPECT_TRUE(std::isinf(three->spread_m));
}

TEST(SurveySurface, VerticesOfLinesAreNotSpikes) {
  Survey survey = grid(10, [](int, int) { return 0.0; });
  survey.lines.push_back({{5.5, 2.5, 9}, {5.5, 7.5, 9}});  // a wall
  const SurveySurface surface = surface_of(survey, {.remove_spikes_m = 20});
  EXPECT_EQ(surface.report.removed_spikes.count, 0U);
  EXPECT_EQ(*height_at(surface.mesh, 5.5, 5), 9);
}

// With these numbers rounded crossings once crossed again at every grid step.
TEST(SurveySurface, ALineDrawnBackOnItselfAddsNoCrossings) {
  Survey survey;
  survey.lines = {{{5.0750109687, 12.99599449, 1998.14},
                   {11.0414635658, 32.346285991, 1996.48},
                   {5.0460620595, 49.411757437, 2002.89},
                   {9.9677895233, 17.927765066, 1995.35}},
                  {{0.0034581437, 1.945509201, 2000.25}, {16.297195223, 41.886842052, 1994.04}}};
  const SurveySurface once = surface_of(survey);
  survey.lines[1].push_back(survey.lines[1].front());
  const SurveySurface twice = surface_of(survey);
  EXPECT_EQ(once.report.constraints.crossings.count, 3U);
  EXPECT_EQ(twice.report.constraints.crossings.count, 3U);
  EXPECT_EQ(twice.report.constraints.overlapping, 3U);
  EXPECT_EQ(twice.mesh.vertices, once.mesh.vertices);
}

// ---- contours ----

TEST(SurveySurface, ReportsLevelTrianglesBetweenContours) {
  // Contours of a truncated cone: only within the highest contour are triangles level.
  Survey survey;
  for (int ring = 1; ring <= 5; ++ring) {
    auto& line = survey.lines.emplace_back();
    for (int k = 0; k <= 64; ++k) {
      const double angle = 2 * std::numbers::pi * (k % 64) / 64;
      line.emplace_back(10 * ring * std::cos(angle), 10 * ring * std::sin(angle), 100.0 - 5 * ring);
    }
  }
  const SurveySurface surface = surface_of(survey);
  EXPECT_EQ(surface.report.flat.count, 62U);  // a polygon with 64 corners
  EXPECT_NEAR(surface.report.flat_area_m2, 32 * 100 * std::sin(2 * std::numbers::pi / 64), 1e-3);
  EXPECT_THAT(surface.report.text(),
              HasSubstr("warning: 62 triangles are level, with all corners on lines at one height, "
                        "313.7 m2 in all"));
  survey.points.emplace_back(0, 0, 97);
  EXPECT_EQ(surface_of(survey).report.flat.count, 0U);
}

// ---- refusals ----

TEST(SurveySurface, RefusesPointsThatSpanNoSurface) {
  EXPECT_EQ(refusal({}), "survey.csv: terrain: the survey has no points (a surface needs three or more)");
  EXPECT_EQ(refusal({{{0, 0, 0}, {1, 1, 1}, {0, 0, 2}}, {}}),
            "survey.csv: terrain: the survey has 2 places (a surface needs three or more)");
  EXPECT_EQ(refusal({{{0, 0, 0}, {1, 1, 1}, {2, 2, 5}, {7, 7, 0}}, {}}),
            "survey.csv: terrain: all 4 places of the survey lie on one line (they span no surface). For a 2D slope "
            "use section");
}

TEST(SurveySurface, RefusesASurveyThatIsTooWide) {
  EXPECT_EQ(
      refusal({{{0, 0, 0}, {1, 1, 1}, {0, 2e6, 2}}, {}}),
      "survey.csv: terrain: the survey is 2000000 m wide (Talus triangulates up to 1048576 m). Is a point far from "
      "the others, or are they not in metres?");
  EXPECT_EQ(
      refusal({{{0, 0, 0}, {1, 1, 1}, {0, 3e9, 2}}, {}}),
      "survey.csv: terrain: (0, 3000000000, 2) is too far from the origin (coordinates must be smaller than 1e+09 m). "
      "Are they in metres?");
}

TEST(SurveySurface, RefusesASurveyOfWhichNoTriangleRemains) {
  EXPECT_EQ(refusal(grid(4, [](int, int) { return 0.0; }), {.boundary = {square(3.9, 4.1)}}),
            "survey.csv: terrain: no triangle of the survey remains (32 are beyond the boundary, 0 at the rim have a "
            "side longer than max_edge_m, and 0 at the rim are almost a line)");
  EXPECT_EQ(refusal(grid(4, [](int, int) { return 0.0; }), {.max_edge_m = 0.5}),
            "survey.csv: terrain: no triangle of the survey remains (0 are beyond the boundary, 32 at the rim have a "
            "side longer than max_edge_m, and 0 at the rim are almost a line)");
}

}  // namespace
}  // namespace talus::survey_surface_test
