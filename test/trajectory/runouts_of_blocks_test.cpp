// How far blocks run on rough ground: it must not depend on the timestep, on the cutoff or on the cells of the raster;
// a block of many faces must go as far as a sphere; a section as far as its prism.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>
#include <vector>

#include "support/dice.hpp"
#include "support/meshes.hpp"
#include "support/scenes.hpp"
#include "talus/meshing/rock_shape.hpp"
#include "talus/terrain/profile.hpp"
#include "talus/terrain/raster_surface.hpp"

namespace talus::runouts_of_blocks_test {
namespace {

using namespace testing_tools;

constexpr double g = 9.81;

struct Runout {
  double mean = 0, error = 0;  // [m]
  int left = 0;                // of the rocks, the model
};

class Sum {
 public:
  void add(const RockOutcome& outcome) {
    const double far = outcome.end.position.x() - outcome.start.position.x();
    ++count_;
    sum_ += far;
    squares_ += far * far;
    left_ += outcome.reason == EndReason::left_model;
    EXPECT_NE(outcome.reason, EndReason::lost);
    EXPECT_NE(outcome.reason, EndReason::maximum_steps);
  }
  [[nodiscard]] Runout runout() const {
    const double n = count_, mean = sum_ / n;
    return {mean, std::sqrt((squares_ / n - mean * mean) / n), left_};
  }

