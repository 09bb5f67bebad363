// How blocks are turned along their trajectories, as a log keeps it: against the ground that they touch, and the
// energies that tables give.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/dice.hpp"
#include "support/meshes.hpp"
#include "support/scenes.hpp"
#include "talus/meshing/rock_shape.hpp"
#include "talus/trajectory/rock_run.hpp"

namespace talus {
namespace {

using namespace testing_tools;

struct OneBlock {
  TriangleMesh mesh;
  RockShape shape = box_shape({1, 0.8, 0.5});
  Laws with;
  Ground ground = ground_of({.rn = 0.35, .rt = 0.8, .mu = 0.6, .rolling = 0.02});
  Release release;

  explicit OneBlock(Dice& dice) : mesh(random_slope(dice, 16, 60, 0.7, 0.6).mesh()) {
    set_model(with, RockModel::rigid_body);
    with.gravity = {0, 0, -9.81};
    release.rock = sphere_of_diameter(1, 2700);
    release.shape = &shape;
    release.orientation = Orientation::of_turn(dice.between(0, 3) * dice.direction());
    release.motion.position = {10, 30, *mesh.elevation(10, 30) + 3};
    release.motion.spin = dice.in_cube(3);
  }
  [[nodiscard]] Body body() const { return body_of(shape, release.rock); }
  [[nodiscard]] RockLog follow() const {
    RockLog log(true, true);
    const Draws draws(SamplingPlan{}, 0);
    static_cast<void>(follow_rock(Scene<TriangleMesh>{mesh, ground, {}, with}, release, draws, log));
    return log;
  }
  /// Of the lowest corner of the block above the ground below it [m].
  [[nodiscard]] double gap(const PathRow& row) const {
    double lowest = 1e9;
    const Posture posture = body().at(row.motion.position, row.orientation->matrix());
    for (std::size_t i = 0; i < posture.corners.size(); ++i) {
      const Vec3 corner = posture.place(i);
      const auto ground_z = mesh.elevation(corner.x(), corner.y());
      if (ground_z) lowest = std::min(lowest, corner.z() - *ground_z);
    }
    return lowest;
  }
};

TEST(Orientations, PutACornerOnTheGroundAtEveryImpact) {
  Dice dice(3);
  std::size_t impacts = 0, close = 0;
  for (int i = 0; i < 20; ++i) {
    const OneBlock block(dice);
    const RockLog log = block.follow();
    for (std::size_t k = 0; k + 1 < log.rows.size(); ++k) {
      const PathRow& row = log.rows[k];
      ASSERT_TRUE(row.orientation.has_value());
      const bool takes_off = log.rows[k + 1].motion.velocity == row.motion.velocity;
      if (row.state != PathState::impact || takes_off) continue;
      // Corners sink by millimetres in steps on the ground; where a ridge strikes a face, all of them are higher.
      EXPECT_GT(block.gap(row), -0.02) << i;
      EXPECT_LT(block.gap(row), 0.5) << i;
      ++impacts;
      close += std::abs(block.gap(row)) < 2e-4 ? 1 : 0;
    }
  }
  EXPECT_GT(close, impacts / 10);
  EXPECT_GT(impacts, 100U);
}

TEST(Orientations, LeadFromOneToTheNextThroughFlights) {
  Dice dice(4);
  std::size_t flights = 0;
  for (int i = 0; i < 20; ++i) {
    const OneBlock block(dice);
    const RockLog log = block.follow();
    const Vec3 inertia = block.body().inertia;
    EXPECT_TRUE(std::ranges::is_sorted(log.attitudes, {}, &Attitude::time));
    for (std::size_t k = 1; k < log.rows.size(); ++k) {
      const PathRow &from = log.rows[k - 1], &to = log.rows[k];
      if (from.state != PathState::projectile || to.motion.time == from.motion.time) continue;
      const double halfway = 0.5 * (from.motion.time + to.motion.time);
      const Orientation middle = orientation_at(log.attitudes, inertia, halfway);
      // The flight's own rotation, from the attitude at its start.
      const auto start = std::ranges::upper_bound(log.attitudes, from.motion.time, {}, &Attitude::time) - 1;
      const FreeRotation turn(inertia, start->orientation, start->spin);
      EXPECT_LT(angle_between(turn.at(halfway - start->time).orientation, middle), 1e-6);
      EXPECT_LT(angle_between(turn.at(to.motion.time - start->time).orientation, *to.orientation), 1e-6);
      ++flights;
    }
  }
  EXPECT_GT(flights, 100U);
}

TEST(Orientations, HaveSpinsOfTheEnergyThatTablesGive) {
  Dice dice(5);
  for (int i = 0; i < 10; ++i) {
    const OneBlock block(dice);
    const RockLog log = block.follow();
    const Vec3 inertia = block.body().inertia;
    for (std::size_t k = 0; k + 1 < log.rows.size(); ++k) {
      const PathRow& row = log.rows[k];
      if (log.rows[k + 1].motion.time == row.motion.time) continue;
      const auto at = std::ranges::upper_bound(log.attitudes, row.motion.time, {}, &Attitude::time) - 1;
      ASSERT_EQ(at->time, row.motion.time);
      const Vec3 w = at->orientation.to_body(at->spin);
      const double energy = 0.5 * inertia.dot(w.times(w)), given = rotational_energy(block.release.rock, row.motion);
      EXPECT_NEAR(energy, given, 1e-9 * (1 + given));
    }
  }
}

TEST(Orientations, TellAWheelFromARod) {
  const TriangleMesh mesh =
      Shape{{{-50, -50, 0}, {50, -50, 0}, {50, 50, 0}, {-50, 50, 0}}, {{0, 1, 2}, {0, 2, 3}}}.mesh();
  const Ground ground = ground_of({.rn = 0.3, .rt = 0.8, .mu = 0.6});
  Laws with;
  set_model(with, RockModel::rigid_body);
  with.gravity = {0, 0, -9.81};
  const RockShape plate = box_shape({1, 1, 0.3});
  RockLog log(false);
  const auto share = [&](const Vec3& spin) {
    Release release;
    release.rock = sphere_of_diameter(1, 2700);
    release.shape = &plate;
    release.motion.position = {0, 0, 20};
    release.motion.spin = spin;
    with.max_time = 1.5;  // before it lands
    static_cast<void>(follow_rock(Scene<TriangleMesh>{mesh, ground, {}, with}, release, Draws(SamplingPlan{}, 0), log));
    EXPECT_NEAR(log.spin_axis.flown, 1.5, 1e-9);
    return log.spin_axis.share();
  };
  EXPECT_NEAR(share({0, 0, 5}), 1, 1e-12);
  EXPECT_NEAR(share({5, 0, 0}), 0, 1e-12);
}

}  // namespace
}  // namespace talus
