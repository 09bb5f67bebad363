// Rocks with a shape on planes and rough ground, against closed forms and published motions.

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "support/dice.hpp"
#include "support/meshes.hpp"
#include "support/scenes.hpp"
#include "talus/core/degrees.hpp"
#include "talus/core/stop.hpp"
#include "talus/terrain/triangle_mesh.hpp"
#include "talus/trajectory/rock_run.hpp"

namespace talus::bodies_test {
namespace {

using namespace testing_tools;

constexpr double g = 9.81;

/// A box, or a prism, of the volume of 1 m3 from corners and the moments of a body of these proportions.
RockShape shape_of(std::vector<Vec3> corners, const Vec3& gyration, double volume) {
  const double scale = 1 / std::cbrt(volume);
  RockShape shape;
  for (Vec3& corner : corners) {
    corner *= scale;
    shape.reach = std::max(shape.reach, corner.norm());
  }
  shape.corners = std::move(corners);
  shape.gyration = scale * scale * gyration;
  return shape;
}

RockShape box(const Vec3& size) {
  std::vector<Vec3> corners;
  for (const double x : {-1, 1}) {
    for (const double y : {-1, 1}) {
      for (const double z : {-1, 1}) corners.push_back(0.5 * size.times({x, y, z}));
    }
  }
  const Vec3 s = size.times(size);
  return shape_of(corners, Vec3{s[1] + s[2], s[0] + s[2], s[0] + s[1]} / 12, size[0] * size[1] * size[2]);
}

/// A prism along y over a regular polygon whose corners are at `radius`; the first side is below.
RockShape prism(int sides, double radius, double width) {
  const double a = std::numbers::pi / sides;
  std::vector<Vec3> corners;
  for (int i = 0; i < sides; ++i) {
    const double angle = -std::numbers::pi / 2 + a + 2 * a * i;
    for (const double y : {-0.5 * width, 0.5 * width}) {
      corners.push_back({radius * std::cos(angle), y, radius * std::sin(angle)});
    }
  }
  const double polar = radius * radius * (2 + std::cos(2 * a)) / 6;
  const double across = polar / 2 + width * width / 12;
  return shape_of(corners, {across, polar, across}, sides * radius * radius * std::sin(2 * a) / 2 * width);
}

/// A plane that falls along x by `slope` [rad], through the origin.
TriangleMesh plane(double slope) {
  const double far = 400, drop = std::tan(slope) * far;
  const Shape two{{{-far, -far, drop}, {far, -far, -drop}, {far, far, -drop}, {-far, far, drop}},
                  {{0, 1, 2}, {0, 2, 3}}};
  return two.mesh();
}

Laws laws() {
  Laws laws;
  set_model(laws, RockModel::rigid_sphere);
  laws.gravity = {0, 0, -g};
  laws.stopped_velocity = 0.01;
  return laws;
}

/// What a body's motion was at each moment that its run tells.
struct Recorder {
  std::vector<Motion> moments, rebounds;
  EndReason reason{};

  void operator()(const event::Leg& leg) { moments.push_back(leg.after); }
  void operator()(const event::Contact& contact) {
    if (contact.impact != nullptr) rebounds.push_back(contact.impact->after);
    moments.push_back(contact.after);
  }
  void operator()(const event::End& end) { moments.push_back(end.motion); }
};

struct OnPlane {
  double slope, friction, restitution = 0, rolling = 0;
  Laws with = laws();
  FrictionRise rise{};

