// Within the clear way the search for contacts finds none; and the clear way is long enough to be useful.

#include "talus/terrain/clear_way.hpp"

#include <gtest/gtest.h>

#include "support/meshes.hpp"
#include "talus/terrain/raster_surface.hpp"

namespace talus::clear_way_test {
namespace {

using namespace testing_tools;

struct Tried {
  int legs = 0, clear = 0;  // in the middle of a facet; clear up to the facet's sides
};

template <class Surface>
Tried roll_about(const Surface& surface, Dice& dice, double radius) {
  Tried tried;
  for (int trial = 0; trial < 4000; ++trial) {
    const FacetId facet{static_cast<std::uint32_t>(dice.below(surface.facet_count()))};
    const Outline outline = surface.outline(facet);
    const Triangle corner = surface.triangle(facet);
    Vec3 share(dice.unit(), dice.unit(), dice.unit());
    share /= share.sum();
    const Vec3& n = outline.normal;
    const Vec3 centre = share[0] * corner[0] + share[1] * corner[1] + share[2] * corner[2] + radius * n;
    double room = 1e9;
    for (const OutlineEdge& edge : outline.edges) room = std::min(room, (centre - edge.point).dot(edge.inward));
    double nearest = 1e9, way = room;
    surface.supports(centre, radius, room, [&](const Vec3&, const Vec3&, double distance, FacetId other) {
      nearest = std::min(nearest, distance);
      way = std::min(way, clear_way(n, centre, radius, surface.outline(other), distance));
    });
    if (nearest < radius - 1e-9 || !(way > 0)) continue;  // no room for the sphere
    ++tried.legs;
    tried.clear += way > 0.9 * room ? 1 : 0;
    for (int k = 0; k < 20; ++k) {
      const Vec3 direction = tangential(dice.direction(), n).normalized();
      const Parabola leg{centre, way * direction, Vec3{}};
      const auto contact = surface.first_contact_on_leg(leg, radius, 1, SupportPlanes(n));
      EXPECT_FALSE(contact) << "trial " << trial << ", way " << way << ", contact at " << contact->t << ", feature "
                            << static_cast<int>(contact->feature);
    }
  }
  return tried;
}

void expect_worth_having(const Tried& tried) {
  EXPECT_GT(tried.legs, 500);
  EXPECT_GT(tried.clear, tried.legs / 10);
}

TEST(ClearWay, HasNoContactsOnAMesh) {
  Dice dice(311);
  for (const double relief : {0.0, 1e-8, 1e-4, 0.05, 0.5}) {
    SCOPED_TRACE(relief);
    expect_worth_having(roll_about(random_slope(dice, 12, 40, 0.5, relief).mesh(), dice, dice.between(0.2, 1.5)));
  }
  expect_worth_having(roll_about(random_boulder(dice, 2, 20, 0.05).mesh(), dice, 0.4));
}

TEST(ClearWay, HasNoContactsOnARaster) {
  Dice dice(312);
  for (const double relief : {0.0, 1e-3, 0.1, 1.0}) {
    SCOPED_TRACE(relief);
    RasterGrid grid{.columns = 15, .rows = 15, .dx = 4, .dy = 5};
    for (int k = 0; k < 15 * 15; ++k) {
      grid.z.push_back(static_cast<float>(0.5 * (k % 15) + dice.between(-relief, relief)));
    }
    expect_worth_having(roll_about(RasterSurface(grid), dice, dice.between(0.2, 1.5)));
  }
}

}  // namespace
}  // namespace talus::clear_way_test
