// Difficult barriers: rebounds of rocks that gravity presses against the barrier, and barriers with bends.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "support/scenes.hpp"
#include "talus/barriers/crossing.hpp"
#include "talus/terrain/profile.hpp"

namespace talus::bends_and_rebounds_test {
namespace {

using namespace testing_tools;

constexpr double infinite = std::numeric_limits<double>::infinity();
const Rock rock = sphere_of_diameter(1.0, 2700);

Barrier standing(const std::vector<Vec3>& foot, double height, double inclination) {
  Barrier barrier;
  barrier.capacity = infinite;
  barrier.set_panels(panels_over(foot, height, inclination));
  return barrier;
}

/// A slope of 3 in 5, steeper than the friction of `slippery` can hold.
Profile steep_ground() { return Profile(std::vector<Vec2>{{-100, 60}, {100, -60}}); }
Profile level_ground() { return Profile(std::vector<Vec2>{{-100, 0}, {100, 0}}); }

Soil slippery() {
  Soil soil;
  soil.phi = 0.3;
  return soil;
}

Laws laws_of(RockModel model, SlidingMethod sliding) {
  Laws laws;
  set_model(laws, model);
  laws.sliding = sliding;
  return laws;
}

TEST(ReboundingBarrier, StopsRocksThatGravityPressesAgainstIt) {
  for (const RockModel model : {RockModel::lumped_mass, RockModel::rigid_sphere}) {
    for (const SlidingMethod sliding : {SlidingMethod::stepped, SlidingMethod::closed_form}) {
      for (const double rn : {0.0, 0.1, 0.3, 0.9}) {
        for (const double inclination : {-0.5, -0.2, 0.0, 0.2, 0.5}) {
          std::vector<Barrier> barriers{standing({{10, -5, -6}, {10, 5, -6}}, 30, inclination)};
          barriers[0].restitution = Restitution{rn, 0.6};
          const Followed path = follow(steep_ground(), ground_of(slippery()), laws_of(model, sliding),
                                       {{{-3, 0, 5}, {2, 0, 0}}, rock}, barriers);
          SCOPED_TRACE(::testing::Message() << "rn " << rn << ", inclination " << inclination << ", model "
                                            << static_cast<int>(model) << ", sliding " << static_cast<int>(sliding));
          EXPECT_EQ(path.outcome.reason, EndReason::stopped_by_barrier);
          ASSERT_FALSE(path.log.hits.empty());
          EXPECT_EQ(path.log.hits.back().outcome, BarrierOutcome::stopped);
          const Vec3 from_foot = path.outcome.end.position - Vec3(10, 0, -6);
          EXPECT_LT(from_foot.x() - std::tan(inclination) * from_foot.z(), 1e-9);
          for (const Passage& hit : path.log.hits) EXPECT_TRUE(std::isfinite(hit.angle()));
        }
      }
    }
  }
}

TEST(ReboundingBarrier, ReleasesRocksThatGravityPullsAway) {
  // The rock arrives from below and slides down again.
  std::vector<Barrier> barriers{standing({{-10, -5, 6}, {-10, 5, 6}}, 30, 0)};
  barriers[0].restitution = Restitution{0, 0.6};
  const Followed path =
      follow(steep_ground(), ground_of(slippery()), laws_of(RockModel::lumped_mass, SlidingMethod::stepped),
             {{{-8, 0, 4.8}, {-12, 0, 7.2}}, rock}, barriers);
  ASSERT_EQ(path.log.hits.size(), 1U);
  EXPECT_EQ(path.log.hits[0].outcome, BarrierOutcome::rebounded);
  EXPECT_EQ(path.outcome.reason, EndReason::left_model);
  EXPECT_GT(path.outcome.end.position.x(), 99);
}

TEST(Collectors, OnOneLineRecordEachRockOnce) {
  std::vector<Barrier> barriers(20, standing({{5, -5, 0}, {5, 5, 0}}, 100, 0));
  for (Barrier& each : barriers) each.is_collector = true;
  for (const RockModel model : {RockModel::lumped_mass, RockModel::rigid_sphere}) {
    for (const double z : {0.0, 3.0}) {
      const double reach = model == RockModel::rigid_sphere ? rock.radius : 0;
      const Followed path = follow(level_ground(), ground_of(slippery()), laws_of(model, SlidingMethod::stepped),
                                   {{{0, 0, z + reach}, {12, 0, 0}}, rock}, barriers);
      ASSERT_EQ(path.log.hits.size(), barriers.size());
      for (std::size_t k = 0; k < barriers.size(); ++k) {
        EXPECT_EQ(path.log.hits[k].barrier, BarrierId{static_cast<std::uint32_t>(k)});
      }
    }
  }
}

std::vector<Passage> hits_of(const Followed& path, std::uint32_t barrier) {
  std::vector<Passage> hits;
  for (const Passage& hit : path.log.hits) {
    if (hit.barrier == BarrierId{barrier}) hits.push_back(hit);
  }
  return hits;
}

/// One that stops rocks, one that they break through, two with rebounds.
std::vector<Barrier> barriers_of_all_kinds(double inclination) {
  std::vector<Barrier> barriers(4, standing({{10, -5, -6}, {10, 5, -6}}, 30, inclination));
  barriers[1].capacity = 10;
  barriers[2].restitution = Restitution{0.5, 0.8};
  barriers[3].restitution = Restitution{0.02, 0.1};
  return barriers;
}

TEST(Collectors, OnTheLineOfABarrierRecordArrivals) {
  for (const RockModel model : {RockModel::lumped_mass, RockModel::rigid_sphere}) {
    for (const SlidingMethod sliding : {SlidingMethod::stepped, SlidingMethod::closed_form}) {
      for (const double inclination : {-0.2, 0.0, 0.2}) {
        for (const Barrier& barrier : barriers_of_all_kinds(inclination)) {
          // Collectors before and after the barrier in the list, one drawn with other points.
          Barrier collector = standing({{10, -5, -6}, {10, 5, -6}}, 30, inclination);
          Barrier longer = standing({{10, -7.1, -6}, {10, 1.0 / 3, -6}, {10, 9.7, -6}}, 30, inclination);
          collector.is_collector = longer.is_collector = true;
          const std::vector<Barrier> barriers{collector, barrier, longer};
          for (const double start_z : {1.8, 5.0}) {
            const Followed path = follow(steep_ground(), ground_of(slippery()), laws_of(model, sliding),
                                         {{{-3, 0, start_z}, {2, 0.01, 0}}, rock}, barriers);
            SCOPED_TRACE(::testing::Message() << "inclination " << inclination << ", model " << static_cast<int>(model)
                                              << ", sliding " << static_cast<int>(sliding) << ", from " << start_z);
            const auto stopped = hits_of(path, 1);
            ASSERT_FALSE(stopped.empty());
            for (const std::uint32_t number : {0U, 2U}) {
              const auto recorded = hits_of(path, number);
              ASSERT_EQ(recorded.size(), stopped.size()) << number;
              for (std::size_t k = 0; k < stopped.size(); ++k) {
                EXPECT_EQ(recorded[k].outcome, BarrierOutcome::passed);
                EXPECT_LT((recorded[k].motion.velocity - stopped[k].motion.velocity).norm(), 1e-6);
                EXPECT_NEAR(recorded[k].motion.time, stopped[k].motion.time, tolerance::same_crossing);
                EXPECT_NEAR(recorded[k].height, stopped[k].height, 1e-6);
              }
            }
          }
        }
      }
    }
  }
}

TEST(Collectors, OnTheLineOfTwoBarriersRecordEachRockOnce) {
  std::vector<Barrier> barriers(3, standing({{10, -5, -6}, {10, 5, -6}}, 30, 0));
  barriers[0].capacity = 10;
  barriers[2].is_collector = true;
  for (const RockModel model : {RockModel::lumped_mass, RockModel::rigid_sphere}) {
    const Followed path = follow(steep_ground(), ground_of(slippery()), laws_of(model, SlidingMethod::stepped),
                                 {{{-3, 0, 5}, {2, 0, 0}}, rock}, barriers);
    ASSERT_EQ(path.log.hits.size(), 3U);
    EXPECT_EQ(path.log.hits[0].barrier, BarrierId{2});
    EXPECT_EQ(path.log.hits[1].outcome, BarrierOutcome::broke_through);
    EXPECT_EQ(path.log.hits[2].outcome, BarrierOutcome::stopped);
    EXPECT_EQ(path.log.hits[0].motion.velocity, path.log.hits[1].motion.velocity);
  }
}

// A rock meets the barrier above the collector's top.
TEST(Collectors, OnTheLineOfAHigherBarrierRecordRocksAboveThem) {
  std::vector<Barrier> barriers{standing({{5, -5, 0}, {5, 5, 0}}, 10, 0), standing({{5, -5, 0}, {5, 5, 0}}, 1, 0)};
  barriers[1].is_collector = true;
  const Followed path =
      follow(level_ground(), ground_of(slippery()), laws_of(RockModel::lumped_mass, SlidingMethod::stepped),
             {{{0, 0, 6}, {20, 0, 0}}, rock}, barriers);
  EXPECT_EQ(path.outcome.reason, EndReason::stopped_by_barrier);
  ASSERT_EQ(path.log.passed_above.size(), 1U);
  EXPECT_EQ(path.log.passed_above[0].barrier, BarrierId{1});
}

struct Bend {
  double inclination, turn;  // turn: offset of the line's ends along x, 40 m from its middle [m]; positive: concave
  bool is_sphere;
};

class AtABend : public ::testing::TestWithParam<Bend> {};

TEST_P(AtABend, NoRockGetsThroughAndNoneIsRecordedTwice) {
  const Bend& bend = GetParam();
  const RockModel model = bend.is_sphere ? RockModel::rigid_sphere : RockModel::lumped_mass;
  for (const bool is_collector : {false, true}) {
    for (double y = -2; y <= 2; y += 0.03) {
      // The rock flies along y = 0; the line is shifted along y.
      std::vector<Barrier> barriers{
          standing({{10 - bend.turn, y - 40, 0}, {10, y, 0}, {10 - bend.turn, y + 40, 0}}, 8, bend.inclination)};
      barriers[0].is_collector = is_collector;
      const Followed path = follow(level_ground(), ground_of(slippery()), laws_of(model, SlidingMethod::stepped),
                                   {{{0, 0, 4}, {25, 0, 0}}, rock}, barriers);
      ASSERT_EQ(path.log.hits.size(), 1U) << y << (is_collector ? ", collector" : "");
      // If the barrier leans, its bend is further along the line at the height of the rock than at the foot.
      const double shift = std::abs(std::tan(bend.inclination)) * 4, reach = 2 * rock.radius;
      EXPECT_NEAR(path.log.hits[0].station, std::hypot(bend.turn, 40) * (1 - y / 40), 2 * (shift + reach)) << y;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Barriers, AtABend,
                         ::testing::Values(Bend{0, -30, true}, Bend{0, 30, true}, Bend{0.35, -30, true},
                                           Bend{-0.35, -30, true}, Bend{0.35, 30, true}, Bend{-0.35, 30, true},
                                           Bend{0, -30, false}, Bend{0, 30, false}, Bend{0.35, -30, false},
                                           Bend{-0.35, -30, false}, Bend{0.35, 30, false}, Bend{-0.35, 30, false}));

TEST(Crossing, OfASphereWithTheSideOfTwoPanels) {
  // Two panels meet at a right angle, with their edge towards the sphere.
  const std::vector<Barrier> barriers{standing({{13, -3, 0}, {10, 0, 0}, {13, 3, 0}}, 4, 0)};
  const auto crossing = first_crossing(barriers, {{0, 0.1, 2}, {5, 0, 0}, {0, 0, 0}}, 0.5, 0, 10, {});
  ASSERT_TRUE(crossing);
  EXPECT_NEAR(crossing->t, (10 - std::sqrt(0.25 - 0.01)) / 5, 1e-12);
  EXPECT_NEAR(crossing->height, 2, 1e-12);
  EXPECT_NEAR(crossing->station, std::hypot(3, 3), 1e-12);
  EXPECT_LT((crossing->normal - Vec3(-std::sqrt(0.24), 0.1, 0) / 0.5).norm(), 1e-12);
}

}  // namespace
}  // namespace talus::bends_and_rebounds_test