  Recorder follow(const RockShape& shape, Release release) const {
    const TriangleMesh ground_surface = plane(slope);
    Material material = ground_of({.rn = restitution, .rt = 0.8, .mu = friction, .rolling = rolling}).materials()[0];
    material.friction_rise = rise;
    const Ground ground(material);
    release.shape = &shape;
    const Draws draws(SamplingPlan{}, 0);
    Recorder recorder;
    RockRun<TriangleMesh, Recorder> run({ground_surface, ground, {}, with}, release, draws, recorder);
    recorder.reason = run.follow().reason;
    return recorder;
  }
};

/// A rock of a shape and a volume [m3] that stands on a plane with the side below it; its centre is `height` above the
/// plane.
Release standing(double volume, double slope, double height) {
  Release release;
  release.rock = sphere_of_mass(2700 * volume, 2700);
  release.orientation = Orientation::of_turn({0, slope, 0});
  release.motion.position = release.orientation.to_world({0, 0, height + 1e-9});
  return release;
}

/// The body's rate of turning about y [rad/s], of a body that turns about its y.
double rate_about_y(const Motion& motion, const RockShape& shape, const Rock& rock) {
  const double moment = body_of(shape, rock).inertia[1];
  return std::copysign(motion.spin.norm() * std::sqrt(rock.inertia / moment), motion.spin.y());
}

TEST(Bodies, ACubeFallsOnItsFaceAndBouncesStraightUp) {
  const RockShape cube = box({1, 1, 1});
  Release release = standing(1, 0, 0.5 + 2);
  const Recorder seen = OnPlane{0, 0.5, 0.4}.follow(cube, release);
  ASSERT_GE(seen.rebounds.size(), 2U);
  const double fall = std::sqrt(2 * 2 / g);
  EXPECT_NEAR(seen.rebounds[0].time, fall, 1e-7);
  EXPECT_NEAR(seen.rebounds[0].velocity.z(), 0.4 * g * fall, 1e-6);
  EXPECT_NEAR(seen.rebounds[1].time, fall + 2 * 0.4 * fall, 1e-6);
  EXPECT_LT(seen.rebounds[0].spin.norm(), 1e-6);
  EXPECT_EQ(seen.reason, EndReason::at_rest);
  EXPECT_NEAR(seen.moments.back().position.z(), 0.5, 1e-4);
}

TEST(Bodies, ACubeSlidesDownOnItsFace) {
  const double slope = 35 * radians, mu = 0.3;
  const RockShape cube = box({1, 1, 1});
  OnPlane on{slope, mu};
  on.with.max_time = 3;
  const Recorder seen = on.follow(cube, standing(1, slope, 0.5));
  const Motion& end = seen.moments.back();
  EXPECT_NEAR(end.velocity.norm(), g * (std::sin(slope) - mu * std::cos(slope)) * 3, 0.02);
  EXPECT_LT(end.spin.norm(), 0.01);
}

TEST(Bodies, ACubeStaysWhereFrictionHoldsIt) {
  const double slope = 20 * radians;
  const Recorder seen = OnPlane{slope, 0.5}.follow(box({1, 1, 1}), standing(1, slope, 0.5));
  EXPECT_EQ(seen.reason, EndReason::at_rest);
  EXPECT_LT(seen.moments.back().position.norm() - 0.5, 1e-3);
  EXPECT_LT(seen.moments.back().time, 1);
}

// An octagon on one of its edges, its centre aside of it: its weight turns it with a lever of R sin(lean), and rolling
// friction resists with a lever of mu_r r. It does not creep.
TEST(Bodies, RollingFrictionHoldsABlockOnItsEdge) {
  const RockShape octagon = prism(8, 1, 1);
  const double volume = 8 * std::sin(std::numbers::pi / 4) / 2, rolling = 0.2;
  const double held = std::asin(rolling * std::cbrt(3 * volume / (4 * std::numbers::pi)));
  for (const double share : {0.5, 0.9, 1.1}) {
    Release release;
    release.rock = sphere_of_mass(2700 * volume, 2700);
    release.orientation = Orientation::of_turn({0, std::numbers::pi / 8 + share * held, 0});
    release.motion.position = {0, 0, std::cos(share * held) + 1e-9};
    const Recorder seen = OnPlane{0, 1, 0, rolling}.follow(octagon, release);
    EXPECT_EQ(seen.reason, EndReason::at_rest);
    const double moved = (seen.moments.back().position - release.motion.position).norm();
    if (share < 1) {
      EXPECT_LT(moved, 1e-6) << share;
      EXPECT_LT(seen.moments.back().time, 1) << share;
    } else {
      EXPECT_GT(moved, 0.1) << share;
    }
  }
}

// A cube on a corner that spins about the vertical as a top: friction under the corner takes its spin at a constant
// rate, 2/3 mu mu_r r m g / I, and it falls over or comes to rest.
TEST(Bodies, FrictionEndsThePivotOnACorner) {
  const RockShape cube = box({1, 1, 1});
  Release release;
  release.rock = sphere_of_mass(2700, 2700);
  const Vec3 diagonal = Vec3(1, 1, 1).normalized(), axis = diagonal.cross(-unit_z).normalized();
  release.orientation = Orientation::of_turn(std::acos(-diagonal.z()) * axis);
  release.motion.position = {0, 0, std::sqrt(0.75) + 1e-9};
  release.motion.spin = {0, 0, 2};
  const Recorder seen = OnPlane{0, 0.6, 0, 0.3}.follow(cube, release);
  EXPECT_EQ(seen.reason, EndReason::at_rest);
  const double rate = 2.0 / 3 * 0.6 * 0.3 * release.rock.radius * g / (1.0 / 6);
  EXPECT_NEAR(seen.moments.back().time, 2 / rate, 0.02);
  EXPECT_NEAR(seen.moments.back().position.z(), std::sqrt(0.75), 1e-3) << "rolling friction holds it upright";
}

// A cube on a corner, on a slope and leaning across it: its weight would pivot it, too. It is held, and does not creep.
TEST(Bodies, FrictionHoldsACubeOnACornerOfASlope) {
  const double slope = 8 * radians, lean = 3 * radians;
  const RockShape cube = box({1, 1, 1});
  Release release;
  release.rock = sphere_of_mass(2700, 2700);
  const Vec3 diagonal = Vec3(1, 1, 1).normalized(), axis = diagonal.cross(-unit_z).normalized();
  release.orientation = Orientation::of_turn({lean, 0, 0}) * Orientation::of_turn(std::acos(-diagonal.z()) * axis);
  release.motion.position = Orientation::of_turn({lean, 0, 0}).to_world({0, 0, std::sqrt(0.75) + 1e-9});
  const Recorder seen = OnPlane{slope, 0.6, 0, 0.3}.follow(cube, release);
  EXPECT_EQ(seen.reason, EndReason::at_rest);
  EXPECT_LT(seen.moments.back().time, 0.5);
  EXPECT_LT((seen.moments.back().position - release.motion.position).norm(), 1e-4);
}

// A brick of 0.5 x 1 m on a slope of 30 degrees turns over its lower edge: tan 30 > 0.5 / 1. Its turn is a pendulum's,
// from rest: times and rates by quadrature. Steps of 10 ms are of first order: within 1 % here.
TEST(Bodies, ABrickTipsAsAPendulum) {
  const double slope = 30 * radians;
  const RockShape brick = box({0.5, 1, 1});
  const Release release = standing(0.5, slope, 0.5);
  const Recorder seen = OnPlane{slope, 5}.follow(brick, release);
  struct Known {
    double turn, time, rate;
  };
  const std::vector<Known> known{{15, 0.652517, 1.141718}, {30, 0.819724, 2.075777}, {45, 0.924472, 2.968364}};
  double turn = 0;
  std::size_t next = 0;
  Motion last = release.motion;
  for (const Motion& now : seen.moments) {
    const double rate = rate_about_y(now, brick, release.rock), before = rate_about_y(last, brick, release.rock);
    const double step = now.time - last.time;
    turn += 0.5 * (rate + before) * step;
    if (next < known.size() && turn >= known[next].turn * radians) {
      const double share = (known[next].turn * radians - turn) / (0.5 * (rate + before) * step);
      EXPECT_NEAR(now.time + share * step, known[next].time, 0.01) << known[next].turn;
      EXPECT_NEAR(rate + share * (rate - before), known[next].rate, 0.03) << known[next].turn;
      ++next;
    }
    last = now;
  }
  EXPECT_EQ(next, known.size());
}

// A rimless wheel: of its energy a plastic impact leaves eta^2, and on a slope it comes to a steady rate after impacts.
// For a polygon I / (m R^2) = (2 + cos 2a) / 6, a = pi / n; eta = (k + cos 2a) / (1 + k);
// w = sqrt(eta^2 / (1 - eta^2) 4 g sin a sin s / (R (1 + k))). With steps of 2 ms it is within 0.5 %, with 10 ms
// within 1 %.
TEST(Bodies, APolygonRollsAsARimlessWheel) {
  for (const auto& [sides, degrees] : {std::pair{6, 15.0}, std::pair{8, 10.0}, std::pair{12, 5.0}}) {
    const double slope = degrees * radians, radius = 1, a = std::numbers::pi / sides;
    const double width = 1, volume = sides * radius * radius * std::sin(2 * a) / 2 * width;
    const RockShape wheel = prism(sides, radius, width);
    Release release = standing(volume, slope, radius * std::cos(a));
    release.motion.spin = {0, 2, 0};
    release.motion.velocity =
        release.motion.spin.cross(release.orientation.to_world({-radius * std::sin(a), 0, radius * std::cos(a)}));
    OnPlane on{slope, 10};
    on.with.max_time = 20;
    on.with.timestep = 0.002;
    const Recorder seen = on.follow(wheel, release);
    const double k = (2 + std::cos(2 * a)) / 6, eta = (k + std::cos(2 * a)) / (1 + k);
    const double steady =
        std::sqrt(eta * eta / (1 - eta * eta) * 4 * g * std::sin(a) * std::sin(slope) / (radius * (1 + k)));
    ASSERT_GT(seen.rebounds.size(), 10U) << sides;
    for (std::size_t i = seen.rebounds.size() - 3; i < seen.rebounds.size(); ++i) {
      EXPECT_NEAR(rate_about_y(seen.rebounds[i], wheel, release.rock), steady, 0.005 * steady) << sides;
    }
  }
}

// A box that tumbles and one that slides are held by a fence in their way.
TEST(Bodies, FencesHoldThem) {
  const double slope = 35 * radians, foot = -std::tan(slope) * 50;
  const TriangleMesh mesh = plane(slope);
  Barrier fence;
  fence.capacity = std::numeric_limits<double>::infinity();
  fence.set_panels(panels_over(std::vector<Vec3>{{50, 100, foot}, {50, -100, foot}}, 3, 0));
  const std::vector<Barrier> barriers{fence};
  const RockShape block = box({1.2, 0.9, 0.7});
  for (const double restitution : {0.0, 0.4}) {
    const Ground soil = ground_of({.rn = restitution, .rt = 0.8, .mu = 0.3, .rolling = 0});
    const Laws with = laws();
    for (const double fall : {0.0, 2.0}) {
      Release release = standing(1, slope, 0.7 + fall);
      release.shape = &block;
      const Draws draws(SamplingPlan{}, 0);
      RockLog log(true);
      RockRun<TriangleMesh> run({mesh, soil, BarrierList(barriers), with}, release, draws, log);
      EXPECT_EQ(run.follow().reason, EndReason::stopped_by_barrier);
      ASSERT_EQ(log.hits.size(), 1U);
      EXPECT_NEAR(log.hits[0].motion.position.x(), 50, 1);
    }
  }
}

// A block of 2 x 2 m slides down on its face, and friction rises with its way. The friction under a face that is as
// long as the centre is high twice over leaves (1 - mu) / 2 of the weight to its rear edge: it tips when mu(s) comes
// to 1. Way, time and velocity there by quadrature: Leine et al. 2014, 5.1.
TEST(Bodies, ABlockTipsWhereFrictionHasRisen) {
  const double slope = 45 * radians;
  const RockShape block = box({2, 10, 2});
  OnPlane on{slope, 0.2};
  on.rise = {1.3, 0.7, 20};
  on.with.timestep = 0.002;
  Release release = standing(40, slope, 1);
  const Recorder seen = on.follow(block, release);
  const auto turns = std::find_if(seen.moments.begin(), seen.moments.end(),
                                  [](const Motion& m) { return m.time > 0.1 && m.spin.norm() > 1e-4; });
  ASSERT_NE(turns, seen.moments.end());
  const Motion& last = *std::prev(turns);
  EXPECT_NEAR(last.time, 1.281369, 0.01);
  EXPECT_NEAR((last.position - release.motion.position).norm(), 3.128135, 0.035);
  EXPECT_NEAR(last.velocity.norm(), 3.491762, 0.01);
}

TEST(Bodies, FrictionRisesFromItsLeastToItsMost) {
  const FrictionRise rise{1.3, 0.7, 20}, none;
  EXPECT_EQ(rise.friction(0.2, 0), 0.2);
  EXPECT_NEAR(rise.friction(0.2, 3.128135), 1, 1e-6);
  EXPECT_NEAR(rise.friction(0.2, 1e9), 1.3, 1e-6);
  EXPECT_EQ(none.friction(0.2, 5), 0.2);
}

// A run that goes on from a copy of a body's state ends where the body does.
TEST(Bodies, GoOnFromACopyOfTheirState) {
  Dice dice(11);
  const std::atomic<bool> requested{true};
  const RockShape block = box({1, 0.8, 0.5});
  Material material = ground_of({.rn = 0.3, .rt = 0.8, .mu = 0.6, .rolling = 0.02, .roughness = 0.1}).materials()[0];
  material.friction_rise = {1.5, 2, 5};
  const Ground ground(material);
  Laws with = laws();
  with.roughness = RoughnessLaw::tilts;
  int copies = 0;
  for (int i = 0; i < 20; ++i) {
    const TriangleMesh mesh = random_slope(dice, 16, 60, 0.7, 0.6).mesh();
    const Scene<TriangleMesh> scene{mesh, ground, {}, with};
    Release release;
    release.rock = sphere_of_diameter(1, 2700);
    release.shape = &block;
    release.motion.position = {10, 30, *mesh.elevation(10, 30) + 3};
    const Draws draws(SamplingPlan{}, static_cast<std::uint64_t>(i));
    event::NoSink none;
    using Run = RockRun<TriangleMesh, event::NoSink>;
    const Motion end = Run(scene, release, draws, none).follow().end;
    const StopScope stop(&requested);
    std::optional<Run> run(std::in_place, scene, release, draws, none);
    while (run->advance(&stop) == Run::Pause::stopped) {
      const RockState copy = run->state();
      run.emplace(scene, release, copy, draws, none);
      ++copies;
    }
    EXPECT_EQ(run->outcome().end.position, end.position);
    EXPECT_EQ(run->outcome().end.time, end.time);
  }
  EXPECT_GT(copies, 5);
}

// Over random meshes: energy never grows, no rock is lost, and all come to an end.
TEST(Bodies, RandomRocksLoseEnergyOnly) {
  Dice dice(5);
  const RockShape shapes[] = {box({1, 1, 1}), box({1, 0.9, 0.4}), box({1, 0.5, 0.4}), prism(5, 0.7, 1)};
  struct Ledger {
    Rock rock;
    double least = std::numeric_limits<double>::infinity(), gain = 0;
    void see(const Motion& m) {
      const double energy = kinetic_energy(rock, m) + rock.mass * g * m.position.z();
      gain = std::max(gain, energy - least);
      least = std::min(least, energy);
    }
    void operator()(const event::Contact& contact) {
      see(contact.before);
      see(contact.after);
    }
    void operator()(const event::Leg& leg) {
      see(leg.before);
      see(leg.after);
    }
  };
  for (int i = 0; i < 200; ++i) {
    const TriangleMesh mesh = random_slope(dice, 16, 60, 0.7, 0.6).mesh();
    const Ground ground = ground_of({.rn = dice.between(0, 0.5),
                                     .rt = 0.8,
                                     .mu = dice.between(0.2, 1.2),
                                     .rolling = 0.05,
                                     .roughness = i % 2 == 0 ? 0 : 0.1});
    Laws with = laws();
    with.roughness = RoughnessLaw::tilts;
    Release release;
    release.rock = sphere_of_diameter(dice.between(0.4, 1.5), 2700);
    release.shape = &shapes[i % 4];
    release.orientation = Orientation::of_turn(dice.between(0, 3) * dice.direction());
    const double x = dice.between(5, 12), y = dice.between(10, 50);
    const auto z = mesh.elevation(x, y);
    if (!z) continue;
    release.motion.position = {x, y, *z + 2 * release.rock.radius + dice.between(0, 4)};
    release.motion.velocity = {dice.between(0, 3), dice.between(-1, 1), 0};
    release.motion.spin = dice.in_cube(3);
    Ledger ledger{release.rock};
    const Draws draws(SamplingPlan{}, static_cast<std::uint64_t>(i));
    RockRun<TriangleMesh, Ledger> run({mesh, ground, {}, with}, release, draws, ledger);
    const RockOutcome outcome = run.follow();
    EXPECT_NE(outcome.reason, EndReason::lost) << i;
    EXPECT_NE(outcome.reason, EndReason::maximum_steps) << i;
    EXPECT_LT(ledger.gain, 1e-9 * release.rock.mass * g) << i;
  }
}

}  // namespace
}  // namespace talus::bodies_test
