// Paths with a closed form: bounces on a plane, rest, the edge of the model, the limits of a run.

#include <gtest/gtest.h>

#include <cmath>

#include "support/meshes.hpp"
#include "support/scenes.hpp"
#include "talus/terrain/profile.hpp"

namespace talus::bounces_test {
namespace {

using namespace testing_tools;

const Rock rock = sphere_of_diameter(1.0, 2700);

Profile level_ground() { return Profile(std::vector<Vec2>{{-100, 0}, {0, 0}, {40, 0}, {100, 0}}); }

Laws plain_laws(RockModel model) {
  Laws laws;
  set_model(laws, model, false);
  return laws;
}

Release dropped(const Vec3& position, const Vec3& velocity = Vec3{}) { return {{position, velocity}, rock}; }

// Dropped from h, it bounces to Rn^2 h, Rn^4 h ... until it leaves the ground more slowly than the cutoff.
TEST(Bounces, OfABallOnLevelGround) {
  const Profile ground = level_ground();
  for (const RockModel model : {RockModel::lumped_mass, RockModel::rigid_sphere}) {
    for (const bool rotation : {true, false}) {
      const double h = 5, rn = 0.7, reach = model == RockModel::rigid_sphere ? rock.radius : 0;
      Soil soil;
      soil.rn = rn;
      Laws laws = plain_laws(model);
      set_model(laws, model, rotation);
      const Followed path = follow(ground, ground_of(soil), laws, dropped({3, 0, h + reach}));
      const double g = standard_gravity, v0 = std::sqrt(2 * g * h);
      // The velocity after impact k is v0 Rn^k; the first below the cutoff is the last.
      const int impacts = static_cast<int>(std::ceil(std::log(laws.normal_velocity_cutoff / v0) / std::log(rn)));
      EXPECT_EQ(path.outcome.events, impacts);
      EXPECT_EQ(path.outcome.reason, EndReason::at_rest);
      double time = std::sqrt(2 * h / g);
      int k = 0;
      for (const PathRow& row : path.log.rows) {
        if (row.state != PathState::impact) continue;
        EXPECT_NEAR(row.motion.time, time, 1e-12 * (k + 1));
        EXPECT_NEAR(row.motion.velocity.z(), -v0 * std::pow(rn, k), 1e-12);
        ++k;
        time += 2 * v0 * std::pow(rn, k) / g;
      }
      EXPECT_EQ(k, impacts);
      EXPECT_LT((path.outcome.end.position - Vec3(3, 0, reach)).norm(), 1e-12);
      EXPECT_NEAR(path.outcome.max_kinetic_energy, rock.mass * g * h, 1e-8);
      EXPECT_NEAR(path.outcome.max_bounce, h, 1e-12);
    }
  }
}

// Without tangential losses the motion along a plane is that of free fall.
TEST(Bounces, DownAPlaneWithThePlainLaw) {
  const double angle = 0.5;
  const Vec3 along(std::cos(angle), 0, -std::sin(angle)), n(std::sin(angle), 0, std::cos(angle));
  const Profile slope(std::vector<Vec2>{{0, 0}, {500 * std::cos(angle), -500 * std::sin(angle)}});
  Soil soil;
  soil.rn = 0.6;
  soil.rt = 1;
  const Vec3 start = 20 * along + 2 * n;
  const Followed path = follow(slope, ground_of(soil), plain_laws(RockModel::lumped_mass), dropped(start, 3 * along));
  const double ga = standard_gravity * std::sin(angle), gn = standard_gravity * std::cos(angle);
  double t = std::sqrt(2 * 2 / gn), normal_speed = std::sqrt(2 * gn * 2);
  int bounces = 0;
  for (const PathRow& row : path.log.rows) {
    if (row.state != PathState::impact || normal_speed < 0.1) continue;
    EXPECT_NEAR(row.motion.time, t, 1e-10);
    EXPECT_NEAR(row.motion.position.dot(along), 20 + 3 * t + 0.5 * ga * t * t, 1e-9);
    EXPECT_NEAR(row.motion.velocity.dot(along), 3 + ga * t, 1e-10);
    EXPECT_NEAR(row.motion.velocity.dot(n), -normal_speed, 1e-10);
    normal_speed *= 0.6;
    t += 2 * normal_speed / gn;
    ++bounces;
  }
  EXPECT_GT(bounces, 7);
}

TEST(Bounces, WithoutRestitutionItStaysDown) {
  Soil soil;
  soil.rn = 0;
  const Followed path =
      follow(level_ground(), ground_of(soil), plain_laws(RockModel::lumped_mass), dropped({0, 0, 2}, {4, 0, 0}));
  EXPECT_EQ(path.outcome.reason, EndReason::at_rest);
  EXPECT_EQ(path.outcome.events, 1);  // the seam between two level segments is no impact
}

TEST(Limits, MaximumTimeEndsInTheAir) {
  Laws laws = plain_laws(RockModel::lumped_mass);
  laws.max_time = 0.5;
  const Followed path = follow(level_ground(), ground_of({}), laws, dropped({0, 0, 50}, {1, 0, 0}));
  EXPECT_EQ(path.outcome.reason, EndReason::maximum_time);
  EXPECT_DOUBLE_EQ(path.outcome.end.time, 0.5);
  EXPECT_NEAR(path.outcome.end.position.z(), 50 - 0.5 * standard_gravity * 0.25, 1e-12);
}

TEST(Limits, MaximumStepsAreCounted) {
  Laws laws = plain_laws(RockModel::lumped_mass);
  laws.max_steps = 4;
  const Followed path = follow(level_ground(), ground_of({}), laws, dropped({0, 0, 50}, {1, 0, 0}));
  EXPECT_EQ(path.outcome.reason, EndReason::maximum_steps);
  EXPECT_EQ(path.outcome.events, 4);
}

TEST(Limits, LeavesTheModelAtItsEdge) {
  for (const RockModel model : {RockModel::lumped_mass, RockModel::rigid_sphere}) {
    const Followed path = follow(level_ground(), ground_of({}), plain_laws(model), dropped({99, 0, 5}, {10, 0, 0}));
    EXPECT_EQ(path.outcome.reason, EndReason::left_model);
    EXPECT_DOUBLE_EQ(path.outcome.end.position.x(), 100);
    EXPECT_NEAR(path.outcome.end.time, 0.1, 1e-14);
  }
}

TEST(Release, AtRestOnTheSurface) {
  for (const RockModel model : {RockModel::lumped_mass, RockModel::rigid_sphere}) {
    const double reach = model == RockModel::rigid_sphere ? rock.radius : 0;
    const Followed path = follow(level_ground(), ground_of({}), plain_laws(model), dropped({3, 0, reach}));
    EXPECT_EQ(path.outcome.reason, EndReason::at_rest);
    EXPECT_LT((path.outcome.end.position - Vec3(3, 0, reach)).norm(), 1e-12);
    EXPECT_EQ(path.outcome.end.time, 0);
  }
}

// On a slope it starts to move: it slides with g (sin - mu cos), or rolls with 5/7 g (sin - mu_r cos).
TEST(Release, OnASlopeStartsToMove) {
  const double angle = 0.6, length = 50;
  const Vec3 along(std::cos(angle), 0, -std::sin(angle)), n(std::sin(angle), 0, std::cos(angle));
  const Profile slope(std::vector<Vec2>{{0, 0}, {100 * along.x(), 100 * along.z()}});
  Soil soil;
  soil.phi = 0.3;
  soil.mu = 0.6;
  soil.rolling = 0.05;
  for (const RockModel model : {RockModel::lumped_mass, RockModel::rigid_sphere}) {
    const bool rolls = model == RockModel::rigid_sphere;
    Laws laws = plain_laws(model);
    laws.sliding = SlidingMethod::closed_form;
    const Followed path = follow(slope, ground_of(soil), laws, dropped(length * along + (rolls ? rock.radius : 0) * n));
    const double a = standard_gravity * (rolls ? 5.0 / 7 * (std::sin(angle) - 0.05 * std::cos(angle))
                                               : std::sin(angle) - std::tan(0.3) * std::cos(angle));
    // The last row on the slope, at its end, 50 m further down.
    const Motion& end = path.outcome.end;
    EXPECT_EQ(path.outcome.reason, EndReason::left_model);
    EXPECT_NEAR(end.velocity.norm(), std::sqrt(2 * a * 50), rolls ? 0.2 : 1e-6);
    EXPECT_NEAR(end.time, std::sqrt(2 * 50 / a), rolls ? 0.1 : 1e-6);
  }
}

TEST(Outcome, AgreesWithItsRows) {
  Dice dice(81);
  const TriangleMesh mesh = random_slope(dice, 20, 60, 0.7, 1.0).mesh();
  for (int number = 0; number < 50; ++number) {
    const Release release = dropped({dice.between(5, 20), dice.between(10, 50), 10}, 3 * dice.direction());
    const Followed path = follow(mesh, ground_of({}), Laws{}, release);
    const auto& rows = path.log.rows;
    std::int64_t events = 0;
    double most = 0;
    for (const PathRow& row : rows) {
      if (row.state == PathState::impact || row.state == PathState::barrier) ++events;
      most = std::max(most, kinetic_energy(row.motion, rock));
    }
    EXPECT_EQ(path.outcome.events, events);
    EXPECT_DOUBLE_EQ(path.outcome.max_kinetic_energy, most);
    EXPECT_EQ(path.outcome.start.position, rows.front().motion.position);
    EXPECT_EQ(path.outcome.end.position, rows.back().motion.position);
    // The outcome is the same if no rows are kept.
    RockLog brief(false);
    const Ground ground = ground_of({});
    const Laws laws;
    const RockOutcome again =
        follow_rock(Scene<TriangleMesh>{mesh, ground, {}, laws}, release, Draws(SamplingPlan{}, 0), brief);
    EXPECT_EQ(again.end.position, path.outcome.end.position);
    EXPECT_EQ(again.max_kinetic_energy, path.outcome.max_kinetic_energy);
    EXPECT_TRUE(brief.rows.empty());
  }
}

}  // namespace
}  // namespace talus::bounces_test
