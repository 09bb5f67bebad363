// Polygons that are asked after a run.

#include "talus/lines/area_answer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "lines/slopes.hpp"
#include "support/simulated_paths.hpp"

namespace talus {
namespace {

using testing_tools::SimulatedRun;

std::string area_refusal(const Model& model, const std::vector<PlanPlace>& corners) {
  Problems warnings;
  try {
    static_cast<void>(drawn_area(model, corners, "polygon", warnings));
  } catch (const BadInput& bad) {
    return bad.problems().text();
  }
  return warnings.text();
}

/// Maxima at many places along the pieces, by brute force.
TEST(AskedArea, HasTheMaximaOfPathsInside) {
  const SimulatedRun run(plain_slope);
  Problems warnings;
  const std::vector<PlanPlace> corners{{20, 15}, {60, 12}, {40, 30}, {58, 48}, {22, 40}};
  const AskedArea area = drawn_area(run.model, corners, "polygon", warnings);
  EXPECT_EQ(warnings.text(), "");
  const AreaAnswer answer = ask_area(run.model, project::design_basis(run.project), run.paths, area);
  EXPECT_EQ(answer.rocks, 150u);
  std::size_t entering = 0, stopping = 0;
  RockPath path;
  for (std::size_t rock = 0; rock < run.records.size(); ++rock) {
    run.paths.read(rock, path);
    double speed = -1;
    for (const PathPiece& piece : path.pieces) {
      constexpr int steps = 400;
      for (int k = 0; k <= steps; ++k) {
        const double s = piece.duration * k / steps;
        if (area.polygon.contains(piece.path.at(s).xy())) speed = std::max(speed, piece.velocity(s).norm());
      }
    }
    const auto found = std::ranges::find(answer.entering, rock, &RockInside::rock);
    if (speed < 0) continue;  // it may have cut a corner between two steps
    ++entering;
    ASSERT_NE(found, answer.entering.end()) << rock;
    const double most = found->maxima[static_cast<std::size_t>(CrossingQuantity::velocity)];
    EXPECT_GE(most, speed * (1 - 1e-12));
    EXPECT_NEAR(most, speed, 0.1) << rock;
    const bool stops = area.polygon.contains(run.records[rock].outcome.end.position.xy()) &&
                       run.records[rock].outcome.reason != EndReason::left_model;
    EXPECT_EQ(found->stops, stops);
    stopping += stops ? 1 : 0;
  }
  EXPECT_GT(entering, 80u);
  EXPECT_GT(stopping, 5u);
  EXPECT_EQ(answer.stopping().size(), stopping);
}

/// The polygon of the whole terrain has the maxima of the run.
TEST(AskedArea, OfTheWholeTerrainHasTheMaximaOfTheRun) {
  const SimulatedRun run(plain_slope);
  Problems warnings;
  const std::vector<PlanPlace> corners{{-1, -1}, {81, -1}, {81, 61}, {-1, 61}};
  const AskedArea area = drawn_area(run.model, corners, "polygon", warnings);
  const AreaAnswer answer = ask_area(run.model, project::design_basis(run.project), run.paths, area);
  ASSERT_EQ(answer.entering.size(), 150u);
  for (std::size_t rock = 0; rock < 150; ++rock) {
    const CrossingMaxima& maxima = answer.entering[rock].maxima;
    const RockOutcome& outcome = run.records[rock].outcome;
    EXPECT_NEAR(maxima[static_cast<std::size_t>(CrossingQuantity::energy_total)], outcome.max_kinetic_energy,
                1e-9 * outcome.max_kinetic_energy);
    EXPECT_NEAR(maxima[static_cast<std::size_t>(CrossingQuantity::height)], outcome.max_bounce, 1e-9);
  }
}

TEST(AskedArea, CutsACurvedPathAtItsBorders) {
  const SimulatedRun run(plain_slope);
  Problems warnings;
  const AskedArea area =
      drawn_area(run.model, std::vector<PlanPlace>{{10, 10}, {20, 10}, {20, 20}, {10, 20}}, "polygon", warnings);
  const Vec2 origin(run.model.frame.origin.x(), run.model.frame.origin.y());
  // x = 15 throughout, y = 12 + 20 t - 10 t^2: it leaves at y = 20, turns at 22 and comes back in.
  const Parabola path{Vec3(15 - origin.x(), 12 - origin.y(), 0), Vec3(0, 20, 0), Vec3(0, -20, 0)};
  std::vector<std::pair<double, double>> parts;
  parts_inside(area, path, 2, parts);
  const double out = 1 - std::sqrt(0.2), in = 1 + std::sqrt(0.2);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].first, 0);
  EXPECT_NEAR(parts[0].second, out, 1e-12);
  EXPECT_NEAR(parts[1].first, in, 1e-12);
  EXPECT_EQ(parts[1].second, 2);
}

TEST(AskedArea, RefusesWhatIsNoPolygonOnTheTerrain) {
  const Model model = testing_tools::model_of(plain_slope);
  EXPECT_EQ(area_refusal(model, {{1, 1}, {2, 2}}), "polygon: has 2 corners (expected at least 3)");
  EXPECT_EQ(area_refusal(model, {{1, 1}, {2, 2}, {1, 1}}), "polygon: has 2 corners (expected at least 3)");
  EXPECT_EQ(area_refusal(model, {{1, 1}, {NAN, 2}, {1, INFINITY}}),
            "polygon: point 2 is (nan, 2) (expected numbers)\npolygon: point 3 is (1, inf) (expected numbers)");
  EXPECT_EQ(area_refusal(model, {{1, 1}, {5, 5}, {9, 9}}),
            "polygon: crosses itself (at (1, 1)). Give the corners in order along the outline");
  EXPECT_EQ(area_refusal(model, {{10, 10}, {20, 20}, {20, 10}, {10, 20}}),
            "polygon: crosses itself (at (15, 15)). Give the corners in order along the outline");
  EXPECT_EQ(area_refusal(model, {{1000, 1000}, {1010, 1000}, {1010, 1010}}),
            "polygon: does not touch the terrain (rocks are only known there). Give it in the coordinates of the "
            "project");
  EXPECT_EQ(area_refusal(model, {{10, 10}, {20, 10}, {20, -10}}),
            "warning: polygon: 1 of 3 corners are off the terrain (rocks are only known on it)");
}

}  // namespace
}  // namespace talus
