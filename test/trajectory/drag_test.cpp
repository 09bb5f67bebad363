// Rocks in forests and on soft ground: against the closed form, at the forest's borders, and what must be true of all.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "support/meshes.hpp"
#include "support/scenes.hpp"
#include "talus/flight/drag.hpp"
#include "talus/flight/touch.hpp"
#include "talus/terrain/profile.hpp"
#include "talus/terrain/raster_surface.hpp"

namespace talus {
namespace {

using namespace testing_tools;

constexpr double g = standard_gravity;

Material grown_over(const Soil& soil, double drag, double height) {
  Material material = material_of(soil);
  material.forest_drag = drag;
  material.forest_height = height;
  return material;
}

const Vec2 level[] = {{-500, 0}, {500, 0}};

Release launched(double mass, const Vec3& from, const Vec3& velocity) {
  Release release;
  release.rock = sphere_of_mass(mass, 2700);
  release.motion.position = from;
  release.motion.velocity = velocity;
  return release;
}

// The first arrival on the ground.
Motion arrival(const Followed& path) {
  for (const PathRow& row : path.log.rows) {
    if (row.state == PathState::impact) return row.motion;
  }
  ADD_FAILURE() << "it never arrives";
  return {};
}

// Linear drag's closed form, and when it falls to a height.
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
  // Between its ends a piece runs up to a millimetre low, so that a rock arrives that much early.
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
    const Release release = launched(mass, {0, 0, 29}, Vec3::Zero());
    expect_arrival(arrival(follow(ground, trees, {}, release)), {500 / mass, release.motion.position, Vec3::Zero()}, 0);
  }
}

