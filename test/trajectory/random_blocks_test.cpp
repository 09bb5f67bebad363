// For any slope and any block: energy never rises, nobody is lost, every trajectory ends.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "support/dice.hpp"
#include "support/meshes.hpp"
#include "support/scenes.hpp"
#include "talus/meshing/rock_shape.hpp"
#include "talus/terrain/raster_surface.hpp"
#include "talus/trajectory/rock_run.hpp"

namespace talus::random_blocks_test {
namespace {

using namespace testing_tools;

constexpr double g = 9.81, size = 60;  // of the terrain [m]

/// The largest rise of a block's energy from any moment to a later one, over its weight [m].
struct EnergyLedger {
  Rock rock;
  double least = std::numeric_limits<double>::infinity(), gain = 0;

  void see(const Motion& motion) {
    const double energy = kinetic_energy(motion, rock) / (rock.mass * g) + motion.position.z();
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

std::vector<RockShape> blocks() {
  std::vector<RockShape> all{regular_shape(RegularSolid::tetrahedron),
                             regular_shape(RegularSolid::cube),
                             regular_shape(RegularSolid::octahedron),
                             box_shape({1, 0.9, 0.4}),
                             box_shape({1, 0.5, 0.4}),
                             ellipsoid_shape({1, 0.9, 0.81}),
                             ellipsoid_shape({1, 0.95, 0.475}),
                             ellipsoid_shape({1, 0.55, 0.495}),
                             prism_shape(regular_outline(5)),
                             icosphere_shape(RegularSolid::icosahedron)};
  for (const RockShape& ball : irregular_balls(12)) all.push_back(ball);
  return all;
}

// `make soak` multiplies the number of rocks.
int effort_of_blocks() {
  const char* wish = std::getenv("TALUS_TEST_EFFORT");
  return wish == nullptr ? 1 : std::max(1, std::atoi(wish));
}

RasterSurface raster_of(Dice& dice, double grade, double relief) {
  RasterGrid grid;
  grid.columns = grid.rows = 41;
  grid.dx = grid.dy = 1.5;
  for (std::uint32_t j = 0; j < grid.rows; ++j) {
    for (std::uint32_t i = 0; i < grid.columns; ++i)
      grid.z.push_back(static_cast<float>(-grade * 1.5 * i + dice.between(-relief, relief)));
  }
  return RasterSurface(std::move(grid));
}

template <class Surface>
void follow_blocks(Dice& dice, const Surface& surface, const std::vector<RockShape>& shapes, const std::string& who) {
  for (int number = 0; number < 20; ++number) {
    const Ground ground = ground_of({.rn = dice.chance(0.1) ? 0 : dice.between(0, 0.67),
                                     .rt = 0.8,
                                     .mu = dice.between(0.1, 1.5),
                                     .rolling = dice.chance(0.3) ? 0 : dice.between(0, 0.3),
                                     .roughness = dice.chance(0.5) ? 0 : dice.between(0, 0.2)});
    Laws laws;
    set_model(laws, RockModel::rigid_sphere);
    laws.gravity = {0, 0, -g};
    if (dice.chance(0.5)) laws.roughness = RoughnessLaw::tilts;
    laws.timestep = dice.chance(0.5) ? 0.01 : dice.magnitude(0.001, 0.02);
    laws.normal_velocity_cutoff = dice.chance(0.5) ? 0.1 : dice.magnitude(0.02, 1);
    Release release;
    release.rock = sphere_of_diameter(dice.magnitude(0.2, 3), 2700);
    release.shape = &shapes[dice.below(shapes.size())];
    release.orientation = Orientation::uniform(dice.unit(), dice.unit(), dice.unit());
    const double x = dice.between(8, 25), y = dice.between(10, 50);
    const double reach = body_of(*release.shape, release.rock).reach;
    double highest = -1e9;
    for (const double dx : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
      for (const double dy : {-1.0, -0.5, 0.0, 0.5, 1.0})
        highest = std::max(highest, *surface.elevation(x + dx * reach, y + dy * reach));
    }
    release.motion.position = {x, y, highest + 1.5 * reach + dice.between(0, 6)};
    release.motion.velocity = dice.between(0, 8) * dice.direction();
    release.motion.spin = dice.between(0, 15) * dice.direction();
    EnergyLedger ledger{release.rock};
    const Draws draws(SamplingPlan{}, static_cast<std::uint64_t>(number));
    RockRun<Surface, EnergyLedger> run({surface, ground, {}, laws}, release, draws, ledger);
    const RockOutcome outcome = run.follow();
    const Vec3& end = outcome.end.position;
    EXPECT_NE(outcome.reason, EndReason::lost) << who << " rock " << number << end;
    EXPECT_NE(outcome.reason, EndReason::maximum_steps) << who << " rock " << number << end;
    EXPECT_NE(outcome.reason, EndReason::maximum_time) << who << " rock " << number << end;
    EXPECT_LT(ledger.gain, 1e-9) << who << " rock " << number << end;
  }
}

TEST(RandomBlocks, LoseEnergyOnly) {
  const std::vector<RockShape> shapes = blocks();
  for (int slope = 0; slope < 50 * effort_of_blocks(); ++slope) {
    Dice dice(static_cast<std::uint64_t>(slope) + 1);
    const double grade = dice.between(0, 1), relief = dice.magnitude(0.01, 1);
    const std::string number = std::to_string(slope);
    follow_blocks(dice, random_slope(dice, 16, size, grade, relief).mesh(), shapes, "mesh " + number);
    follow_blocks(dice, raster_of(dice, grade, relief), shapes, "raster " + number);
  }
}

}  // namespace
}  // namespace talus::random_blocks_test
