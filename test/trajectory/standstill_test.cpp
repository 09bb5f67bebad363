// Rocks that stand still for a moment, and that gravity or their spin moves again.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/meshes.hpp"
#include "support/scenes.hpp"
#include "talus/terrain/profile.hpp"

namespace talus::standstill_test {
namespace {

using namespace testing_tools;

const Rock rock = sphere_of_diameter(0.8, 2700);

Laws laws_of(RockModel model, double timestep = 0.01) {
  Laws laws;
  set_model(laws, model);
  laws.timestep = timestep;
  return laws;
}

/// Rises by `slope` to the right; a rock launched uphill slides back to the left.
Profile rising(double slope) { return Profile(std::vector<Vec2>{{-50, -50 * slope}, {50, 50 * slope}}); }

Vec3 along(double slope, double speed) { return speed * Vec3(1, 0, slope).normalized(); }

TEST(Standstill, OfASlideThatTurnsBackIsNoRestForAnyTimestep) {
  Soil soil;
  soil.phi = 0.5;  // the slope is 0.55
  const double slope = std::tan(0.55);
  for (const double timestep : {0.01, 1e-3, 1e-4}) {
    Laws laws = laws_of(RockModel::lumped_mass, timestep);
    laws.max_steps = 1'000'000'000;
    const Followed path = follow(rising(slope), ground_of(soil), laws, {{{0, 0, 0}, along(slope, 3)}, rock});
    EXPECT_EQ(path.outcome.reason, EndReason::left_model) << timestep;
    EXPECT_NEAR(path.outcome.end.position.x(), -50, 1e-6) << timestep;
  }
}

// A rock that is so slow at the rim of the model that it falls along it.
TEST(Standstill, AlmostAtTheRimIsNoFallThroughIt) {
  const Shape square = net(
      1, 1, [](std::uint32_t i, std::uint32_t j) { return Vec3(i - 1.0, j - 0.5, 1.0 - i); },
      [](std::uint32_t, std::uint32_t) { return true; });
  const TriangleMesh mesh = square.mesh();
  Soil soil;
  soil.phi = 0.1;
  for (const double speed : {1e-6, 1e-8, 1e-9}) {
    for (const SlidingMethod sliding : {SlidingMethod::stepped, SlidingMethod::closed_form}) {
      Laws laws = laws_of(RockModel::lumped_mass);
      laws.sliding = sliding;
      const Release release{{{-1e-18, 0.1, 1e-18}, Vec3(speed, 0, -speed)}, rock};
      const Followed path = follow(mesh, ground_of(soil), laws, release);
      EXPECT_EQ(path.outcome.reason, EndReason::left_model) << speed << rows_up_to(path, path.log.rows.size() - 1);
    }
  }
}

TEST(Standstill, OfASlippingSphereDoesNotLetItSinkIn) {
  Soil soil;
  soil.rt = 1;
  soil.mu = 0.131;
  soil.rolling = 0.256;
  const double slope = 0.22, angle = std::atan(slope);
  const Vec3 normal(-std::sin(angle), 0, std::cos(angle));
  const double braking = standard_gravity * (std::sin(angle) + soil.mu * std::cos(angle));
  const double gain = standard_gravity * (std::sin(angle) - soil.mu * std::cos(angle));
  const double speed = 3, way_up = speed * speed / (2 * braking);
  const double foot = (50 - rock.radius * std::sin(angle)) / std::cos(angle);  // distance from the start
  for (const double timestep : {0.03, 0.01, 0.001}) {
    const Followed path = follow(rising(slope), ground_of(soil), laws_of(RockModel::rigid_sphere, timestep),
                                 {{rock.radius * normal, along(slope, speed)}, rock});
    for (const PathRow& row : path.log.rows) {
      EXPECT_GT(normal.dot(row.motion.position) - rock.radius, -1e-8) << timestep;
    }
    // It slips without rolling: rolling resistance exceeds friction.
    const double expected = speed / braking + std::sqrt(2 * (way_up + foot) / gain);
    EXPECT_NEAR(path.outcome.end.time, expected, 1e-3 * expected) << timestep;
  }
}

TEST(Standstill, OfASphereThatSpinsIsNoRest) {
  Soil soil;
  soil.rt = 1;
  soil.mu = 0.3;
  soil.rolling = 0.1;
  const double spin = 20;
  const Followed path = follow(rising(0), ground_of(soil), laws_of(RockModel::rigid_sphere, 0.001),
                               {{{0, 0, rock.radius}, Vec3{}, {0, spin, 0}}, rock});
  EXPECT_EQ(path.outcome.reason, EndReason::at_rest);
  // While slipping, it accelerates with mu g; its spin decreases by 5/2 (mu + mu_r) g / r. Then it rolls, with 5/7 mu_r
  // g of deceleration.
  const double g = standard_gravity, r = rock.radius;
  const double slips = spin * r / (g * (soil.mu + 2.5 * (soil.mu + soil.rolling)));
  const double v = soil.mu * g * slips;
  // (It rests below 0.1 m/s, in the last centimetre.)
  EXPECT_NEAR(path.outcome.end.position.x(), 0.5 * v * slips + v * v / (2 * 5.0 / 7 * soil.rolling * g), 0.02);
}

TEST(Standstill, IsRestWithoutFrictionInAValley) {
  const Profile valley(std::vector<Vec2>{{0, 10}, {10, 0}, {20, 10}});
  Soil soil;
  soil.rn = 0.2;
  for (const SlidingMethod sliding : {SlidingMethod::stepped, SlidingMethod::closed_form}) {
    Laws laws = laws_of(RockModel::lumped_mass);
    laws.friction_source = FrictionSource::zero;
    laws.sliding = sliding;
    const Followed path = follow(valley, ground_of(soil), laws, {{{8, 0, 4}, {1, 0, 0}}, rock});
    EXPECT_EQ(path.outcome.reason, EndReason::at_rest);
    EXPECT_NEAR(path.outcome.end.position.x(), 10, 1e-3);
  }
}

TEST(Standstill, IsRestWithoutAStoppingVelocity) {
  Laws laws = laws_of(RockModel::lumped_mass);
  laws.stopped_velocity = 0;
  const Followed path = follow(rising(0.1), ground_of({}), laws, {{{0, 0, 0}, along(0.1, 3)}, rock});
  EXPECT_EQ(path.outcome.reason, EndReason::at_rest);
}

TEST(LeavingTheModel, IsWhereTheCentreIsOverTheRim) {
  // The sphere still touches the rim when its centre is beyond it.
  const Profile slope(std::vector<Vec2>{{0, 20}, {20, 0}});
  Soil soil;
  soil.rn = 0.1;
  const Rock large = sphere_of_diameter(2, 2700);
  for (const double speed : {0.5, 1.0, 2.0, 3.0}) {
    const Followed path =
        follow(slope, ground_of(soil), laws_of(RockModel::rigid_sphere), {{{17, 0, 6}, {speed, 0, 0}}, large});
    EXPECT_EQ(path.outcome.reason, EndReason::left_model);
    for (const PathRow& row : path.log.rows) {
      if (row.state == PathState::impact) {
        EXPECT_LE(row.motion.position.x(), 20 + 1e-9) << speed;
      }
    }
  }
}

TEST(Roughness, AlsoTiltsTheGroundUnderAVerticalFall) {
  Soil soil;
  soil.roughness = 0.1;
  Laws laws = laws_of(RockModel::lumped_mass);
  laws.impact = PlainImpact{};
  laws.in_section = true;
  int aside = 0;
  for (std::uint64_t k = 0; k < 50; ++k) {
    const Followed path = follow(rising(0), ground_of(soil), laws, {{{0, 0, 5}, Vec3{}}, rock}, {}, k);
    ASSERT_GT(path.log.rows.size(), 2U);
    const Vec3& after = path.log.rows[2].motion.velocity;
    aside += after.x() != 0 ? 1 : 0;
    EXPECT_EQ(after.y(), 0);
  }
  EXPECT_EQ(aside, 50);
}

}  // namespace
}  // namespace talus::standstill_test
