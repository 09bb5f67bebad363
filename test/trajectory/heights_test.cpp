// Heights have one datum for both models (rocks/heights.hpp): a block that lies on the ground has a bounce height of 0,
// and its top is a diameter above it. And how far rocks fly, slide and roll.

#include "talus/rocks/heights.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "support/scenes.hpp"
#include "talus/terrain/profile.hpp"

namespace talus::heights_test {
namespace {

using namespace testing_tools;

const Rock block = sphere_of_diameter(1.2, 2700);
constexpr RockModel models[] = {RockModel::lumped_mass, RockModel::rigid_sphere};

Laws laws_of(RockModel model) {
  Laws laws;
  set_model(laws, model, false);
  return laws;
}

/// Of a block whose lowest point is `lowest` above the origin of the slope.
Release released(RockModel model, double x, double lowest, const Vec3& velocity) {
  Release release;
  release.rock = block;
  release.motion.position = {x, 0, lowest + reach_of(model, block)};
  release.motion.velocity = velocity;
  return release;
}

Profile level() { return Profile(std::vector<Vec2>{{0, 0}, {1000, 0}}); }

std::vector<Barrier> panel_at(double x, bool is_collector, double height) {
  Barrier barrier;
  barrier.set_panels(panels_over(std::vector<Vec3>{{x, -5, 0}, {x, 5, 0}}, height, 0));
  barrier.capacity = std::numeric_limits<double>::infinity();
  barrier.is_collector = is_collector;
  return {barrier};
}

TEST(Heights, OfBothModelsAreOfTheSameBlock) {
  for (const RockModel model : models) {
    const Laws laws = laws_of(model);
    const Followed fall = follow(level(), ground_of({.rn = 0, .rt = 0}), laws, released(model, 5, 3, Vec3{}));
    EXPECT_NEAR(fall.outcome.max_bounce, 3, 1e-12);
    const Followed along = follow(level(), ground_of({.rn = 0}), laws, released(model, 5, 0, {8, 0, 0}));
    EXPECT_GT(along.outcome.end.position.x(), 6);
    EXPECT_NEAR(along.outcome.max_bounce, 0, 1e-8);
  }
}

// On a slope the lowest point of a sphere is above the ground that it touches uphill of it.
TEST(Heights, OfASphereOnASlopeAreOfItsLowestPoint) {
  const double angle = 0.6;
  const Profile slope(std::vector<Vec2>{{0, 0}, {300 * std::cos(angle), -300 * std::sin(angle)}});
  const Laws laws = laws_of(RockModel::rigid_sphere);
  Release release = released(RockModel::rigid_sphere, 0, 0, Vec3{});
  release.motion.position =
      10 * Vec3(std::cos(angle), 0, -std::sin(angle)) + block.radius * Vec3(std::sin(angle), 0, std::cos(angle));
  const Followed path = follow(slope, ground_of({.rn = 0, .mu = 1, .rolling = 0}), laws, release);
  EXPECT_NEAR(path.outcome.max_bounce, block.radius * (1 / std::cos(angle) - 1), 1e-8);
}

TEST(Heights, AtALineAreThoseOfTheTop) {
  for (const RockModel model : models) {
    for (const bool is_collector : {true, false}) {
      const auto at = [&](double lowest, double x) {
        const Followed path = follow(level(), ground_of({.rn = 0, .phi = 0.1}), laws_of(model),
                                     released(model, 5, lowest, {8, 0, 0}), panel_at(x, is_collector, 20));
        EXPECT_EQ(path.log.hits.size(), 1U);
        return path.log.hits.empty() ? -1 : top_over(path.log.hits.front().lowest, block.radius);
      };
      EXPECT_NEAR(at(0, 6.5), 1.2, 1e-8) << "it slides or rolls";
      const double before = is_collector ? 0 : reach_of(model, block);  // a sphere's centre stays before a fence
      const double flown = (1.5 - before) / 8;
      EXPECT_NEAR(at(4, 6.5), 4 + 1.2 - 0.5 * standard_gravity * flown * flown, 1e-9) << "it flies";
    }
  }
}

TEST(Heights, AboveALineAreThoseOfTheTop) {
  for (const RockModel model : models) {
    const Followed path = follow(level(), ground_of({.rn = 0, .rt = 0}), laws_of(model),
                                 released(model, 5, 4, {8, 0, 0}), panel_at(6.6, true, 1));
    ASSERT_EQ(path.log.passed_above.size(), 1U);
    const double lowest = 4 - 0.5 * standard_gravity * 0.2 * 0.2;
    EXPECT_NEAR(path.log.passed_above.front().lowest, lowest, 1e-9);
    EXPECT_NEAR(path.log.passed_above.front().clearance, lowest - 1, 1e-9);
  }
}

// A fall of 3 m, without a rebound, and a slide that friction ends: v^2 / (2 mu g).
TEST(Ways, AreFlownOrAlongTheGround) {
  for (const SlidingMethod method : {SlidingMethod::stepped, SlidingMethod::closed_form}) {
    Laws laws = laws_of(RockModel::lumped_mass);
    laws.sliding = method;
    const Followed fall =
        follow(level(), ground_of({.rn = 0, .rt = 0}), laws, released(RockModel::lumped_mass, 5, 3, Vec3{}));
    EXPECT_NEAR(fall.log.ways.flown, 3, 1e-12);
    EXPECT_EQ(fall.log.ways.on_ground, 0);
    const Followed slide =
        follow(level(), ground_of({.rt = 1}), laws, released(RockModel::lumped_mass, 5, 0, {8, 0, 0}));
    const double way = slide.outcome.end.position.x() - 5;
    EXPECT_GT(way, 3);
    EXPECT_NEAR(slide.log.ways.on_ground, way, 1e-9);
    EXPECT_NEAR(slide.log.ways.flown, 0, 1e-9);
  }
}

TEST(Ways, OfAllPiecesAreThoseOfThePath) {
  const Profile slope(std::vector<Vec2>{{0, 0}, {40, -30}, {60, -32}, {200, -32}});
  for (const RockModel model : models) {
    Followed path{{}, RockLog(true, true)};
    const Ground ground = ground_of({.rn = 0.4, .phi = 0.5});
    const Draws draws(SamplingPlan{}, 0);
    const Laws laws = laws_of(model);
    path.outcome =
        follow_rock(Scene<Profile>{slope, ground, {}, laws}, released(model, 2, 4, {1, 0, 0}), draws, path.log);
    RockWays sum;
    for (const PathPiece& piece : path.log.pieces) {
      const bool is_glide = piece.steps.count > 0;
      const PathPiece last = is_glide ? path.log.step_of(piece, piece.steps.count - 1) : piece;
      const double chord = (last.path.at(last.duration) - piece.path.p).norm();
      (piece.on_ground ? sum.on_ground : sum.flown) += chord;
    }
    EXPECT_GT(sum.flown, 10);
    EXPECT_GT(sum.on_ground, 1);
    EXPECT_NEAR(path.log.ways.flown, sum.flown, 1e-9);
    EXPECT_NEAR(path.log.ways.on_ground, sum.on_ground, 1e-6);
    RockLog again(false);
    (void)follow_rock(Scene<Profile>{slope, ground, {}, laws}, released(model, 2, 4, {1, 0, 0}), draws, again);
    EXPECT_EQ(again.ways.flown, path.log.ways.flown) << "whether the log keeps pieces or not";
    EXPECT_EQ(again.ways.on_ground, path.log.ways.on_ground);
  }
}

}  // namespace
}  // namespace talus::heights_test
