#include "talus/barriers/crossing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "support/dice.hpp"
#include "support/scenes.hpp"
#include "talus/terrain/profile.hpp"

namespace talus::barrier_test {
namespace {

using namespace testing_tools;

constexpr double infinite = std::numeric_limits<double>::infinity();
const Rock rock = sphere_of_diameter(1.0, 2700);

Barrier fence(const Vec3& from, const Vec3& to, double height, double inclination, double capacity) {
  Barrier barrier;
  barrier.name = "fence";
  barrier.set_panels(panels_over(std::vector<Vec3>{from, to}, height, inclination));
  barrier.capacity = capacity;
  return barrier;
}

Barrier collector(double x) {
  Barrier barrier = fence({x, -50, 0}, {x, 50, 0}, 100, 0, infinite);
  barrier.is_collector = true;
  return barrier;
}

// ---- panels ----

TEST(Panels, StandOnTheirFoot) {
  const auto panels = panels_over(std::vector<Vec3>{{0, 0, 1}, {4, 0, 1}, {4, 3, 5}}, 2, 0);
  ASSERT_EQ(panels.size(), 2U);
  EXPECT_EQ(panels[0].length, 4);
  EXPECT_EQ(panels[1].length, 5);
  for (const Panel& panel : panels) {
    EXPECT_EQ(panel.up, unit_z);
    EXPECT_EQ(panel.height, 2);
    EXPECT_NEAR(panel.normal.dot(panel.along), 0, 1e-15);
    EXPECT_NEAR(panel.normal.dot(panel.up), 0, 1e-15);
    EXPECT_NEAR(panel.normal.norm(), 1, 1e-15);
  }
}

TEST(Panels, LeanToTheRightOfTheirLine) {
  const auto panels = panels_over(std::vector<Vec3>{{0, 0, 0}, {0, 5, 0}}, 2, 0.3);
  EXPECT_LT((panels[0].up - Vec3(std::sin(0.3), 0, std::cos(0.3))).norm(), 1e-15);
}

// ---- crossings ----

TEST(Crossing, OfAFlight) {
  const std::vector<Barrier> barriers{fence({10, -5, 0}, {10, 5, 0}, 4, 0, infinite)};
  const Parabola path{{0, 0, 5}, {5, 0, 8}, {0, 0, -10}};
  const auto crossing = first_crossing(barriers, path, 0, 0, 10, {});
  ASSERT_TRUE(crossing);
  EXPECT_DOUBLE_EQ(crossing->t, 2);
  EXPECT_FALSE(crossing->above);
  EXPECT_NEAR(crossing->height, 1, 1e-12);
  EXPECT_LT((crossing->normal - Vec3(-1, 0, 0)).norm(), 1e-15);
}

TEST(Crossing, HeightIsMeasuredUpTheFace) {
  // Leaning by 30 degrees away from the rock, to the right of its line; met 2 m above the level of the foot, hence 2 /
  // cos 30 up the face.
  const double lean = std::numbers::pi / 6;
  const std::vector<Barrier> barriers{fence({10, -5, 0}, {10, 5, 0}, 4, lean, infinite)};
  const Parabola path{{0, 0, 2}, {5, 0, 0}, {0, 0, 0}};
  const auto crossing = first_crossing(barriers, path, 0, 0, 10, {});
  ASSERT_TRUE(crossing);
  EXPECT_NEAR(crossing->height, 2 / std::cos(lean), 1e-12);
  EXPECT_NEAR(crossing->t, (10 + 2 * std::tan(lean)) / 5, 1e-12);
}

// Compared to the panel's equation alone: a point meets a panel where it is in its plane and on its face, and passes
// above it where it is vertically above its top.
TEST(Crossing, IsNotMissedBecauseOfBounds) {
  Dice dice(301);
  int crossed = 0;
  for (int k = 0; k < 6000; ++k) {
    std::vector<Vec3> foot;
    for (std::size_t i = 0; i < 2 + dice.below(4); ++i) foot.push_back(dice.in_cube(20));
    std::vector<Barrier> barriers(1);
    barriers[0].set_panels(panels_over(foot, dice.between(0.5, 5), dice.chance(0.5) ? 0.0 : dice.between(-0.5, 0.5)));
    const Parabola path{dice.in_cube(20), dice.in_cube(15), Vec3{}};
    const double t_max = dice.between(0.1, 3);
    std::optional<double> expected;
    for (const Panel& panel : barriers[0].panels()) {
      // path.p + t path.v = foot + a along + h up
      const Vec3 solution = solved(panel.along, panel.up, -path.v, path.p - panel.foot);
      const double t = solution[2];
      const bool is_between_sides =
          solution[0] >= panel.start_at(solution[1]) && solution[0] <= panel.end_at(solution[1]);
      const bool is_on_it = is_between_sides && solution[1] >= 0 && solution[1] <= panel.height && t >= 0 && t <= t_max;
      if (is_on_it) expected = std::min(expected.value_or(t), t);
      const double top_start = panel.start_at(panel.height);
      const Vec3 above =
          solved(panel.along, unit_z, -path.v, path.p - panel.foot - top_start * panel.along - panel.height * panel.up);
      const bool is_over_it = above[0] >= 0 && above[0] <= panel.end_at(panel.height) - top_start && above[1] >= 0;
      if (is_over_it && above[2] >= 0 && above[2] <= t_max) expected = std::min(expected.value_or(above[2]), above[2]);
    }
    const auto crossing = first_crossing(barriers, path, 0, 0, t_max, {});
    if (!expected) continue;
    ++crossed;
    ASSERT_TRUE(crossing) << k;
    ASSERT_NEAR(crossing->t, *expected, 1e-6);
  }
  EXPECT_GT(crossed, 300);
}

// Barriers and collectors everywhere; the index finds those that are near.
TEST(BarrierList, FindsTheSameWithAnIndex) {
  Dice dice(303);
  std::vector<Barrier> barriers;
  for (int k = 0; k < 400; ++k) {
    const Vec3 from = dice.in_cube(100), to = from + dice.in_cube(dice.magnitude(1, 50));
    barriers.push_back(fence(from, to, dice.between(1, 20), dice.between(-0.5, 0.5), infinite));
    barriers.back().is_collector = dice.chance(0.5);
  }
  const PlanIndex index = index_of(barriers);
  int crossed = 0;
  for (int k = 0; k < 3000; ++k) {
    const Vec3 start = dice.in_cube(100);
    const Parabola path{start, dice.in_cube(20), {0, 0, -9.81}};
    const double radius = dice.chance(0.5) ? 0 : dice.between(0.1, 2);
    const auto all = first_crossing(barriers, path, radius, 0, 1, {});
    const auto near = first_crossing(BarrierList(barriers, index), path, radius, 0, 1, {});
    ASSERT_EQ(all.has_value(), near.has_value()) << k;
    if (all) {
      ++crossed;
      ASSERT_EQ(all->t, near->t) << k;
      ASSERT_EQ(all->barrier, near->barrier) << k;
      ASSERT_EQ(all->above, near->above) << k;
    }
    ASSERT_EQ(free_way(barriers, start, radius), free_way(BarrierList(barriers, index), start, radius)) << k;
  }
  EXPECT_GT(crossed, 300);
}

TEST(FreeWay, ReachesToTheNearestPanel) {
  const std::vector<Barrier> barriers{fence({12, -5, 0}, {12, 5, 0}, 4, 0, infinite),
                                      fence({0, 30, 0}, {5, 30, 0}, 4, 0, infinite)};
  EXPECT_NEAR(free_way(barriers, {2, 0, 7}, 0), 10, 1e-5);
  EXPECT_NEAR(free_way(barriers, {2, 25, 7}, 1), 4, 1e-5);
  EXPECT_EQ(free_way(barriers, {12, 1, 0}, 0), 0);
  EXPECT_EQ(free_way({}, {2, 0, 7}, 0), infinite);
}

TEST(Crossing, OfASphereIsARadiusBeforeThePanel) {
  const std::vector<Barrier> barriers{fence({10, -5, 0}, {10, 5, 0}, 4, 0, infinite)};
  const auto crossing = first_crossing(barriers, {{0, 0, 2}, {5, 0, 0}, {0, 0, 0}}, 0.5, 0, 10, {});
  ASSERT_TRUE(crossing);
  EXPECT_NEAR(crossing->t, 9.5 / 5, 1e-12);
  EXPECT_NEAR(crossing->height, 2, 1e-12);
}

TEST(Crossing, AboveHasItsClearance) {
  const std::vector<Barrier> barriers{fence({10, -5, 0}, {10, 5, 0}, 4, 0, infinite)};
  const auto point = first_crossing(barriers, {{0, 0, 7}, {5, 0, 0}, {0, 0, 0}}, 0, 0, 10, {});
  ASSERT_TRUE(point);
  EXPECT_TRUE(point->above);
  EXPECT_NEAR(point->clearance, 3, 1e-12);
  const auto sphere = first_crossing(barriers, {{0, 0, 7}, {5, 0, 0}, {0, 0, 0}}, 0.5, 0, 10, {});
  ASSERT_TRUE(sphere);
  EXPECT_TRUE(sphere->above);
  EXPECT_NEAR(sphere->clearance, 2.5, 1e-12);  // of the underside
}

TEST(Crossing, NextToOrBelowAPanelIsNone) {
  const std::vector<Barrier> barriers{fence({10, -5, 0}, {10, 5, 0}, 4, 0, infinite)};
  EXPECT_FALSE(first_crossing(barriers, {{0, 5.1, 2}, {5, 0, 0}, {0, 0, 0}}, 0, 0, 10, {}));
  EXPECT_FALSE(first_crossing(barriers, {{0, 0, 2}, {5, 0, 0}, {0, 0, 0}}, 0, 0, 1.9, {}));
  EXPECT_FALSE(first_crossing(barriers, {{0, 0, 2}, {-5, 0, 0}, {0, 0, 0}}, 0, 0, 10, {}));
  EXPECT_FALSE(first_crossing(barriers, {{0, 0, 2}, {0, 0, 0}, {0, 0, -10}}, 0, 0, 10, {}));
}

TEST(Crossing, FromBehindHasANormalAgainstTheRock) {
  const std::vector<Barrier> barriers{fence({10, -5, 0}, {10, 5, 0}, 4, 0, infinite)};
  const auto crossing = first_crossing(barriers, {{20, 0, 2}, {-5, 0, 0}, {0, 0, 0}}, 0, 0, 10, {});
  ASSERT_TRUE(crossing);
  EXPECT_NEAR(crossing->t, 2, 1e-12);
  EXPECT_LT((crossing->normal - Vec3(1, 0, 0)).norm(), 1e-15);
}

TEST(Crossing, IsTheFirstOfSeveralWithTiesByOrder) {
  const std::vector<Barrier> barriers{fence({12, -5, 0}, {12, 5, 0}, 4, 0, infinite),
                                      fence({10, -5, 0}, {10, 5, 0}, 4, 0, infinite),
                                      fence({10, -5, 0}, {10, 5, 0}, 4, 0, infinite)};
  const auto crossing = first_crossing(barriers, {{0, 0, 2}, {5, 0, 0}, {0, 0, 0}}, 0, 0, 10, {});
  ASSERT_TRUE(crossing);
  EXPECT_EQ(crossing->barrier, BarrierId{1});
  RecentCrossings met;
  met.record_passage(*crossing, 2.0, 2.0);
  const auto next = first_crossing(barriers, {{0, 0, 2}, {5, 0, 0}, {0, 0, 0}}, 0, 0, 10, met);
  ASSERT_TRUE(next);
  EXPECT_EQ(next->barrier, BarrierId{2});
}

TEST(Crossing, HasNoGapBetweenPanels) {
  const auto panels = panels_over(std::vector<Vec3>{{10, -5, 0}, {10, 0.1, 0}, {12, 5, 0}}, 4, 0);
  Barrier barrier;
  barrier.set_panels(panels);
  const std::vector<Barrier> barriers{barrier};
  for (const double y : {0.1, 0.1 + 1e-12, 0.1 - 1e-12, 0.1 + 1e-10}) {
    EXPECT_TRUE(first_crossing(barriers, {{0, y, 2}, {5, 0, 0}, {0, 0, 0}}, 0, 0, 10, {})) << y;
  }
}

// ---- response ----

TEST(BarrierResponse, StopsRocksUpToItsCapacity) {
  Motion motion;
  motion.velocity = {10, 0, 0};
  motion.spin = {0, 3, 0};
  const double energy = kinetic_energy(motion, rock);
  EXPECT_EQ(respond(fence(Vec3{}, {0, 1, 0}, 4, 0, energy), motion, {-1, 0, 0}, rock).outcome, BarrierOutcome::stopped);
  EXPECT_EQ(respond(fence(Vec3{}, {0, 1, 0}, 4, 0, infinite), motion, {-1, 0, 0}, rock).outcome,
            BarrierOutcome::stopped);
}

TEST(BarrierResponse, LetsRocksBreakThroughWithTheExcess) {
  Motion motion;
  motion.velocity = {10, 2, -4};
  motion.spin = {0, 3, 1};
  const double energy = kinetic_energy(motion, rock);
  for (const double capacity : {0.0, 0.3 * energy, 0.999 * energy}) {
    const auto [outcome, leaving] = respond(fence(Vec3{}, {0, 1, 0}, 4, 0, capacity), motion, {-1, 0, 0}, rock);
    EXPECT_EQ(outcome, BarrierOutcome::broke_through);
    ASSERT_TRUE(leaving);
    Motion after = motion;
    after.velocity = leaving->velocity;
    after.spin = leaving->spin;
    EXPECT_NEAR(kinetic_energy(after, rock), energy - capacity, 1e-12 * energy);
    EXPECT_LT(after.velocity.cross(motion.velocity).norm(), 1e-12);
    EXPECT_GE(after.velocity.dot(motion.velocity), 0);
  }
}

TEST(BarrierResponse, IsAReboundWithRestitution) {
  Barrier barrier = fence(Vec3{}, {0, 1, 0}, 4, 0, infinite);
  barrier.restitution = Restitution{0.2, 0.5};
  Motion motion;
  motion.velocity = {10, 2, -4};
  motion.spin = {0, 3, 1};
  const auto [outcome, leaving] = respond(barrier, motion, {-1, 0, 0}, rock);
  EXPECT_EQ(outcome, BarrierOutcome::rebounded);
  ASSERT_TRUE(leaving);
  EXPECT_LT((leaving->velocity - Vec3(-2, 1, -2)).norm(), 1e-14);
  EXPECT_EQ(leaving->spin, motion.spin);
}

TEST(BarrierResponse, OfACollectorIsNone) {
  Motion motion;
  motion.velocity = {10, 2, -4};
  const auto [outcome, leaving] = respond(collector(0), motion, {-1, 0, 0}, rock);
  EXPECT_EQ(outcome, BarrierOutcome::passed);
  ASSERT_TRUE(leaving);
  EXPECT_EQ(leaving->velocity, motion.velocity);
}

// ---- on a path ----

Profile level_ground() { return Profile(std::vector<Vec2>{{-100, 0}, {100, 0}}); }

Laws plain_laws(RockModel model = RockModel::lumped_mass) {
  Laws laws;
  set_model(laws, model, false);
  return laws;
}

Release launched(const Vec3& position, const Vec3& velocity) { return {{position, velocity}, rock}; }

TEST(BarrierOnAPath, StopsAFlight) {
  const std::vector<Barrier> barriers{fence({10, -5, 0}, {10, 5, 0}, 4, 0, infinite)};
  const Followed path = follow(level_ground(), ground_of({}), plain_laws(), launched({0, 0, 7}, {10, 0, 0}), barriers);
  EXPECT_EQ(path.outcome.reason, EndReason::stopped_by_barrier);
  ASSERT_EQ(path.log.hits.size(), 1U);
  const Passage& hit = path.log.hits[0];
  const double z = 7 - 0.5 * standard_gravity;
  EXPECT_DOUBLE_EQ(hit.motion.time, 1);
  EXPECT_NEAR(hit.height, z, 1e-12);
  EXPECT_EQ(hit.outcome, BarrierOutcome::stopped);
  // The rock arrives from above: the angle to the normal is positive towards the foot.
  EXPECT_NEAR(hit.angle(), std::atan2(standard_gravity, 10), 1e-12);
  const auto& rows = path.log.rows;
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[1].state, PathState::barrier);
  EXPECT_LT((path.outcome.end.position - Vec3(10, 0, z)).norm(), 1e-12);
}

TEST(BarrierOnAPath, StopsASlide) {
  const std::vector<Barrier> barriers{fence({10, -5, 0}, {10, 5, 0}, 4, 0, infinite)};
  for (const SlidingMethod sliding : {SlidingMethod::stepped, SlidingMethod::closed_form}) {
    Laws laws = plain_laws();
    laws.sliding = sliding;
    Soil soil;
    soil.phi = 0.1;
    const Followed path = follow(level_ground(), ground_of(soil), laws, launched({0, 0, 0}, {12, 0, 0}), barriers);
    EXPECT_EQ(path.outcome.reason, EndReason::stopped_by_barrier);
    ASSERT_EQ(path.log.hits.size(), 1U);
    EXPECT_NEAR(path.log.hits[0].motion.position.x(), 10, 1e-9);
    EXPECT_NEAR(path.log.hits[0].height, 0, 1e-9);
    const double v = soil.rt * 12;
    const double expected = std::sqrt(v * v - 2 * std::tan(0.1) * standard_gravity * 10);
    EXPECT_NEAR(path.log.hits[0].motion.velocity.x(), expected, sliding == SlidingMethod::stepped ? 0.02 : 1e-9);
  }
}

TEST(BarrierOnAPath, StopsARollingSphere) {
  const std::vector<Barrier> barriers{fence({10, -5, 0}, {10, 5, 0}, 4, 0, infinite)};
  const Followed path = follow(level_ground(), ground_of({}), plain_laws(RockModel::rigid_sphere),
                               launched({0, 0, rock.radius}, {12, 0, 0}), barriers);
  EXPECT_EQ(path.outcome.reason, EndReason::stopped_by_barrier);
  ASSERT_EQ(path.log.hits.size(), 1U);
  EXPECT_NEAR(path.log.hits[0].motion.position.x(), 10 - rock.radius, 1e-9);
  EXPECT_NEAR(path.log.hits[0].height, rock.radius, 1e-9);
}

TEST(BarrierOnAPath, BreaksThroughTwoInOneFlight) {
  const double energy = 0.5 * rock.mass * 400;
  const std::vector<Barrier> barriers{fence({10, -5, 0}, {10, 5, 0}, 20, 0, 0.25 * energy),
                                      fence({12, -5, 0}, {12, 5, 0}, 20, 0, 0.25 * energy)};
  const Followed path = follow(level_ground(), ground_of({}), plain_laws(), launched({0, 0, 15}, {20, 0, 0}), barriers);
  ASSERT_EQ(path.log.hits.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(path.log.hits[k].barrier, BarrierId{static_cast<std::uint32_t>(k)});
    EXPECT_EQ(path.log.hits[k].outcome, BarrierOutcome::broke_through);
  }
  // Each absorbs exactly its capacity.
  const auto& rows = path.log.rows;
  int taken = 0;
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    if (rows[i].state != PathState::barrier) continue;
    ++taken;
    EXPECT_NEAR(kinetic_energy(rows[i].motion, rock) - kinetic_energy(rows[i + 1].motion, rock), 0.25 * energy,
                1e-9 * energy);
    EXPECT_EQ(rows[i + 1].state, PathState::projectile);
    EXPECT_EQ(rows[i].motion.position, rows[i + 1].motion.position);
  }
  EXPECT_EQ(taken, 2);
}