// Pebbles sink at their terminal speed; to a thousandth, they are then let sink.
TEST(Forest, PebblesSinkInIt) {
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

// The centre of a sphere is what the height is asked of, and what falls.
TEST(Forest, ASphereFallsAsItsCentreDoes) {
  const Profile ground(level);
  const Ground trees(grown_over({}, 500, 12));
  Laws laws;
  laws.model = RockModel::rigid_sphere;
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
  // 20 m of free fall, then the forest; where it comes in is found to a millimetre.
  const double t_free = std::sqrt(2 * 20 / g);
  const Exact within{0.5, {6 * t_free, 0, 10}, {6, 0, -g * t_free}};
  const double t = within.falls_to(0);
  EXPECT_NEAR(end.time, t_free + t, 2e-4);
  EXPECT_LT((end.velocity - within.velocity(t)).norm(), 2e-3);
  EXPECT_LT((end.position - within.place(t)).norm(), 3e-3);
}

TEST(Forest, LeavesARockAloneThatRisesOutOfIt) {
  const Profile ground(level);
  const Ground trees(grown_over({}, 500, 10));
  RockLog log(true, true);
  const Release release = launched(1000, {0, 0, 2}, {3, 0, 25});
  const Draws draws(SamplingPlan{}, 0);
  const Laws laws;
  const RockOutcome outcome = follow_rock(Scene<Profile>{ground, trees, {}, laws}, release, draws, log);
  // Leaves at 10 m with what drag has left, and rises by v^2/2g.
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

// A forest on the left half: a rock that passes above it is not braked, not even by a bit.
TEST(Forest, DoesNothingAboveItsHeight) {
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

// From one side of a border between two forests to the other the drag changes where the ground below does.
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

// A forest that grows nowhere makes the run ask for it, and must change no bit.
TEST(Forest, ElsewhereChangesNothing) {
  Dice dice(3);
  const TriangleMesh mesh = random_slope(dice, 20, 60, 0.8, 0.8).mesh();
  for (int number = 0; number < 60; ++number) {
    Laws laws;
    laws.model = number % 2 == 0 ? RockModel::lumped_mass : RockModel::rigid_sphere;
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

TEST(Forest, TurnsWithTheModel) {
  Dice dice(4);
  const Shape shape = random_slope(dice, 20, 60, 0.8, 0.8);
  const TriangleMesh mesh = shape.mesh();
  const Ground trees(grown_over({}, 400, 8));
  for (int number = 0; number < 60; ++number) {
    Laws laws;
    laws.model = number % 2 == 0 ? RockModel::lumped_mass : RockModel::rigid_sphere;
    const double x = dice.between(10, 30), y = dice.between(10, 50);
    Release release = launched(dice.magnitude(50, 5000), {x, y, *mesh.elevation(x, y) + 5}, dice.in_cube(6));
    const Mat3 turn = Eigen::AngleAxisd(dice.between(0, 2 * std::numbers::pi), Vec3::UnitZ()).toRotationMatrix();
    const TriangleMesh turned = shape.moved([&](const Vec3& v) { return Vec3(turn * v); }).mesh();
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
    laws.model = number % 2 == 0 ? RockModel::lumped_mass : RockModel::rigid_sphere;
    const double x = dice.between(3, 20), y = dice.between(10, 50);
    const Release release =
        launched(dice.magnitude(50, 3000), {x, y, *mesh.elevation(x, y) + 4}, dice.in_cube(5) + Vec3(4, 0, 0));
    const Motion a = arrival(follow(mesh, trees, laws, release)), b = arrival(follow(raster, trees, laws, release));
    EXPECT_LT((a.position - b.position).norm(), 1e-9);
    EXPECT_LT((a.velocity - b.velocity).norm(), 1e-9);
  }
}

// ---- all of it together, on rough slopes ----

// A rough slope that runs out on a plain where every rock stops.
Shape slope_and_plain(Dice& dice) {
  return irregular_field(dice, 40, 12, 400, 60,
                         [&](double x, double) { return std::max(0.0, 70 - 0.7 * x) + dice.between(-0.4, 0.4); });
}

std::vector<double> runouts(const TriangleMesh& mesh, const Ground& ground, RockModel model) {
  std::vector<double> list;
  Dice dice(6);
  for (std::uint64_t number = 0; number < 150; ++number) {
    const double x = dice.between(3, 8), y = dice.between(10, 50);
    const Release release =
        launched(dice.magnitude(100, 3000), {x, y, *mesh.elevation(x, y) + 3}, {dice.between(0, 4), 0, 0});
    Laws laws;
    laws.model = model;
    const RockOutcome outcome = follow(mesh, ground, laws, release, {}, number).outcome;
    list.push_back((outcome.end.position - outcome.start.position).head<2>().norm());
  }
  std::sort(list.begin(), list.end());
  return list;
}

TEST(Forest, StopsRocksEarlierInEveryPercentile) {
  Dice dice(7);
  const TriangleMesh mesh = slope_and_plain(dice).mesh();
  const Soil soil{.rn = 0.35, .rt = 0.85, .phi = 0.5, .rolling = 0.3, .roughness = 0.05};
  for (const RockModel model : {RockModel::lumped_mass, RockModel::rigid_sphere}) {
    std::vector<std::vector<double>> by_density;
    for (const double drag : {0.0, 250.0, 500.0, 750.0}) {
      by_density.push_back(runouts(mesh, Ground(grown_over(soil, drag, 15)), model));
    }
    for (std::size_t k = 1; k < by_density.size(); ++k) {
      for (std::size_t percent = 5; percent < 100; percent += 5) {
        const std::size_t at = percent * by_density[k].size() / 100;
        EXPECT_LT(by_density[k][at], by_density[k - 1][at]) << k << ' ' << percent << " %";
      }
    }
  }
}

TEST(SoftGround, StopsRocksEarlier) {
  Dice dice(8);
  const TriangleMesh mesh = slope_and_plain(dice).mesh();
  Material material = material_of({.rn = 0.2, .rt = 0.85, .phi = 0.45, .rolling = 0.2});
  for (const RockModel model : {RockModel::lumped_mass, RockModel::rigid_sphere}) {
    material.ground_drag = 0;
    const auto hard = runouts(mesh, Ground(material), model);
    material.ground_drag = 0.9;
    const auto soft = runouts(mesh, Ground(material), model);
    for (const std::size_t percent : {25U, 50U, 75U, 95U}) {
      const std::size_t at = percent * hard.size() / 100;
      EXPECT_LT(soft[at], hard[at]) << percent << " %";
    }
  }
}

// Slid onto the level from a standing start: v0/k - c/k^2 ln(1 + k v0/c), c = mu g.
TEST(SoftGround, BrakesASlideAsTheClosedFormSays) {
  Material material = material_of({.rn = 0, .rt = 1, .phi = 0.3});
  material.ground_drag = 0.6;
  Laws laws;
  laws.rotation = false;
  laws.sliding = SlidingMethod::closed_form;
  const Profile ground(level);
  const Followed path = follow(ground, Ground(material), laws, launched(1000, {0, 0, 0.5}, {10, 0, 0}));
  const double c = g * std::tan(0.3), k = 0.6, v0 = 10, t_fall = std::sqrt(1 / g);
  EXPECT_EQ(path.outcome.reason, EndReason::at_rest);
  EXPECT_NEAR(path.outcome.end.position.x(), v0 * t_fall + v0 / k - c / (k * k) * std::log1p(k * v0 / c), 2e-4);
  EXPECT_NEAR(path.outcome.end.time, t_fall + std::log1p(k * v0 / c) / k, 2e-4);
}

// A lumped mass that slides among trees is braked by them as well; a sphere higher than they are is not.
TEST(Forest, BrakesWhatSlidesOrRollsBelowItsHeight) {
  const Profile ground(level);
  Laws laws;
  laws.rotation = false;
  laws.sliding = SlidingMethod::closed_form;
  const Release release = launched(1000, {0, 0, 0}, {10, 0, -1e-3});
  const Soil soil{.rn = 0, .rt = 1, .phi = 0.3};
  const Followed path = follow(ground, Ground(grown_over(soil, 400, 5)), laws, release);
  const double c = g * std::tan(0.3), k = 0.4;
  EXPECT_NEAR(path.outcome.end.position.x(), 10 / k - c / (k * k) * std::log1p(k * 10 / c), 2e-3);

  laws.model = RockModel::rigid_sphere;
  const Release sphere = launched(1000, {0, 0, release.rock.radius}, {10, 0, -1e-3});
  const auto way = [&](double height) {
    return follow(ground, Ground(grown_over(soil, 400, height)), laws, sphere).outcome.end.position.x();
  };
  EXPECT_EQ(way(0.9 * release.rock.radius), way(0.1));
  EXPECT_LT(way(1.1 * release.rock.radius), 0.9 * way(0.1));
}

// Energy never grows, time never runs back, nobody is lost, in forests of any kind, with barriers in the way; and the
// pieces of a path join.
TEST(Forest, EveryPathIsSound) {
  Dice dice(9);
  std::size_t dragged = 0, hits = 0;
  for (int slope = 0; slope < 6; ++slope) {
    const TriangleMesh mesh = random_slope(dice, 20, 60, dice.between(0.3, 1), dice.between(0.2, 1)).mesh();
    std::vector<MaterialId> of_facet;
    for (std::size_t k = 0; k < mesh.facet_count(); ++k) of_facet.push_back({dice.chance(0.6) ? 1U : 0U});
    std::vector<Barrier> barriers(2);
    barriers[0].capacity = 40e3;
    barriers[0].restitution = Restitution{0.4, 0.8};
    barriers[0].set_panels(panels_over(mesh.draped({40, 0}, {40, 60}), 1.5, 0));
    barriers[1].is_collector = true;
    barriers[1].set_panels(panels_over(mesh.draped({30, 0}, {30, 60}), 4, 0));
    for (std::uint64_t number = 0; number < 150; ++number) {
      Laws laws;
      laws.model = dice.chance(0.5) ? RockModel::lumped_mass : RockModel::rigid_sphere;
      laws.rotation = dice.chance(0.5);
      laws.sliding = dice.chance(0.5) ? SlidingMethod::stepped : SlidingMethod::closed_form;
      const Soil soil{dice.between(0, 0.8), dice.between(0.1, 1), dice.between(0.1, 0.8), dice.between(0.1, 0.8), 0.1};
      Material open = material_of(soil), wood = grown_over(soil, dice.magnitude(10, 5000), dice.between(0.3, 20));
      wood.ground_drag = dice.chance(0.5) ? dice.magnitude(0.01, 30) : 0;
      const Ground ground(std::vector<Material>{open, wood}, of_facet);
      const double x = dice.between(5, 30), y = dice.between(10, 50);
      const Release release =
          launched(dice.magnitude(1, 1e4), {x, y, *mesh.elevation(x, y) + dice.between(1.5, 12)}, dice.in_cube(10));
      RockLog log(true, true);
      const Draws draws(SamplingPlan{}, number);
      const RockOutcome outcome = follow_rock(Scene<TriangleMesh>{mesh, ground, barriers, laws}, release, draws, log);
      const std::string who = "slope " + std::to_string(slope) + " rock " + std::to_string(number);
      ASSERT_NE(outcome.reason, EndReason::lost) << who;
      const double scale = 1e-10 * release.rock.mass * g * 100, slack = 64 * contact_slack * release.rock.mass * g;
      for (std::size_t k = 1; k < log.rows.size(); ++k) {
        const Motion &before = log.rows[k - 1].motion, &after = log.rows[k].motion;
        ASSERT_TRUE(is_finite(after)) << who;
        ASSERT_GE(after.time, before.time) << who;
        ASSERT_LE(total_energy(after, release.rock, laws.gravity),
                  total_energy(before, release.rock, laws.gravity) + scale + slack)
            << who << " row " << k;
      }
      const std::vector<PathPiece> pieces = every_piece(log);
      for (std::size_t k = 0; k < pieces.size(); ++k) {
        const PathPiece& piece = pieces[k];
        if (piece.drag.rate > 0) ++dragged;
        const bool is_last = k + 1 == pieces.size();
        const Motion& next = outcome.end;
        const Vec3 begins = is_last ? next.position : pieces[k + 1].path.p;
        // (A sphere that has sunk in a little is lifted onto the ground.)
        ASSERT_LT((piece.path.at(piece.duration) - begins).norm(), piece.on_ground ? 1e-4 : 1e-9)
            << who << " piece " << k;
        ASSERT_NEAR(piece.time(piece.duration), is_last ? next.time : pieces[k + 1].start_time, 1e-9) << who;
      }
      // Each barrier is met once where it is met; but what it throws back may come again in the same moment, of a step
      // that ends downhill, and stays there then.
      for (std::size_t k = 1; k < log.hits.size(); ++k) {
        const bool again = log.hits[k].barrier == log.hits[k - 1].barrier;
        const bool leans = std::abs(log.hits[k].motion.velocity.x()) < 1e-3 ||  // on the barrier, which runs along y
                           log.hits[k].outcome == BarrierOutcome::stopped;
        ASSERT_FALSE(again && !leans && log.hits[k].motion.time - log.hits[k - 1].motion.time < 1e-7) << who;
      }
      hits += log.hits.size();
    }
  }
  EXPECT_GT(dragged, 5000U);
  EXPECT_GT(hits, 300U);
}

TEST(Forest, ThePathIsTheSameEveryTime) {
  Dice dice(10);
  const TriangleMesh mesh = random_slope(dice, 20, 60, 0.8, 0.8).mesh();
  const Ground trees(grown_over({.roughness = 0.1}, 400, 8));
  for (std::uint64_t number = 0; number < 20; ++number) {
    const double x = dice.between(10, 30), y = dice.between(10, 50);
    const Release release = launched(700, {x, y, *mesh.elevation(x, y) + 5}, dice.in_cube(6));
    const Followed once = follow(mesh, trees, {}, release, {}, number),
                   again = follow(mesh, trees, {}, release, {}, number);
    ASSERT_EQ(once.log.rows.size(), again.log.rows.size());
    EXPECT_EQ(once.outcome.end.position, again.outcome.end.position);
    EXPECT_EQ(once.outcome.end.time, again.outcome.end.time);
  }
}

}  // namespace
}  // namespace talus
