// The poses of a block for pictures: how far what they show is from its path.

#include "talus/results/poses.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "support/dice.hpp"
#include "support/meshes.hpp"
#include "support/scenes.hpp"
#include "talus/meshing/rock_shape.hpp"
#include "talus/trajectory/rock_run.hpp"

namespace talus {
namespace {

using namespace testing_tools;

struct BlockOnASlope {
  RockShape shape = box_shape({1.2, 0.8, 0.5});
  RockLog log{false, true};
  Vec3 inertia;

  explicit BlockOnASlope(Dice& dice) {
    const TriangleMesh mesh = random_slope(dice, 16, 60, 0.7, 0.6).mesh();
    const Ground ground = ground_of({.rn = 0.35, .rt = 0.8, .mu = 0.6, .rolling = 0.02});
    Laws laws;
    set_model(laws, RockModel::rigid_body);
    laws.gravity = {0, 0, -9.81};
    Release release;
    release.rock = sphere_of_diameter(1, 2700);
    release.shape = &shape;
    release.orientation = Orientation::of_turn(dice.between(0, 3) * dice.direction());
    release.motion.position = {10, 30, *mesh.elevation(10, 30) + 3};
    release.motion.spin = dice.in_cube(3);
    inertia = body_of(shape, release.rock).inertia;
    const Draws draws(SamplingPlan{}, 0);
    static_cast<void>(follow_rock(Scene<TriangleMesh>{mesh, ground, {}, laws}, release, draws, log));
  }
  [[nodiscard]] std::vector<Pose> poses(std::size_t max_poses = 1'000'000) const {
    return poses_along(log.pieces, log.attitudes, inertia, {}, max_poses);
  }
  [[nodiscard]] Vec3 position_at(double time) const {
    const PathPiece* piece = &log.pieces.front();
    for (const PathPiece& each : log.pieces)
      if (each.start_time <= time) piece = &each;
    return piece->path.at(std::min(time - piece->start_time, piece->duration));
  }
};

/// What a picture shows at a time.
Pose shown_at(const std::vector<Pose>& poses, double time) {
  std::size_t k = 1;
  while (k + 1 < poses.size() && poses[k].time < time) ++k;
  return between(poses[k - 1], poses[k], (time - poses[k - 1].time) / (poses[k].time - poses[k - 1].time));
}

TEST(Poses, TellWhereABlockIsAndHowItIsTurned) {
  Dice dice(11);
  double farthest = 0, most_turned = 0;
  for (int i = 0; i < 10; ++i) {
    const BlockOnASlope block(dice);
    const std::vector<Pose> poses = block.poses();
    const double end = poses.back().time;
    EXPECT_EQ(poses.front().time, 0);
    EXPECT_NEAR(end, block.log.pieces.back().time(block.log.pieces.back().duration), 1e-9);
    for (double time = 0; time < end; time += 0.0037) {
      const Pose shown = shown_at(poses, time);
      farthest = std::max(farthest, (shown.position - block.position_at(time)).norm());
      const Orientation turned = orientation_at(block.log.attitudes, block.inertia, time);
      most_turned = std::max(most_turned, angle_between(shown.orientation, turned));
    }
  }
  // The tolerance, and a little for times between those that were compared.
  EXPECT_LT(farthest, 0.03);
  EXPECT_LT(most_turned, 0.075);
  EXPECT_GT(most_turned, 0.02) << "there could be fewer poses";
}

TEST(Poses, AreFarApartWhereABlockTurnsEvenly) {
  // A quarter turn a second about an axis of inertia, without gravity.
  const Vec3 spin(0, 0, 0.5 * std::numbers::pi), velocity(3, 0, 0);
  const std::vector<PathPiece> pieces{{{{}, velocity, {}}, 1, 0, spin, false, {}, {}, {}, {}}};
  const std::vector<Attitude> attitudes{{0, {}, spin}};
  const std::vector<Pose> poses = poses_along(pieces, attitudes, {1, 2, 3}, {}, 100);
  ASSERT_EQ(poses.size(), 2U);
  EXPECT_NEAR((poses[1].position - velocity).norm(), 0, 1e-12);
  EXPECT_NEAR(angle_between(poses[1].orientation, Orientation::of_turn(spin)), 0, 1e-7);
  EXPECT_NEAR(angle_between(between(poses[0], poses[1], 0.3).orientation, Orientation::of_turn(0.3 * spin)), 0, 1e-7);
}

TEST(Poses, AreAtMostAsManyAsAskedFor) {
  Dice dice(12);
  const BlockOnASlope block(dice);
  const std::vector<Pose> all = block.poses(), few = block.poses(20), two = block.poses(2);
  EXPECT_GT(all.size(), 60U);
  EXPECT_LE(few.size(), 20U);
  ASSERT_EQ(two.size(), 2U);
  EXPECT_EQ(two[1].position, all.back().position);
}

TEST(Poses, TurnTheShorterWay) {
  const Pose from{0, {}, Orientation::of_turn({0.2, 0, 0})}, to{2, {4, 0, 0}, Orientation::of_turn({-0.2, 0, 0})};
  const Pose opposite{2, {4, 0, 0}, Orientation::of_unit(-to.orientation.w(), -to.orientation.xyz())};
  for (const Pose& end : {to, opposite}) {
    const Pose middle = between(from, end, 0.5);
    EXPECT_EQ(middle.time, 1);
    EXPECT_EQ(middle.position, Vec3(2, 0, 0));
    EXPECT_NEAR(angle_between(middle.orientation, {}), 0, 1e-7);
  }
}

}  // namespace
}  // namespace talus
