// A rock on the ground: over seams, into rising ground, off edges, along valleys, into corners.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/meshes.hpp"
#include "support/scenes.hpp"
#include "talus/sliding/rolling.hpp"
#include "talus/terrain/profile.hpp"

namespace talus::along_the_ground_test {
namespace {

using namespace testing_tools;

const Rock rock = sphere_of_diameter(1.0, 2700);

Laws laws_of(RockModel model, SlidingMethod sliding = SlidingMethod::closed_form) {
  Laws laws;
  set_model(laws, model, false);
  laws.sliding = sliding;
  return laws;
}

const std::array both_methods{SlidingMethod::stepped, SlidingMethod::closed_form};

/// The sequence of states, without the release and the end.
std::vector<PathState> states(const Followed& path) {
  std::vector<PathState> between;
  for (std::size_t i = 1; i + 1 < path.log.rows.size(); ++i) between.push_back(path.log.rows[i].state);
  return between;
}

// Placed on the slope with a velocity along it.
Release on_slope(const Vec3& place, const Vec3& velocity) { return {{place, velocity}, rock}; }

TEST(Slide, OverASeamOfOnePlaneIsOneSlide) {
  Soil soil;
  soil.phi = 0.3;
  soil.rt = 1;
  const double v = 8, a = std::tan(0.3) * standard_gravity;
  for (const SlidingMethod sliding : both_methods) {
    const Profile seams(std::vector<Vec2>{{0, 0}, {3, 0}, {5, 0}, {5.5, 0}, {50, 0}});
    const Followed path =
        follow(seams, ground_of(soil), laws_of(RockModel::lumped_mass, sliding), on_slope({1, 0, 0}, {v, 0, 0}));
    EXPECT_EQ(path.outcome.reason, EndReason::at_rest);
    EXPECT_EQ(states(path), (std::vector{PathState::impact, PathState::sliding}));
    EXPECT_NEAR(path.outcome.end.position.x(), 1 + v * v / (2 * a), sliding == SlidingMethod::stepped ? 0.05 : 1e-9);
  }
}

TEST(Slide, IntoAnotherMaterialChangesTheFriction) {
  const Profile seam(std::vector<Vec2>{{0, 0}, {5, 0}, {50, 0}});
  Soil smooth, rough;
  smooth.phi = 0.1;
  rough.phi = 0.6;
  smooth.rt = rough.rt = 1;
  const Ground ground({material_of(smooth), material_of(rough)}, {MaterialId{0}, MaterialId{1}});
  const Followed path = follow(seam, ground, laws_of(RockModel::lumped_mass), on_slope({1, 0, 0}, {8, 0, 0}));
  const double at_seam = 64 - 2 * std::tan(0.1) * standard_gravity * 4;
  EXPECT_NEAR(path.outcome.end.position.x(), 5 + at_seam / (2 * std::tan(0.6) * standard_gravity), 1e-9);
}

TEST(Slide, IntoRisingGroundIsAnImpact) {
  const Profile kink(std::vector<Vec2>{{0, 0}, {5, 0}, {50, 20}});
  Soil soil;
  soil.rn = 0.4;
  soil.rt = 0.7;
  soil.phi = 0.2;
  const Followed path = follow(kink, ground_of(soil), laws_of(RockModel::lumped_mass), on_slope({1, 0, 0}, {9, 0, 0}));
  const auto& rows = path.log.rows;
  ASSERT_GT(rows.size(), 5U);
  EXPECT_EQ(rows[3].state, PathState::impact);
  EXPECT_LT((rows[3].motion.position - Vec3(5, 0, 0)).norm(), 1e-12);
  EXPECT_EQ(rows[4].state, PathState::projectile);
  const Vec3 n = Vec3(-20, 0, 45).normalized();
  EXPECT_NEAR(rows[4].motion.velocity.dot(n), -0.4 * rows[3].motion.velocity.dot(n), 1e-12);
  EXPECT_LT((tangential(rows[4].motion.velocity, n) - 0.7 * tangential(rows[3].motion.velocity, n)).norm(), 1e-12);
}

TEST(Slide, OffAConvexEdgeIsAFlight) {
  const Profile step(std::vector<Vec2>{{0, 0}, {5, 0}, {6, -8}, {50, -8}});
  Soil soil;
  soil.phi = 0.1;
  soil.rt = 1;
  for (const SlidingMethod sliding : both_methods) {
    const Followed path =
        follow(step, ground_of(soil), laws_of(RockModel::lumped_mass, sliding), on_slope({1, 0, 0}, {9, 0, 0}));
    const auto& rows = path.log.rows;
    ASSERT_GT(rows.size(), 5U);
    EXPECT_EQ(rows[4].state, PathState::projectile);
    EXPECT_LT((rows[4].motion.position - Vec3(5, 0, 0)).norm(), 1e-9);
    EXPECT_NEAR(rows[4].motion.velocity.z(), 0, 1e-12);
    EXPECT_EQ(rows[5].state, PathState::impact);
    EXPECT_NEAR(rows[5].motion.time - rows[4].motion.time, std::sqrt(16 / standard_gravity), 1e-9);
    EXPECT_NEAR(rows[5].motion.position.x(), 5 + rows[4].motion.velocity.x() * std::sqrt(16 / standard_gravity), 1e-9);
  }
}

// Three facets of one slope end at the rim of the model: the rock leaves there, not earlier or later.
TEST(Slide, OffTheRimLeavesTheModel) {
  Dice dice(141);
  const TriangleMesh mesh = irregular_field(dice, 10, 10, 20, 20, [](double x, double) { return -0.6 * x; }).mesh();
  Soil soil;
  soil.phi = 0.2;
  for (const RockModel model : {RockModel::lumped_mass, RockModel::rigid_sphere}) {
    for (const SlidingMethod sliding : both_methods) {
      const Vec3 n = Vec3(0.6, 0, 1).normalized();
      const double reach = model == RockModel::rigid_sphere ? rock.radius : 0;
      const Followed path = follow(mesh, ground_of(soil), laws_of(model, sliding),
                                   on_slope(Vec3(4, 9.3, -2.4) + reach * n, {1, 0.2, -0.6}));
      EXPECT_EQ(path.outcome.reason, EndReason::left_model);
      EXPECT_NEAR(path.outcome.end.position.x(), 20, reach + 1e-6);
    }
  }
}

TEST(Slide, UphillTurnsBackAndIsLogged) {
  const double angle = 0.6;
  const Vec3 along(std::cos(angle), 0, std::sin(angle));
  const Profile slope(std::vector<Vec2>{{0, 0}, {50 * along.x(), 50 * along.z()}});
  Soil soil;
  soil.phi = 0.3;
  soil.rt = 1;
  const Followed path =
      follow(slope, ground_of(soil), laws_of(RockModel::lumped_mass), on_slope(20 * along, 5 * along));
  const double up = standard_gravity * (std::sin(angle) + std::tan(0.3) * std::cos(angle));
  const double down = standard_gravity * (std::sin(angle) - std::tan(0.3) * std::cos(angle));
  ASSERT_EQ(path.log.turns.size(), 1U);
  EXPECT_NEAR(path.log.turns[0].time, 5 / up, 1e-9);
  EXPECT_NEAR(path.log.turns[0].position.dot(along), 20 + 25 / (2 * up), 1e-9);
  const double way = 20 + 25 / (2 * up);
  EXPECT_EQ(path.outcome.reason, EndReason::left_model);
  EXPECT_NEAR(path.outcome.end.time, 5 / up + std::sqrt(2 * way / down), 1e-6);
  EXPECT_NEAR(path.outcome.end.velocity.norm(), std::sqrt(2 * way * down), 1e-6);
}

// A trough of two planes that falls along x: once caught, the rock moves along its bottom.
TEST(Valley, ARockIsCaughtAndMovesAlongIt) {
  Dice dice(142);
  const auto height = [](double x, double y) { return 0.8 * std::abs(y - 20) - 0.5 * x; };
  const Shape shape = net(
      20, 20, [&](std::uint32_t i, std::uint32_t j) { return Vec3(2.0 * i, 2.0 * j, height(2.0 * i, 2.0 * j)); },
      [&](std::uint32_t, std::uint32_t) { return dice.chance(0.5); });
  const TriangleMesh mesh = shape.mesh();
  Soil soil;
  soil.rn = 0.2;
  soil.phi = 0.15;
  soil.rolling = 0.02;
  for (const RockModel model : {RockModel::lumped_mass, RockModel::rigid_sphere}) {
    for (const SlidingMethod sliding : both_methods) {
      const Followed path = follow(mesh, ground_of(soil), laws_of(model, sliding), on_slope({3, 16, 5}, {1, 0, 0}));
      EXPECT_EQ(path.outcome.reason, EndReason::left_model) << rows_up_to(path, path.log.rows.size() - 1);
      EXPECT_NEAR(path.outcome.end.position.y(), 20, 0.5);
      EXPECT_GT(path.outcome.end.position.x(), 39);
    }
  }
}

// A trough with sides at the angle `side` and a bottom that falls at `dip`: the sides press with cos(dip) / cos(side)
// of the weight, at a distance of cos(side) times the radius from the axis about which the sphere rolls.
TEST(Valley, ASphereSlipsIfFrictionIsTooSmall) {
  struct Case {
    double dip, side, mu, acceleration;  // acceleration: over that of gravity
  };
  const auto slips = [](double dip, double side, double mu) {
    return Case{dip, side, mu, std::sin(dip) - mu * std::cos(dip) / std::cos(side)};
  };
  const auto rolls = [](double dip, double side) {
    const double spun = 0.4 / (std::cos(side) * std::cos(side));
    return Case{dip, side, 3, std::sin(dip) / (1 + spun)};
  };
  for (const auto& [dip, side, mu, acceleration] : {slips(0.35, 0.8, 0), slips(0.6, 0.8, 0.05), slips(0.6, 1.0, 0.1),
                                                    slips(0.9, 0.5, 0.2), rolls(0.35, 0.8), rolls(0.6, 0.5)}) {
    // Rotated so that its bottom falls along x.
    const auto place = [dip = dip, side = side](std::uint32_t i, std::uint32_t j) {
      const double along = 60.0 * i, across = 10.0 * j - 10, up = std::tan(side) * std::abs(across);
      return Vec3(along * std::cos(dip) + up * std::sin(dip), across, up * std::cos(dip) - along * std::sin(dip));
    };
    const TriangleMesh mesh = net(1, 2, place, [](std::uint32_t, std::uint32_t) { return true; }).mesh();
    Soil soil;
    soil.mu = mu;
    soil.rolling = soil.rn = 0;
    soil.rt = 1;
    Laws laws = laws_of(RockModel::rigid_sphere);
    laws.max_time = 3;
    const Vec3 down(std::cos(dip), 0, -std::sin(dip)), up(std::sin(dip), 0, std::cos(dip));
    const Followed path =
        follow(mesh, ground_of(soil), laws, on_slope(2 * down + (rock.radius / std::cos(side) + 1e-4) * up, Vec3{}));
    ASSERT_EQ(path.outcome.reason, EndReason::maximum_time) << dip << ' ' << side << ' ' << mu;
    const double speed = path.outcome.end.velocity.dot(down);
    // It falls 0.1 mm first, which takes 5 ms of the 3 s.
    EXPECT_NEAR(speed / (3 * acceleration * standard_gravity), 1, 2e-3) << dip << ' ' << side << ' ' << mu;
    EXPECT_NEAR(path.outcome.end.position.dot(down), 2 + 1.5 * speed, 3e-3 * speed);
  }
}

TEST(Valley, ARockInAPitComesToRest) {
  const Profile pit(std::vector<Vec2>{{-10, 8}, {0, 0}, {10, 8}});
  Soil soil;
  soil.phi = 0.1;  // neither side alone would hold it
  soil.mu = 0.3;
  soil.rolling = 0.05;
  for (const RockModel model : {RockModel::lumped_mass, RockModel::rigid_sphere}) {
    for (const SlidingMethod sliding : both_methods) {
      const Followed path = follow(pit, ground_of(soil), laws_of(model, sliding), on_slope({-4, 0, 6}, {1, 0, 0}));
      EXPECT_EQ(path.outcome.reason, EndReason::at_rest);
      const double lowest = model == RockModel::rigid_sphere ? rock.radius / std::cos(std::atan(0.8)) : 0;
      EXPECT_LT((path.outcome.end.position - Vec3(0, 0, lowest)).norm(), 0.02);
    }
  }
}

// A ball on a slope of 30 degrees without rolling resistance: 5/7 g sin(30), over all seams.
TEST(Rolls, DownAPlaneOfManyFacets) {
  Dice dice(143);
  const double grade = std::tan(0.5);
  const TriangleMesh mesh = irregular_field(dice, 25, 8, 100, 30, [&](double x, double) { return -grade * x; }).mesh();
  Soil soil;
  soil.mu = 0.8;
  soil.rolling = 0;
  soil.rn = 0;
  Laws laws = laws_of(RockModel::rigid_sphere);
  laws.max_time = 4;
  const Vec3 n = Vec3(grade, 0, 1).normalized(), down = Vec3(1, 0, -grade).normalized();
  const Followed path =
      follow(mesh, ground_of(soil), laws, on_slope(Vec3(5, 14, -5 * grade) + rock.radius * n, {0, 0, 0}));
  EXPECT_EQ(path.outcome.reason, EndReason::maximum_time);
  const double a = 5.0 / 7 * standard_gravity * std::sin(0.5);
  EXPECT_NEAR(path.outcome.end.velocity.dot(down), 4 * a, 1e-6);
  const Vec3 way = path.outcome.end.position - path.outcome.start.position;
  EXPECT_LT((way - 8 * a * down).norm(), 1e-6);
  EXPECT_EQ(path.outcome.events, 1);
}

TEST(Rolls, OffALedge) {
  const Profile ledge(std::vector<Vec2>{{0, 0}, {10, 0}, {10, -5}, {40, -5}});
  Soil soil;
  soil.rolling = 0.01;
  const Followed path =
      follow(ledge, ground_of(soil), laws_of(RockModel::rigid_sphere), on_slope({2, 0, rock.radius}, {6, 0, 0}));
  // Faster than sqrt(g r), it takes off where its centre passes the ledge.
  const auto& rows = path.log.rows;
  std::size_t k = 0;
  while (k < rows.size() && rows[k].motion.position.x() < 9.999) ++k;
  ASSERT_LT(k, rows.size());
  EXPECT_NEAR(rows[k].motion.position.x(), 10, 1e-9);
  EXPECT_NEAR(rows[k].motion.position.z(), rock.radius, 1e-9);
  EXPECT_GT(rows[k].motion.velocity.x(), std::sqrt(standard_gravity * rock.radius));
  double landing = 0;
  for (const PathRow& row : rows) {
    if (row.motion.position.z() < -4 && landing == 0) landing = row.motion.time - rows[k].motion.time;
  }
  EXPECT_NEAR(landing, std::sqrt(2 * 5 / standard_gravity), 1e-6);
}

// Slower than that, it turns about the edge in contact with it, and falls close to the wall.
TEST(Rolls, SlowlyOverALedge) {
  const Profile ledge(std::vector<Vec2>{{0, 0}, {10, 0}, {10, -5}, {40, -5}});
  Soil soil;
  soil.rolling = 0.01;
  const Followed path =
      follow(ledge, ground_of(soil), laws_of(RockModel::rigid_sphere), on_slope({9.8, 0, rock.radius}, {0.7, 0, 0}));
  double first_below = 1e300;
  for (const PathRow& row : path.log.rows) {
    if (row.motion.position.z() < -4) first_below = std::min(first_below, row.motion.position.x());
    // It is never in the ground.
    const Vec3& p = row.motion.position;
    const double to_corner = std::hypot(p.x() - 10, p.z());
    EXPECT_GT(p.x() < 10 ? p.z() : p.z() > 0 ? to_corner : p.x() - 10, rock.radius - 1e-6);
  }
  EXPECT_LT(first_below, 13);
}

TEST(Rolls, IntoAWall) {
  const Profile wall(std::vector<Vec2>{{0, 0}, {10, 0}, {10, 5}, {40, 5}});
  Soil soil;
  soil.rn = 0.5;
  soil.rolling = 0.01;
  const Followed path =
      follow(wall, ground_of(soil), laws_of(RockModel::rigid_sphere), on_slope({2, 0, rock.radius}, {6, 0, 0}));
  double farthest = 0;
  const PathRow* before = nullptr;
  for (std::size_t i = 0; i + 1 < path.log.rows.size(); ++i) {
    const PathRow& row = path.log.rows[i];
    farthest = std::max(farthest, row.motion.position.x());
    if (before == nullptr && row.state == PathState::impact && row.motion.position.x() > 9) {
      before = &row;
      EXPECT_NEAR(path.log.rows[i + 1].motion.velocity.x(), -0.5 * row.motion.velocity.x(), 1e-9);
    }
  }
  ASSERT_NE(before, nullptr);
  EXPECT_NEAR(farthest, 10 - rock.radius, 1e-9);
  EXPECT_EQ(path.outcome.reason, EndReason::at_rest);
}

}  // namespace
}  // namespace talus::along_the_ground_test
