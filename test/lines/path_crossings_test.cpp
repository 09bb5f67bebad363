// Crossings found from the pieces of a path are those that the rock met on its way.

#include "talus/lines/path_crossings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "lines/slopes.hpp"
#include "support/simulated_paths.hpp"

namespace talus {
namespace {

using testing_tools::replaced;
using testing_tools::SimulatedRun;

const std::string crossed_slope =
    replaced(replaced(bouncing_slope, "lumped_mass", "rigid_sphere"), "rocks = 400", "rocks = 300") + R"(
[[barrier]]
name = "Net"
line = [[20, 0], [20, 35]]
height_m = 3
capacity_kJ = 60
normal_restitution = 0.3
tangential_restitution = 0.6

[[collector]]
name = "At the net"
line = [[20, 0], [20, 60]]
height_m = 3

[[barrier]]
name = "Leaning"
line = [[33, 0], [31, 60]]
height_m = 2
inclination_deg = 15
capacity_kJ = 90
)";

/// Not at its end: where a sphere touches an edge of a barrier is found by a search that depends on how far it looks.
bool is_in_flight(const RockPath& path, double time) {
  return std::ranges::any_of(path.pieces, [&](const PathPiece& piece) {
    return !piece.on_ground && piece.start_time < time && time < piece.time(piece.duration) - 1e-7;
  });
}

/// Compares the crossings that the run logged with those found from its pieces.
void expect_crossings_of_the_run(const std::string& text, double tolerance, bool has_rocks_above = true) {
  const SimulatedRun run(text);
  const PlanIndex on_plan = index_of(run.model.barriers);
  PathCrossings crossings({run.model.barriers, on_plan});
  std::size_t hits = 0, in_flight = 0, above = 0, different = 0;
  RockPath path;
  for (std::size_t rock = 0; rock < run.records.size(); ++rock) {
    run.paths.read(rock, path);
    crossings.begin(run.model.laws.model == RockModel::rigid_sphere ? path.record.body.radius : 0);
    for (const PathPiece& piece : path.pieces) crossings.add(piece);
    crossings.end(path.record.outcome.reason == EndReason::stopped_by_barrier);
    const RockLog &found = crossings.found(), &logged = run.logs[rock];
    if (found.hits.size() != logged.hits.size() || found.passed_above.size() != logged.passed_above.size()) {
      ++different;
      continue;
    }
    hits += found.hits.size();
    above += found.passed_above.size();
    for (std::size_t k = 0; k < found.hits.size(); ++k) {
      const Passage &a = found.hits[k], &b = logged.hits[k];
      EXPECT_EQ(a.barrier.index, b.barrier.index) << "rock " << rock;
      EXPECT_EQ(a.outcome, b.outcome) << "rock " << rock;
      if (is_in_flight(path, b.motion.time)) {
        ++in_flight;  // the same bits
        EXPECT_EQ(a.motion.position, b.motion.position) << "rock " << rock;
        EXPECT_EQ(a.motion.velocity, b.motion.velocity) << "rock " << rock;
        EXPECT_EQ(a.motion.spin, b.motion.spin) << "rock " << rock;
        EXPECT_EQ(a.motion.time, b.motion.time) << "rock " << rock;
        EXPECT_EQ(a.height, b.height) << "rock " << rock;
        EXPECT_EQ(a.lowest, b.lowest) << "rock " << rock;
        EXPECT_EQ(a.station, b.station) << "rock " << rock;
      }
      EXPECT_NEAR(a.height, b.height, tolerance) << "rock " << rock;
      EXPECT_NEAR(a.lowest, b.lowest, tolerance) << "rock " << rock;
      EXPECT_NEAR(a.station, b.station, tolerance) << "rock " << rock;
      EXPECT_NEAR(a.motion.time, b.motion.time, tolerance) << "rock " << rock;
      EXPECT_LE((a.motion.position - b.motion.position).norm(), tolerance) << "rock " << rock;
      EXPECT_LE((a.motion.velocity - b.motion.velocity).norm(), tolerance) << "rock " << rock;
      EXPECT_LE((a.motion.spin - b.motion.spin).norm(), tolerance) << "rock " << rock;
    }
    for (std::size_t k = 0; k < found.passed_above.size(); ++k) {
      const Passage &a = found.passed_above[k], &b = logged.passed_above[k];
      EXPECT_EQ(a.barrier.index, b.barrier.index);
      EXPECT_NEAR(a.clearance, b.clearance, tolerance);
      EXPECT_NEAR(a.lowest, b.lowest, tolerance);
      EXPECT_LE((a.motion.velocity - b.motion.velocity).norm(), tolerance);
    }
  }
  EXPECT_EQ(different, 0u) << "rocks with another number of crossings";
  EXPECT_GT(hits, 150u);
  EXPECT_GT(in_flight, has_rocks_above ? 50u : 5u);
  EXPECT_EQ(above > 5, has_rocks_above);
}

TEST(PathCrossings, AreThoseOfTheRunForSpheresAtBarriers) { expect_crossings_of_the_run(crossed_slope, 1e-9); }

TEST(PathCrossings, AreThoseOfTheRunForALumpedMassAtBarriers) {
  expect_crossings_of_the_run(replaced(crossed_slope, "rigid_sphere", "lumped_mass"), 1e-9);
}

TEST(PathCrossings, AreThoseOfTheRunInAForest) {
  const std::string forest = replaced(crossed_slope, "rolling_friction = 0.35",
                                      "rolling_friction = 0.35\nforest = \"open\"\nforest_height_m = 8");
  expect_crossings_of_the_run(forest, 1e-9, false);  // trees brake what would fly over
}

/// A barrier that holds the sphere before its centre reaches the collector on the same line.
TEST(PathCrossings, CountASphereAtTheLineOfTheBarrierThatHoldsIt) {
  Barrier net, line;
  const std::vector<Vec3> foot{{10, -5, 0}, {10, 5, 0}};
  net.set_panels(panels_over(foot, 4, 0));
  line.set_panels(panels_over(foot, 4, 0));
  line.is_collector = true;
  const std::vector<Barrier> both{net, line}, alone{line};
  PathPiece flight{.path = {Vec3(0, 0, 2), Vec3(10, 0, 0), Vec3{}}, .duration = 0.95, .spin = Vec3{}};
  PathCrossings with_net(both), without(alone);
  for (PathCrossings* each : {&with_net, &without}) {
    each->begin(0.5);
    each->add(flight);  // up to where it touches the net
    each->end(true);
  }
  ASSERT_EQ(with_net.found().hits.size(), 2u);
  EXPECT_EQ(with_net.found().hits[0].barrier.index, 1u);
  EXPECT_EQ(with_net.found().hits[1].outcome, BarrierOutcome::stopped);
  EXPECT_TRUE(without.found().hits.empty());
}

TEST(PathCrossings, AreSettledWithTheFirstHit) {
  Barrier line;
  const std::vector<Vec3> foot{{10, -5, 0}, {10, 5, 0}};
  line.set_panels(panels_over(foot, 4, 0));
  line.is_collector = true;
  const std::vector<Barrier> alone{line};
  PathCrossings crossings(alone);
  crossings.begin(0);
  PathPiece piece{.path = {Vec3(0, 0, 2), Vec3(10, 0, 0), Vec3{}}, .duration = 0.9, .spin = Vec3{}};
  crossings.add(piece);
  EXPECT_FALSE(crossings.is_settled(BarrierId{0}, 0.9));
  piece.path.p.x() = 9;
  piece.start_time = 0.9;
  crossings.add(piece);
  EXPECT_TRUE(crossings.is_settled(BarrierId{0}, 1.8));
  ASSERT_EQ(crossings.found().hits.size(), 1u);
  EXPECT_DOUBLE_EQ(crossings.found().hits[0].motion.time, 1.0);
}

}  // namespace
}  // namespace talus