TEST(BarrierOnAPath, MakesRocksRebound) {
  std::vector<Barrier> barriers{fence({10, -5, 0}, {10, 5, 0}, 20, 0, infinite)};
  barriers[0].restitution = Restitution{0.3, 0.9};
  for (const RockModel model : {RockModel::lumped_mass, RockModel::rigid_sphere}) {
    const Followed path =
        follow(level_ground(), ground_of({}), plain_laws(model), launched({0, 0, 7}, {10, 0, 0}), barriers);
    ASSERT_EQ(path.log.hits.size(), 1U);
    EXPECT_EQ(path.log.hits[0].outcome, BarrierOutcome::rebounded);
    EXPECT_LT(path.outcome.end.position.x(), 10);
    EXPECT_EQ(path.outcome.reason, EndReason::at_rest);
  }
}

TEST(BarrierOnAPath, IsPassedAboveWithAClearance) {
  const std::vector<Barrier> barriers{fence({10, -5, 0}, {10, 5, 0}, 1, 0, infinite)};
  const Followed path = follow(level_ground(), ground_of({}), plain_laws(), launched({0, 0, 7}, {10, 0, 0}), barriers);
  EXPECT_TRUE(path.log.hits.empty());
  ASSERT_EQ(path.log.passed_above.size(), 1U);
  EXPECT_NEAR(path.log.passed_above[0].clearance, 7 - 0.5 * standard_gravity - 1, 1e-12);
  EXPECT_GT(path.outcome.end.position.x(), 10);
}

