// Every trajectory ends: steps are counted even if they take no time.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "support/meshes.hpp"
#include "support/scenes.hpp"

namespace talus::limits_test {
namespace {

using namespace testing_tools;

/// Between barriers with full restitution, and without a velocity at which rocks stop.
TEST(Limits, EndRocksThatReboundBetweenBarriersForEver) {
  Dice dice(22);
  int at_a_limit = 0;
  for (int k = 0; k < 3200; ++k) {
    const double along = dice.chance(0.4) ? 0 : dice.between(-0.4, 0.4),
                 across = dice.chance(0.4) ? 0 : dice.between(-0.4, 0.4);
    const double bump = dice.chance(.5) ? 0 : dice.between(-3, 3);
    const auto height = [&](double x, double y) {
      return 20 + along * x + across * y + (x == 20 && y == 20 ? bump : 0);
    };
    const TriangleMesh mesh =
        net(
            2, 2,
            [&](std::uint32_t i, std::uint32_t j) { return Vec3(20.0 * i, 20.0 * j, height(20.0 * i, 20.0 * j)); },
            [](std::uint32_t, std::uint32_t) { return true; })
            .mesh();
    const double skew = dice.chance(0.4) ? 0 : dice.between(-12, 12);
    std::vector<Barrier> barriers(dice.chance(0.5) ? 1 : 2);
    barriers[0].set_panels(panels_over(mesh.draped({20 - skew, 0}, {20 + skew, 40}), dice.between(0.2, 3),
                                       dice.chance(0.5) ? 0 : dice.between(-0.6, 0.6)));
    if (barriers.size() > 1)
      barriers[1].set_panels(panels_over(mesh.draped({14, 40}, {14, 0}), dice.between(0.2, 3),
                                         dice.chance(0.5) ? 0 : dice.between(-0.6, 0.6)));
    for (Barrier& barrier : barriers)
      barrier.restitution = Restitution{dice.chance(0.3)   ? 0
                                        : dice.chance(0.3) ? 1
                                                           : dice.between(0, 1),
                                        dice.between(0, 1)};
    Laws laws;
    set_model(laws, dice.chance(0.7) ? RockModel::rigid_sphere : RockModel::lumped_mass);
    laws.sliding = dice.chance(0.5) ? SlidingMethod::stepped : SlidingMethod::closed_form;
    laws.stopped_velocity = 0;
    laws.max_steps = 300;
    laws.max_time = 30;
    laws.timestep = dice.magnitude(1e-4, 10);
    if (dice.chance(.2)) laws.normal_velocity_cutoff = 0;
    if (dice.chance(.3)) laws.normal_velocity_cutoff = 3;
    Soil soil;
    soil.rn = dice.chance(0.5) ? 0 : dice.between(0, 0.5);
    soil.rt = dice.between(0, 1);
    soil.mu = dice.chance(0.3) ? 0 : dice.between(0, 1);
    soil.phi = dice.between(0, 0.5);
    soil.rolling = dice.chance(0.3) ? 0 : dice.between(0, 0.2);
    Release release;
    release.rock = sphere_of_diameter(dice.between(0.2, 1.5), 2700);
    const double x = dice.between(15.5, 19);
    release.motion.position = {x, 20, *mesh.elevation(x, 20) + release.rock.radius * dice.between(1.3, 3)};
    release.motion.velocity = dice.chance(0.2) ? Vec3{} : dice.in_cube(8);
    release.motion.spin = dice.chance(0.3) ? Vec3{} : dice.in_cube(40);

    // (With an endless trajectory this test would never end.)
    const Followed path = follow(mesh, ground_of(soil), laws, release, barriers);
    at_a_limit +=
        path.outcome.reason == EndReason::maximum_steps || path.outcome.reason == EndReason::maximum_time ? 1 : 0;
  }
  EXPECT_GT(at_a_limit, 10);
}

}  // namespace
}  // namespace talus::limits_test
