// Rocks that come into a pit of a single node, where facets rise on all sides.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/dice.hpp"
#include "support/scenes.hpp"
#include "talus/terrain/raster_surface.hpp"

namespace talus::pits_test {
namespace {

using namespace testing_tools;

constexpr double node_x = 23.5, node_y = 102.5;

/// A slope of 7 x 7 nodes with one that is lower.
RasterSurface slope_with_a_pit(float depth) {
  RasterGrid grid;
  grid.columns = grid.rows = 7;
  grid.dx = grid.dy = 1;
  grid.x0 = 20.5;
  grid.y0 = 99.5;
  for (std::uint32_t j = 0; j < grid.rows; ++j) {
    for (std::uint32_t i = 0; i < grid.columns; ++i) {
      grid.z.push_back(i == 3 && j == 3 ? depth : -10 - 0.5F * static_cast<float>(i));
    }
  }
  return RasterSurface(std::move(grid));
}

Laws laws_of_a_mass() {
  Laws laws;
  set_model(laws, RockModel::lumped_mass);
  laws.sliding = SlidingMethod::closed_form;
  laws.grazing = std::sin(5 * std::numbers::pi / 180);
  return laws;
}

// It struck two facets within a hundredth of a millimetre, and the line in which their planes meet is under a third.
TEST(Pit, HoldsARockThatIsCaughtBetweenTwoOfItsFacets) {
  const Soil soil{.rn = 0.4844796241114615, .rt = 0.9361728801297273, .phi = 60 * std::numbers::pi / 180};
  Release release;
  release.rock = sphere_of_mass(1547.0280135987186, 2700);
  release.motion.position = {23.66246004106836, 103.43578592639743, 18.1833611621229};
  const float depth = -15.166F;
  const Followed path = follow(slope_with_a_pit(depth), ground_of(soil), laws_of_a_mass(), release);
  EXPECT_EQ(path.outcome.reason, EndReason::at_rest) << rows_up_to(path, path.log.rows.size() - 1);
  EXPECT_LT((path.outcome.end.position - Vec3(node_x, node_y, depth)).norm(), 1e-5);
}

TEST(Pit, LosesNoRock) {
  Dice dice(7);
  int rests = 0;
  for (int k = 0; k < 3000; ++k) {
    const RasterSurface surface = slope_with_a_pit(static_cast<float>(dice.between(-20, -12)));
    const Soil soil{.rn = dice.between(0.1, 0.7), .rt = dice.between(0.3, 1), .phi = dice.between(0.2, 1.1)};
    Release release;
    release.rock = sphere_of_mass(1000, 2700);
    release.motion.position = {node_x + dice.between(-0.9, 0.9), node_y + dice.between(-0.9, 0.9),
                               dice.between(-8, 20)};
    const Followed path = follow(surface, ground_of(soil), laws_of_a_mass(), release);
    ASSERT_NE(path.outcome.reason, EndReason::lost) << k << rows_up_to(path, path.log.rows.size() - 1);
    rests += path.outcome.reason == EndReason::at_rest ? 1 : 0;
  }
  EXPECT_GT(rests, 1500);
}

}  // namespace
}  // namespace talus::pits_test