TEST(BarrierOnAPath, AllCollectorsOnASlideRecordTheRock) {
  std::vector<Barrier> barriers;
  for (const double x : {2.0, 4.0, 4.001, 6.0}) barriers.push_back(collector(x));
  for (const RockModel model : {RockModel::lumped_mass, RockModel::rigid_sphere}) {
    for (const SlidingMethod sliding : {SlidingMethod::stepped, SlidingMethod::closed_form}) {
      Laws laws = plain_laws(model);
      laws.sliding = sliding;
      const double reach = model == RockModel::rigid_sphere ? rock.radius : 0;
      const Release release = launched({0, 0, reach}, {12, 0, 0});
      const Followed path = follow(level_ground(), ground_of({}), laws, release, barriers);
      ASSERT_EQ(path.log.hits.size(), 4U);
      for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_EQ(path.log.hits[k].barrier, BarrierId{static_cast<std::uint32_t>(k)});
        EXPECT_EQ(path.log.hits[k].outcome, BarrierOutcome::passed);
      }
      // Collectors do not change the path.
      const Followed alone = follow(level_ground(), ground_of({}), laws, release);
      EXPECT_EQ(path.outcome.end.position, alone.outcome.end.position);
      EXPECT_EQ(path.outcome.end.time, alone.outcome.end.time);
      EXPECT_EQ(path.outcome.events, alone.outcome.events);
    }
  }
}

TEST(BarrierOnAPath, ACollectorInTheAirChangesNothing) {
  const std::vector<Barrier> barriers{collector(5), collector(8)};
  const Release release = launched({0, 0, 7}, {10, 0, 0});
  const Followed path = follow(level_ground(), ground_of({}), plain_laws(), release, barriers);
  const Followed alone = follow(level_ground(), ground_of({}), plain_laws(), release);
  ASSERT_EQ(path.log.hits.size(), 2U);
  EXPECT_EQ(path.outcome.end.position, alone.outcome.end.position);
  EXPECT_EQ(path.log.rows.size(), alone.log.rows.size());
}

}  // namespace
}  // namespace talus::barrier_test
