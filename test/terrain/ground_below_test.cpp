// Whether there is ground below a place, searched from a facet near to it or far away.

#include <gtest/gtest.h>

#include "support/meshes.hpp"
#include "talus/terrain/profile.hpp"
#include "talus/terrain/raster_surface.hpp"

namespace talus::ground_below_test {
namespace {

using namespace testing_tools;

template <class Surface>
void expect_agreement_with_elevations(const Surface& surface, Dice& dice, double low, double high, double top) {
  int over = 0, off_terrain = 0;
  for (int k = 0; k < 20'000; ++k) {
    const Vec3 place(dice.between(low, high), dice.between(low, high), dice.between(-top, top));
    const FacetId near{static_cast<std::uint32_t>(dice.below(surface.facet_count()))};
    const bool expected = surface.elevation(place.x(), place.y(), place.z()).has_value();
    ASSERT_EQ(surface.has_ground_below(place, near), expected) << place << ", facet " << near.index;
    ++(expected ? over : off_terrain);
  }
  EXPECT_GT(over, 1000);
  EXPECT_GT(off_terrain, 1000);
}

TEST(GroundBelow, ExistsWhereThereIsAnElevation) {
  Dice dice(301);
  expect_agreement_with_elevations(random_slope(dice, 12, 20, 0.4, 1.5).mesh(), dice, -3, 23, 9);
  expect_agreement_with_elevations(random_boulder(dice, 2, 8, 0.3).mesh(), dice, -10, 10, 10);
  RasterGrid grid{.columns = 21, .rows = 21};
  for (int k = 0; k < 21 * 21; ++k) grid.z.push_back(static_cast<float>(dice.between(-2, 2)));
  expect_agreement_with_elevations(RasterSurface(grid), dice, -3, 23, 4);
  const std::vector<Vec2> folded{{-9, 4}, {-3, 3}, {-5, 1}, {1, 0}, {1, -4}, {9, -5}};
  expect_agreement_with_elevations(Profile(folded), dice, -12, 12, 6);
}

}  // namespace
}  // namespace talus::ground_below_test
