// Rocks in forests and on soft ground: compared to closed forms, and at the forest's borders.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "support/meshes.hpp"
#include "support/scenes.hpp"
#include "talus/rocks/drag.hpp"
#include "talus/rocks/touch.hpp"
#include "talus/terrain/profile.hpp"
#include "talus/terrain/raster_surface.hpp"
#include "trajectory/forest_scenes.hpp"

namespace talus::trajectory_drag_test {
namespace {

using namespace testing_tools;

constexpr double g = standard_gravity;

// The first arrival on the ground.
Motion arrival(const Followed& path) {
  for (const PathRow& row : path.log.rows) {
    if (row.state == PathState::impact) return row.motion;
  }
  ADD_FAILURE() << "the rock never arrives";
  return {};
}

// The closed form of linear drag, and the time at which it falls to a height.
struct Exact {
  double rate;
  Vec3 p, v;
  [[nodiscard]] Vec3 velocity(double t) const {
    return std::exp(-rate * t) * v - (1 - std::exp(-rate * t)) * Vec3(0, 0, g / rate);
  }
  [[nodiscard]] Vec3 place(double t) const {
    const Vec3 terminal(0, 0, -g / rate);
    return p + terminal * t + (v - terminal) * (1 - std::exp(-rate * t)) / rate;
  }
  [[nodiscard]] double falls_to(double z) const {
    double low = 0, high = 1000;
    while (velocity(low).z() > 0) low += 1e-3;
    for (int k = 0; k < 200; ++k) (place(0.5 * (low + high)).z() > z ? low : high) = 0.5 * (low + high);
    return low;
  }
};

void expect_arrival(const Motion& found, const Exact& exact, double z) {
  // A piece runs up to a millimetre too low between its ends, so that a rock arrives that much too early.
  const double t = exact.falls_to(z), early = 1.1 * tolerance::drag_piece / std::abs(exact.velocity(t).z());
  EXPECT_LE(found.time, t + 1e-9);
  EXPECT_GE(found.time, t - early);
  EXPECT_LT((found.velocity - exact.velocity(found.time)).norm(), 1e-9);
  EXPECT_LT((found.position - exact.place(found.time)).norm(), tolerance::drag_piece);
}

TEST(Forest, AFallInItIsTheClosedForm) {
  const Profile ground(level);
  for (const double mass : {40.0, 100.0, 1000.0, 50000.0}) {
    const Ground trees(grown_over({}, 500, 30));
    const Release release = launched(mass, {0, 0, 29}, Vec3{});
    expect_arrival(arrival(follow(ground, trees, {}, release)), {500 / mass, release.motion.position, Vec3{}}, 0);
  }
}

// Pebbles sink at terminal speed, to within a thousandth.
TEST(Forest, PebblesSinkAtTerminalSpeed) {
  const Profile ground(level);
  const Motion end = arrival(follow(ground, Ground(grown_over({}, 750, 30)), {}, launched(2, {0, 0, 10}, {9, 0, 3})));
  const Exact exact{375, {0, 0, 10}, {9, 0, 3}};
  const double t = exact.falls_to(0);
  EXPECT_NEAR(end.time, t, 1e-3 * t);
  EXPECT_LT((end.position - exact.place(t)).norm(), 0.02);
}

TEST(Forest, AFlightInItIsTheClosedForm) {
  const Profile ground(level);
  const Ground trees(grown_over({}, 750, 100));
  for (const Vec3& v : {Vec3(15, 0, 12), Vec3(30, 0, 0), Vec3(-22, 0, -6), Vec3(8, 0, 25)}) {
    const Release release = launched(600, {0, 0, 20}, v);
    expect_arrival(arrival(follow(ground, trees, {}, release)), {750.0 / 600, release.motion.position, v}, 0);
  }
}

// A sphere is in the forest if its centre is.
TEST(Forest, ASphereFallsLikeItsCentre) {
  const Profile ground(level);
  const Ground trees(grown_over({}, 500, 12));
  Laws laws;
  set_model(laws, RockModel::rigid_sphere);
  const Release release = launched(2000, {0, 0, 11}, {5, 0, 0});
  expect_arrival(arrival(follow(ground, trees, laws, release)), {0.25, {0, 0, 11}, {5, 0, 0}}, release.rock.radius);
}

TEST(Forest, ReachesTheTerminalSpeed) {
  const Profile ground(level);
  const Ground trees(grown_over({}, 500, 1e4));
  const Motion end = arrival(follow(ground, trees, {}, launched(250, {0, 0, 500}, {10, 0, 0})));
  EXPECT_LT((end.velocity - Vec3(0, 0, -0.5 * g)).norm(), 1e-9);
}

TEST(Forest, BrakesFromWhereARockFallsIntoIt) {
  const Profile ground(level);
  const Ground trees(grown_over({}, 500, 10));
  const Motion end = arrival(follow(ground, trees, {}, launched(1000, {0, 0, 30}, {6, 0, 0})));
  // 20 m of free fall, then the forest; its border is found to a millimetre.
  const double t_free = std::sqrt(2 * 20 / g);
  const Exact within{0.5, {6 * t_free, 0, 10}, {6, 0, -g * t_free}};
  const double t = within.falls_to(0);
  EXPECT_NEAR(end.time, t_free + t, 2e-4);
  EXPECT_LT((end.velocity - within.velocity(t)).norm(), 2e-3);
  EXPECT_LT((end.position - within.place(t)).norm(), 3e-3);
}

TEST(Forest, DoesNotBrakeARockThatHasRisenOutOfIt) {
  const Profile ground(level);
  const Ground trees(grown_over({}, 500, 10));
  RockLog log(true, true);
  const Release release = launched(1000, {0, 0, 2}, {3, 0, 25});
  const Draws draws(SamplingPlan{}, 0);
  const Laws laws;
  const RockOutcome outcome = follow_rock(Scene<Profile>{ground, trees, {}, laws}, release, draws, log);
  // It leaves at 10 m with the velocity v that remains, and rises by v^2/2g.
  const Exact within{0.5, {0, 0, 2}, {3, 0, 25}};
  double low = 0, high = 1;
  for (int k = 0; k < 100; ++k) (within.place(0.5 * (low + high)).z() < 10 ? low : high) = 0.5 * (low + high);
  const double v = within.velocity(low).z();
  EXPECT_NEAR(outcome.max_bounce, 10 + v * v / (2 * g), 2e-3);
  const auto free =
      std::find_if(log.pieces.begin(), log.pieces.end(), [](const PathPiece& p) { return p.drag.rate == 0; });
  ASSERT_NE(free, log.pieces.end());
  EXPECT_NEAR(free->start_time, low, 1e-4);
  EXPECT_NEAR(free->path.p.z(), 10, 1.1e-3);
  EXPECT_NEAR(free->path.v.x(), within.velocity(low).x(), 1e-3);
}

// A forest on the left half: a rock that passes above it has the same bits as without it.
TEST(Forest, HasNoEffectAboveItsHeight) {
  const Vec2 halves[] = {{-500, 0}, {0, 0}, {500, 0}};
  const Profile ground(halves);
  const std::vector<Material> materials{grown_over({}, 750, 15), material_of({})};
  const Ground trees(materials, std::vector<MaterialId>{{0}, {1}});
  const Ground bare(materials, std::vector<MaterialId>{{1}, {1}});
  const Release release = launched(500, {-40, 0, 40}, {30, 0, 2});
  const Followed with = follow(ground, trees, {}, release), without = follow(ground, bare, {}, release);
  ASSERT_EQ(with.log.rows.size(), without.log.rows.size());
  for (std::size_t k = 0; k < with.log.rows.size(); ++k) {
    EXPECT_EQ(with.log.rows[k].motion.position, without.log.rows[k].motion.position);
    EXPECT_EQ(with.log.rows[k].motion.velocity, without.log.rows[k].motion.velocity);
  }
}

// Between two forests the drag changes where the ground below does.
TEST(Forest, BelongsToTheGroundBelow) {
  const Vec2 halves[] = {{-500, 0}, {0, 0}, {500, 0}};
  const Profile ground(halves);
  const Ground trees(std::vector<Material>{grown_over({}, 100, 90), grown_over({}, 800, 90)},
                     std::vector<MaterialId>{{0}, {1}});
  const Motion end = arrival(follow(ground, trees, {}, launched(1000, {-10, 0, 60}, {12, 0, 0})));
  const Exact first{0.1, {-10, 0, 60}, {12, 0, 0}};
  double low = 0, high = 2;
  for (int k = 0; k < 100; ++k) (first.place(0.5 * (low + high)).x() < 0 ? low : high) = 0.5 * (low + high);
  const Exact second{0.8, first.place(low), first.velocity(low)};
  const double t = second.falls_to(0);
  EXPECT_NEAR(end.time, low + t, 5e-4);
  EXPECT_LT((end.position - second.place(t)).norm(), 5e-3);
  EXPECT_LT((end.velocity - second.velocity(t)).norm(), 2e-3);
}

// A forest material that is assigned nowhere makes the run search for it, and must not change a bit.
TEST(Forest, ElsewhereHasNoEffect) {
  Dice dice(3);
  const TriangleMesh mesh = random_slope(dice, 20, 60, 0.8, 0.8).mesh();
  for (int number = 0; number < 60; ++number) {
    Laws laws;
    set_model(laws, number % 2 == 0 ? RockModel::lumped_mass : RockModel::rigid_sphere);
    laws.sliding = number % 4 < 2 ? SlidingMethod::stepped : SlidingMethod::closed_form;
    const double x = dice.between(10, 30), y = dice.between(10, 50);
    Release release = launched(dice.magnitude(10, 5000), {x, y, *mesh.elevation(x, y) + 3}, dice.in_cube(4));
    const std::vector<Material> both{material_of({}), grown_over({}, 750, 20)};
    const Followed bare = follow(mesh, Ground(material_of({})), laws, release);
    const Followed asked = follow(mesh, Ground(both, MaterialId{0}), laws, release);
    ASSERT_EQ(bare.log.rows.size(), asked.log.rows.size());
    EXPECT_EQ(bare.outcome.max_bounce, asked.outcome.max_bounce);
    for (std::size_t k = 0; k < bare.log.rows.size(); ++k) {
      ASSERT_EQ(bare.log.rows[k].motion.position, asked.log.rows[k].motion.position);
      ASSERT_EQ(bare.log.rows[k].motion.time, asked.log.rows[k].motion.time);
    }
  }
}

TEST(Forest, IsInvariantUnderRotation) {
  Dice dice(4);
  const Shape shape = random_slope(dice, 20, 60, 0.8, 0.8);
  const TriangleMesh mesh = shape.mesh();
  const Ground trees(grown_over({}, 400, 8));
  for (int number = 0; number < 60; ++number) {
    Laws laws;
    set_model(laws, number % 2 == 0 ? RockModel::lumped_mass : RockModel::rigid_sphere);
    const double x = dice.between(10, 30), y = dice.between(10, 50);
    Release release = launched(dice.magnitude(50, 5000), {x, y, *mesh.elevation(x, y) + 5}, dice.in_cube(6));
    const Map3 turn = turn_about(unit_z, dice.between(0, 2 * std::numbers::pi));
    const TriangleMesh turned = shape.moved([&](const Vec3& v) { return turn * v; }).mesh();
    Release turned_release = release;
    turned_release.motion.position = turn * release.motion.position;
    turned_release.motion.velocity = turn * release.motion.velocity;
    const Motion a = arrival(follow(mesh, trees, laws, release)),
                 b = arrival(follow(turned, trees, laws, turned_release));
    EXPECT_LT((turn * a.position - b.position).norm(), 1e-9);
    EXPECT_LT((turn * a.velocity - b.velocity).norm(), 1e-9);
    EXPECT_NEAR(a.time, b.time, 1e-9);
  }
}

// The same terrain as a mesh and as a raster.
TEST(Forest, IsTheSameOnARasterAndOnItsMesh) {
  RasterGrid grid;
  grid.columns = grid.rows = 21;
  grid.dx = grid.dy = 3;
  Dice dice(5);
  for (std::uint32_t k = 0; k < grid.columns * grid.rows; ++k) {
    grid.z.push_back(static_cast<float>(40 - 0.7 * 3 * (k % grid.columns) + dice.between(-1, 1)));
  }
  const RasterSurface raster(grid);
  Shape shape;
  for (std::uint32_t k = 0; k < grid.columns * grid.rows; ++k) {
    shape.vertices.emplace_back(3.0 * (k % grid.columns), 3.0 * (k / grid.columns), grid.z[k]);
  }
  for (std::uint32_t f = 0; f < raster.facet_count(); ++f) {
    TriangleMesh::Corners corners;
    const Triangle triangle = raster.triangle({f});
    for (std::size_t c = 0; c < 3; ++c) {
      const auto column = static_cast<std::uint32_t>(std::lround(triangle[c].x() / 3));
      corners[c] = static_cast<std::uint32_t>(std::lround(triangle[c].y() / 3)) * grid.columns + column;
    }
    shape.triangles.push_back(corners);
  }
  const TriangleMesh mesh = shape.mesh();
  const Ground trees(grown_over({}, 300, 6));
  for (int number = 0; number < 60; ++number) {
    Laws laws;
    set_model(laws, number % 2 == 0 ? RockModel::lumped_mass : RockModel::rigid_sphere);
    const double x = dice.between(3, 20), y = dice.between(10, 50);
    const Release release =
        launched(dice.magnitude(50, 3000), {x, y, *mesh.elevation(x, y) + 4}, dice.in_cube(5) + Vec3(4, 0, 0));
    const Motion a = arrival(follow(mesh, trees, laws, release)), b = arrival(follow(raster, trees, laws, release));
    EXPECT_LT((a.position - b.position).norm(), 1e-9);
    EXPECT_LT((a.velocity - b.velocity).norm(), 1e-9);
  }
}

// The distance of a slide on level ground: v0/k - c/k^2 ln(1 + k v0/c), c = mu g.
TEST(SoftGround, BrakesASlideByTheClosedForm) {
  Material material = material_of({.rn = 0, .rt = 1, .phi = 0.3});
  material.ground_drag = 0.6;
  Laws laws;
  laws.impact = PlainImpact{};
  laws.sliding = SlidingMethod::closed_form;
  const Profile ground(level);
  const Followed path = follow(ground, Ground(material), laws, launched(1000, {0, 0, 0.5}, {10, 0, 0}));
  const double c = g * std::tan(0.3), k = 0.6, v0 = 10, t_fall = std::sqrt(1 / g);
  EXPECT_EQ(path.outcome.reason, EndReason::at_rest);
  EXPECT_NEAR(path.outcome.end.position.x(), v0 * t_fall + v0 / k - c / (k * k) * std::log1p(k * v0 / c), 2e-4);
  EXPECT_NEAR(path.outcome.end.time, t_fall + std::log1p(k * v0 / c) / k, 2e-4);
}

// Down a slope on which friction stops the rock, c = mu g cos - g sin. Almost all of a stepped slide is a glide; it
// moves with the velocity at the end of each step, first order in the timestep.
TEST(SoftGround, BrakesASteppedSlideByTheClosedForm) {
  const double angle = 0.35, mu = 0.5, k = 0.6, v0 = 10;
  const Vec2 slope[] = {{-500, 500 * std::tan(angle)}, {500, -500 * std::tan(angle)}};
  const Profile ground(slope);
  Material material = material_of({.rn = 0, .rt = 1, .phi = std::atan(mu)});
  material.ground_drag = k;
  const Ground soft(material);
  const double c = g * (mu * std::cos(angle) - std::sin(angle)), way = v0 / k - c / (k * k) * std::log1p(k * v0 / c);
  const auto error = [&](double timestep) {
    Laws laws;
    laws.impact = PlainImpact{};
    laws.timestep = timestep;
    laws.stopped_velocity = 1e-3;
    const Release release = launched(1000, {0, 0, 0}, {v0 * std::cos(angle), 0, -v0 * std::sin(angle) - 1e-6});
    RockLog log(true, true);
    const RockOutcome outcome =
        follow_rock(Scene<Profile>{ground, soft, {}, laws}, release, Draws(SamplingPlan{}, 0), log);
    const double steps = std::log1p(k * v0 / c) / k / timestep;
    EXPECT_GT(static_cast<double>(log.glide_steps.size()), 0.9 * steps);
    return outcome.end.position.x() / std::cos(angle) - way;
  };
  EXPECT_NEAR(error(0.01) / error(0.005), 2, 0.05);
  EXPECT_LT(std::abs(error(0.01)), 0.06);
}

// A forest also brakes a sliding lumped mass, but not a sphere whose centre is above it.
TEST(Forest, BrakesSlidingAndRollingBelowItsHeight) {
  const Profile ground(level);
  Laws laws;
  laws.impact = PlainImpact{};
  laws.sliding = SlidingMethod::closed_form;
  const Release release = launched(1000, {0, 0, 0}, {10, 0, -1e-3});
  const Soil soil{.rn = 0, .rt = 1, .phi = 0.3};
  const Followed path = follow(ground, Ground(grown_over(soil, 400, 5)), laws, release);
  const double c = g * std::tan(0.3), k = 0.4;
  EXPECT_NEAR(path.outcome.end.position.x(), 10 / k - c / (k * k) * std::log1p(k * 10 / c), 2e-3);

  set_model(laws, RockModel::rigid_sphere);
  const Release sphere = launched(1000, {0, 0, release.rock.radius}, {10, 0, -1e-3});
  const auto way = [&](double height) {
    return follow(ground, Ground(grown_over(soil, 400, height)), laws, sphere).outcome.end.position.x();
  };
  EXPECT_EQ(way(0.9 * release.rock.radius), way(0.1));
  EXPECT_LT(way(1.1 * release.rock.radius), 0.9 * way(0.1));
}

}  // namespace
}  // namespace talus::trajectory_drag_test
