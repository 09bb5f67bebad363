// A sphere that a barrier has stopped still spins on the ground, which drives it against the barrier until friction has
// removed the spin.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "support/scenes.hpp"
#include "talus/barriers/crossing.hpp"
#include "talus/terrain/profile.hpp"

namespace talus::spinning_spheres_test {
namespace {

using namespace testing_tools;

constexpr double g = standard_gravity, radius = 0.5, at = 10;
const Rock rock = sphere_of_diameter(2 * radius, 2700);

/// Ground that rises towards a fence, or is level. The sphere arrives with a speed and a spin.
struct Approach {
  double rise, speed, spin;
  Soil soil{.rn = 0, .rt = 1, .mu = 0.5, .rolling = 0.02};

  [[nodiscard]] double slope() const { return std::atan(rise); }
  [[nodiscard]] Vec3 up() const { return {std::cos(slope()), 0, std::sin(slope())}; }
  [[nodiscard]] Vec3 normal() const { return {-std::sin(slope()), 0, std::cos(slope())}; }
  /// Where the sphere on the ground touches the vertical fence in the middle of the model.
  [[nodiscard]] Vec3 touching() const {
    const double x = at - radius;
    return {x, 0, rise * x + radius / std::cos(slope())};
  }
  [[nodiscard]] Followed follow_to(double rn, double rt) const {
    Barrier fence;
    fence.capacity = std::numeric_limits<double>::infinity();
    fence.restitution = Restitution{rn, rt};
    fence.set_panels(panels_over(std::vector<Vec3>{{at, -50, rise * at}, {at, 50, rise * at}}, 5, 0));
    Laws laws;
    set_model(laws, RockModel::rigid_sphere);
    Release release;
    release.rock = rock;
    release.motion = {touching() - up(), speed * up(), {0, spin, 0}};
    const Profile ground(std::vector<Vec2>{{-40, -40 * rise}, {40, 40 * rise}});
    return follow(ground, ground_of(soil), laws, release, std::vector<Barrier>{fence});
  }
};

double nearest_to_the_fence(const Followed& path) {
  double x = -1e9;
  for (const PathRow& row : path.log.rows) x = std::max(x, row.motion.position.x());
  return x;
}

// It slips in place: friction mu m g and the moment of rolling resistance brake its spin, I dw/dt = -(mu + mu_r) m g r
// with I = 2/5 m r^2.
TEST(SphereAtABarrier, OnLevelGroundStaysUntilItNoLongerSpins) {
  for (const double spin : {10.0, 25.0, 60.0}) {
    for (const double rt : {0.0, 1.0}) {
      const Approach level{0, 5, spin};
      const Followed path = level.follow_to(0, rt);
      EXPECT_EQ(path.outcome.reason, EndReason::at_rest);
      EXPECT_LT((path.outcome.end.position - level.touching()).norm(), 1e-6);
      ASSERT_EQ(path.log.hits.size(), 1U) << "spin " << spin;
      const Motion& hit = path.log.hits[0].motion;
      const double braking = 2.5 * (level.soil.mu + level.soil.rolling) * g;
      const double time = hit.spin.y() * radius / braking;
      // It stops when the remaining slip is below the stopping velocity: within the last step or two.
      EXPECT_NEAR(path.outcome.end.time - hit.time, time, Laws{}.stopped_velocity / braking + 0.02) << "spin " << spin;
    }
  }
}

TEST(SphereAtABarrier, OnASlopeRollsBackWhenItNoLongerSpins) {
  for (const double rise : {0.1, 0.3}) {
    for (const double rn : {0.0, 0.05, 0.2, 0.6}) {
      for (const double spin : {10.0, 60.0}) {
        const Followed path = Approach{rise, 6, spin}.follow_to(rn, 0.5);
        SCOPED_TRACE(::testing::Message() << "rise " << rise << ", rn " << rn << ", spin " << spin);
        EXPECT_EQ(path.outcome.reason, EndReason::left_model);
        EXPECT_LT(path.outcome.end.position.x(), -39.9);
        EXPECT_LT(nearest_to_the_fence(path), at - radius + 1e-6);
        ASSERT_FALSE(path.log.hits.empty());
        EXPECT_LT(path.log.hits.size(), 12U);  // bounces, each at most rn times as fast as the last
        for (std::size_t k = 1; k < path.log.rows.size(); ++k) {
          const auto energy = [&](std::size_t row) {
            return total_energy(path.log.rows[row].motion, rock, {0, 0, -g});
          };
          ASSERT_LE(energy(k), energy(k - 1) + 1e-6 * std::abs(energy(0))) << rows_up_to(path, k);
        }
      }
    }
  }
}

}  // namespace
}  // namespace talus::spinning_spheres_test