 private:
  int count_ = 0, left_ = 0;
  double sum_ = 0, squares_ = 0;
};

/// 35 degrees over 200 m, then level, with waves of 8 to 40 m whose heights are a twentieth of their lengths.
double waves(double x, double y) {
  double sum = 0.7 * std::max(200 - x, 0.0);
  for (const double length : {40.0, 23.0, 13.0, 8.0}) {
    const double wave = 2 * std::numbers::pi / length;
    sum += 0.025 * length * std::sin(wave * x + length) * std::sin(wave * y + 2 * length);
  }
  return sum;
}

RasterSurface wavy_slope(double cell) {
  RasterGrid grid;
  grid.columns = grid.rows = static_cast<std::uint32_t>(600 / cell) + 1;
  grid.dx = grid.dy = cell;
  for (std::uint32_t j = 0; j < grid.rows; ++j) {
    for (std::uint32_t i = 0; i < grid.columns; ++i) grid.z.push_back(static_cast<float>(waves(cell * i, cell * j)));
  }
  return RasterSurface(std::move(grid));
}

Laws laws_of_blocks() {
  Laws laws;
  set_model(laws, RockModel::rigid_sphere);
  laws.gravity = {0, 0, -g};
  return laws;
}

constexpr Soil hard{.rn = 0.3, .rt = 0, .mu = 0.6, .rolling = 0.05};

/// Of rocks of 1 t that are released 4 m above the crest, turned anyhow. `shape`: null for spheres.
Runout runout_of(const RasterSurface& surface, const RockShape* shape, const Laws& laws, const Soil& soil, int rocks) {
  const Ground ground = ground_of(soil);
  const Scene<RasterSurface> scene{surface, ground, {}, laws};
  RockLog log(false);
  Sum sum;
  for (int rock = 0; rock < rocks; ++rock) {
    Dice dice(static_cast<std::uint64_t>(rock) + 1);
    Release release;
    release.rock = sphere_of_mass(1000, 2700);
    release.shape = shape;
    release.orientation = Orientation::uniform(dice.unit(), dice.unit(), dice.unit());
    const double x = dice.between(5, 15), y = dice.between(280, 320);
    release.motion.position = {x, y, waves(x, y) + 4};
    release.motion.velocity = {1, 0, 0};
    const Draws draws(SamplingPlan{}, static_cast<std::uint64_t>(rock));
    log.clear();
    sum.add(follow_rock(scene, release, draws, log));
  }
  return sum.runout();
}

/// In standard errors.
double apart(const Runout& a, const Runout& b) { return (a.mean - b.mean) / std::hypot(a.error, b.error); }

void expect_same(const Runout& a, const Runout& b, const std::string& what) {
  EXPECT_LT(std::abs(apart(a, b)), 3) << what << ": " << a.mean << " +- " << a.error << " m, not " << b.mean << " +- "
                                      << b.error;
}

// TALUS_TEST_EFFORT multiplies the number of rocks.
int rocks_of(int least) {
  const char* wish = std::getenv("TALUS_TEST_EFFORT");
  return wish == nullptr ? least : std::max(1, std::atoi(wish)) * least;
}

const Vec3 equant(1, 0.9, 0.81), flat(1, 0.95, 0.475);

// Steps are taken on the ground only; flat blocks are there longest.
TEST(RunoutsOfBlocks, DoNotDependOnTheTimestep) {
  const RasterSurface surface = wavy_slope(1);
  for (const Vec3& axes : {equant, flat}) {
    const RockShape shape = ellipsoid_shape(axes);
    Runout first;
    for (const double timestep : {0.016, 0.008, 0.004, 0.002, 0.001, 0.0005}) {
      if (axes == flat && timestep < 0.001) continue;
      Laws laws = laws_of_blocks();
      laws.timestep = timestep;
      const Runout runout = runout_of(surface, &shape, laws, hard, rocks_of(100));
      if (timestep == 0.016) first = runout;
      expect_same(runout, first, "timestep " + std::to_string(timestep));
    }
  }
}

TEST(RunoutsOfBlocks, DoNotDependOnTheCutoff) {
  const RasterSurface surface = wavy_slope(1);
  const RockShape shape = ellipsoid_shape(equant);
  const Runout usual = runout_of(surface, &shape, laws_of_blocks(), hard, rocks_of(300));
  for (const double cutoff : {0.8, 0.4, 0.2, 0.05}) {
    Laws laws = laws_of_blocks();
    laws.normal_velocity_cutoff = cutoff;
    const Runout runout = runout_of(surface, &shape, laws, hard, rocks_of(300));
    expect_same(runout, usual, "cutoff " + std::to_string(cutoff));
  }
}

// The same formula of rough ground. A little more rolling friction would be seen.
TEST(RunoutsOfBlocks, DoNotDependOnTheCells) {
  const RockShape shape = ellipsoid_shape(equant);
  const RasterSurface usual = wavy_slope(1);
  const Runout at_one_metre = runout_of(usual, &shape, laws_of_blocks(), hard, rocks_of(300));
  for (const double cell : {2.0, 0.5}) {
    const Runout runout = runout_of(wavy_slope(cell), &shape, laws_of_blocks(), hard, rocks_of(300));
    expect_same(runout, at_one_metre, "cell " + std::to_string(cell));
  }
  Soil other = hard;
  other.rolling = 0.1;
  const Runout runout = runout_of(usual, &shape, laws_of_blocks(), other, rocks_of(300));
  EXPECT_GT(apart(at_one_metre, runout), 4);
}

// A ball of N corners loses energy at each edge over which it turns, a turn over n of them 1/n in all, and n goes with
// the root of N: what it falls short of the sphere halves when N is four times as large, and twice the runout with 4 N
// corners less that with N is the sphere's. (Of a sphere that strikes the ground at any angle: blocks have no grazing.)
TEST(RunoutsOfBlocks, BallsOfManyCornersTendToTheSphere) {
  const RasterSurface surface = wavy_slope(1);
  Soil soft = hard;
  soft.rolling = 0.3;
  Laws laws = laws_of_blocks();
  laws.grazing = 0;
  const Runout sphere = runout_of(surface, nullptr, laws, soft, rocks_of(300));
  std::vector<Runout> balls;
  for (const int corners : {30, 120, 480}) {
    const RockShape ball = ellipsoid_shape({1, 1, 1}, corners);
    balls.push_back(runout_of(surface, &ball, laws, soft, rocks_of(300)));
  }
  EXPECT_GT(apart(balls[1], balls[0]), 3);
  EXPECT_GT(apart(balls[2], balls[1]), 3);
  const Runout limit{2 * balls[2].mean - balls[1].mean, std::hypot(2 * balls[2].error, balls[1].error)};
  expect_same(limit, sphere, "balls");
}

/// A slope of 107 m and level ground, with bumps every 6 m or so.
std::vector<Vec2> bumpy_section() {
  Dice dice(3);
  std::vector<Vec2> section{{-10, 107}};
  while (section.back().x() < 500) {
    const double x = section.back().x() + dice.between(3, 9);
    section.emplace_back(x, 0.7 * std::max(150 - x, 0.0) + dice.between(-0.6, 0.6));
  }
  return section;
}

// Prisms are released as their sections are, and both corners of an edge strike at once. Impulses that have not
// settled, and rolling friction, which carries any difference between the sides, still turn most squares and slabs out
// of the plane. Means of 200 rocks do not show it. Those of 1200 do: slabs then go 1.2 +- 0.4 % farther as prisms.
TEST(RunoutsOfBlocks, OfSectionsAreThoseOfPrisms) {
  const std::vector<Vec2> section = bumpy_section();
  const Profile line(section);
  Dice diagonals(4);
  const double width = 600;
  const TriangleMesh slope = extruded(section, width, 6, diagonals).mesh();
  const Ground ground = ground_of(hard);
  const Laws in_space = laws_of_blocks();
  Laws in_plane = in_space;
  in_plane.in_section = true;
  const int rocks = rocks_of(200);
  struct Outline {
    const char* name;
    std::vector<Vec2> corners;
    double in_plane;  // of the rocks, at least
  };
  for (const auto& [name, outline, least] :
       {Outline{"hexagon", regular_outline(6), 0.95}, Outline{"square", regular_outline(4), 0},
        Outline{"rectangle_1_2", rectangle_outline(0.5), 0}}) {
    const RockShape as_section = section_shape(outline), as_prism = prism_shape(outline);
    Sum of_sections, of_prisms;
    int in_the_plane = 0;
    RockLog log(false);
    for (int rock = 0; rock < rocks; ++rock) {
      Dice dice(static_cast<std::uint64_t>(rock) + 1);
      Release release;
      release.rock = sphere_of_mass(1000, 2700);
      const Orientation turn = Orientation::of_turn({0, dice.between(0, 2 * std::numbers::pi), 0});
      const double x = dice.between(0, 20);
      release.motion.position = {x, 0, *line.elevation(x) + 3};
      release.motion.velocity = {1, 0, 0};
      const Draws draws(SamplingPlan{}, static_cast<std::uint64_t>(rock));
      release.shape = &as_section;
      release.orientation = turn;
      log.clear();
      const RockOutcome one = follow_rock(Scene<Profile>{line, ground, {}, in_plane}, release, draws, log);
      EXPECT_EQ(one.end.position.y(), 0);
      of_sections.add(one);
      release.shape = &as_prism;
      release.orientation = turn * as_prism.as_given;
      release.motion.position.y() = 0.5 * width;
      log.clear();
      const RockOutcome other = follow_rock(Scene<TriangleMesh>{slope, ground, {}, in_space}, release, draws, log);
      of_prisms.add(other);
      in_the_plane += std::abs(other.end.position.y() - 0.5 * width) < 0.01;
    }
    expect_same(of_sections.runout(), of_prisms.runout(), name);
    EXPECT_GE(in_the_plane, least * rocks) << name;
    EXPECT_EQ(of_prisms.runout().left, 0) << name;
  }
}

}  // namespace
}  // namespace talus::runouts_of_blocks_test
