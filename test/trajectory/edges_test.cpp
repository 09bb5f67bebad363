// Spheres over edges and vertices: they turn about what carries them, for any timestep, and do not fall through what
// they have left.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "support/meshes.hpp"
#include "support/scenes.hpp"
#include "talus/terrain/profile.hpp"
#include "talus/terrain/raster_surface.hpp"

namespace talus::edges_test {
namespace {

using namespace testing_tools;

constexpr double g = standard_gravity;
const Rock rock = sphere_of_diameter(0.9, 2700);

Laws laws_of_a_sphere(double timestep = 0.01) {
  Laws laws;
  set_model(laws, RockModel::rigid_sphere);
  laws.timestep = timestep;
  return laws;
}

/// No bounce, no slip, no rolling resistance.
Soil gear() {
  Soil soil;
  soil.rn = 0;
  soil.rt = 0;
  soil.mu = 1e6;
  soil.rolling = 0;
  return soil;
}

/// Where the sphere is last on the ground before it falls below a height.
const Motion& take_off_of(const Followed& path, double height) {
  std::size_t k = 0;
  while (k + 1 < path.log.rows.size() && path.log.rows[k + 1].motion.position.z() > height) ++k;
  while (k > 0 && path.log.rows[k].state != PathState::projectile) --k;
  return path.log.rows[k].motion;
}

// ---- turning about an edge ----

// Off the edge of a plateau, with v0 there: v^2 = v0^2 + 10/7 g r (1 - cos), and it takes off where v^2 = g r cos, at
// cos = (10 + 7 F) / 17 with F = v0^2 / (g r).
TEST(OverAnEdge, ASphereTakesOffWhereItsWeightNoLongerTurnsIt) {
  const Profile cliff(std::vector<Vec2>{{0, 0}, {10, 0}, {10, -50}, {60, -50}});
  Dice dice(3);
  const TriangleMesh mesh = extruded(std::vector<Vec2>{{0, 0}, {10, 0}, {10, -50}, {60, -50}}, 20, 3, dice).mesh();
  const double r = rock.radius;
  for (const double froude : {0.01, 0.2, 0.6, 0.9}) {
    const double v0 = std::sqrt(froude * g * r), cosine = (10 + 7 * froude) / 17, sine = std::sqrt(1 - cosine * cosine);
    for (const double timestep : {1e-4, 0.01, 0.1, 2.0, 1e6}) {
      const auto expect_parting = [&](const auto& surface, double y) {
        const Motion start{{9.5, y, r}, {v0, 0, 0}, {0, v0 / r, 0}};
        const Followed path = follow(surface, ground_of(gear()), laws_of_a_sphere(timestep), {start, rock});
        const Motion& parts = take_off_of(path, -10);
        EXPECT_NEAR((parts.position.x() - 10) / r, sine, 0.012) << froude << ' ' << timestep;
        EXPECT_NEAR(parts.position.z() / r, cosine, 0.012) << froude << ' ' << timestep;
        EXPECT_NEAR(parts.velocity.squared_norm() / (g * r), cosine, 0.012) << froude << ' ' << timestep;
        EXPECT_NEAR(parts.position.y(), y, 1e-9);
        // Its energy is constant, except for the potential energy of a step.
        EXPECT_NEAR(total_energy(parts, rock, {0, 0, -g}) / total_energy(start, rock, {0, 0, -g}), 1, 1e-9);
      };
      expect_parting(cliff, 0);
      expect_parting(mesh, 9.1);
    }
  }
}

TEST(OverAnEdge, AFastSphereTakesOffAtOnce) {
  const Profile cliff(std::vector<Vec2>{{0, 0}, {10, 0}, {10, -50}, {60, -50}});
  const double v0 = 1.05 * std::sqrt(g * rock.radius);
  for (const double timestep : {0.01, 2.0}) {
    const Motion start{{9.5, 0, rock.radius}, {v0, 0, 0}, {0, v0 / rock.radius, 0}};
    const Followed path = follow(cliff, ground_of(gear()), laws_of_a_sphere(timestep), {start, rock});
    EXPECT_NEAR(take_off_of(path, -10).position.x(), 10, 1e-9);
    EXPECT_NEAR(take_off_of(path, -10).velocity.x(), v0, 1e-9);
  }
}

// From a plane onto a steeper one: 5/7 of gravity along both, and no loss at the edge.
TEST(OverAnEdge, ASphereRollsOnOverTheNextFacet) {
  const double first = 0.2, r = rock.radius;
  for (const double bend : {1e-7, 1e-6, 3e-6, 1e-5, 1e-4, 1e-2, 0.1, 0.3}) {
    const double second = first + bend;
    const Profile slope(
        std::vector<Vec2>{{0, 0}, {10, -10 * std::tan(first)}, {60, -10 * std::tan(first) - 50 * std::tan(second)}});
    for (const double timestep : {1e-3, 0.01, 2.0}) {
      const Vec3 n(std::sin(first), 0, std::cos(first));
      const Vec3 down(std::cos(first), 0, -std::sin(first)), down2(std::cos(second), 0, -std::sin(second));
      const Vec3 edge(10, 0, -10 * std::tan(first));
      const Motion start{edge - 0.1 * down + r * n, Vec3{}};
      Laws laws = laws_of_a_sphere(timestep);
      laws.max_time = 3;
      const Followed path = follow(slope, ground_of(gear()), laws, {start, rock});
      ASSERT_EQ(path.outcome.reason, EndReason::maximum_time) << bend << ' ' << timestep;
      EXPECT_EQ(path.outcome.events, 1) << bend << ' ' << timestep;
      // Over a bend below `same_plane` a leg continues straight.
      const double height = (bend < 1.5e-6 ? bend : 1e-9) * 10;
      EXPECT_NEAR(total_energy(path.outcome.end, rock, {0, 0, -g}), total_energy(start, rock, {0, 0, -g}),
                  rock.mass * g * height)
          << bend << ' ' << timestep;
      // The time of each part: along the first plane, over the edge, along the second plane.
      const double a = 5.0 / 7 * g * std::sin(first), b = 5.0 / 7 * g * std::sin(second);
      const double to_edge = std::sqrt(2 * 0.1 / a), v = a * to_edge;
      const auto speed_at = [&](double angle) {
        return std::sqrt(v * v + 10.0 / 7 * g * r * (std::cos(first) - std::cos(angle)));
      };
      double beyond = 3 - to_edge;
      constexpr int parts = 1000;
      for (int k = 0; k < parts; ++k) beyond -= r * bend / parts / speed_at(first + bend * (k + 0.5) / parts);
      const double way = (path.outcome.end.position - edge).dot(down2);
      EXPECT_NEAR(way / (speed_at(second) * beyond + 0.5 * b * beyond * beyond), 1, 1e-3) << bend << ' ' << timestep;
    }
  }
}

TEST(OverAnEdge, ThePathDoesNotDependOnTheTimestep) {
  Dice dice(8);
  const TriangleMesh mesh = irregular_field(dice, 12, 12, 30, 30, [&](double x, double y) {
                              return -0.3 * x - 0.004 * (y - 15) * (y - 15) - 0.004 * x * x;
                            }).mesh();
  Soil soil = gear();
  soil.mu = 0.6;
  soil.rolling = 0.05;
  for (int k = 0; k < 40; ++k) {
    const double x = dice.between(3, 12), y = dice.between(10, 20);
    std::vector<Vec3> ends;
    for (const double timestep : {1e-3, 0.01, 1.0}) {
      const Motion start{{x, y, *mesh.elevation(x, y) + 1.2 * rock.radius}, Vec3{}};
      Laws laws = laws_of_a_sphere(timestep);
      laws.max_time = 2;
      ends.push_back(follow(mesh, ground_of(soil), laws, {start, rock}).outcome.end.position);
    }
    // One touch of an edge more or less makes a tenth of its radius over a path of some metres.
    EXPECT_LT((ends[1] - ends[0]).norm(), 0.1 * rock.radius) << k;
    EXPECT_LT((ends[2] - ends[0]).norm(), 0.1 * rock.radius) << k;
  }
}

// ---- nothing falls through ----

/// A plateau of 10 m by 10 m, 10 m high, with the corner at (10, 10) lowered so that its facets make this angle. The
/// ground falls away on all sides, and extends further than any rock gets.
Shape plateau(double angle) {
  Shape shape;
  // The edge from (0, 0) to (10, 10) is 5 sqrt(2) m from the corners on either side.
  const double drop = angle * 5 * std::sqrt(2.0);
  shape.vertices = {{0, 0, 10},    {10, 0, 10 - drop}, {10, 10, 10}, {0, 10, 10},
                    {-30, -30, 0}, {40, -30, 0},       {40, 40, 0},  {-30, 40, 0}};
  shape.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 1}, {4, 1, 0}, {5, 6, 2},
                     {5, 2, 1}, {6, 7, 3}, {6, 3, 2}, {7, 4, 0}, {7, 0, 3}};
  return shape;
}

/// Whether a rock's centre has been below the ground.
template <class Surface>
bool has_been_beneath(const Surface& surface, const Followed& path, double reach) {
  if (path.outcome.reason == EndReason::lost) return true;
  return std::any_of(path.log.rows.begin(), path.log.rows.end(), [&](const PathRow& row) {
    const Vec3& p = row.motion.position;
    const auto ground = surface.elevation(p.x(), p.y());
    return ground && p.z() < *ground + 0.5 * reach - 1e-6;
  });
}

Soil random_soft_soil(Dice& dice) {
  Soil soil;
  soil.rn = dice.chance(0.5) ? 0 : dice.between(0, 0.03);
  soil.rt = dice.between(0, 1);
  soil.mu = dice.between(0.05, 1);
  soil.phi = dice.between(0.05, 0.9);
  soil.rolling = dice.chance(0.3) ? 0 : dice.between(0, 0.1);
  return soil;
}

TEST(NothingFallsThrough, AtTheEdgesVerticesAndRimsOfOnePlane) {
  Dice dice(2026);
  int wrong = 0;
  for (int k = 0; k < 2500; ++k) {
    const std::array angles{0.0, 1e-12, 1e-9, 1e-7, 4e-7, 1e-6, 1.4e-6, 3e-6, 1e-5, 4e-5, 1e-4, 1e-2};
    const double angle = angles[static_cast<std::size_t>(dice.between(0, angles.size()))] * (dice.chance(0.3) ? -1 : 1);
    const TriangleMesh mesh = plateau(angle).mesh();
    // A vertex, a place on the edge in the middle, one on the rim.
    const std::array<Vec2, 5> places{Vec2(0, 0), Vec2(10, 10), Vec2(5, 5), Vec2(10, 4), Vec2(2, 10)};
    const auto tiny = [&] {
      return dice.chance(0.3) ? 0.0 : dice.magnitude(1e-13, 1e-6) * (dice.chance(0.5) ? 1 : -1);
    };
    const Vec2 place = places[static_cast<std::size_t>(dice.between(0, 5))] + Vec2(tiny(), tiny());
    Laws laws = laws_of_a_sphere(std::array{1e-3, 0.01, 0.5}[static_cast<std::size_t>(dice.between(0, 3))]);
    laws.max_time = 20;
    Release release;
    release.rock = sphere_of_diameter(dice.magnitude(0.1, 2), 2700);
    release.motion.position = {place.x(), place.y(), 10 + release.rock.radius * (1 + dice.magnitude(1e-9, 1))};
    release.motion.position.z() += std::max(0.0, -8 * angle);  // where the corner rises
    if (dice.chance(0.5))
      release.motion.velocity = Vec3(dice.between(-1, 1), dice.between(-1, 1), 0) * dice.magnitude(1e-6, 3);
    if (dice.chance(0.8)) release.motion.spin = dice.direction() * dice.magnitude(0.01, 20);
    const Soil soil = random_soft_soil(dice);
    const Followed path = follow(mesh, ground_of(soil), laws, release);
    const bool is_lawful =
        !has_been_beneath(mesh, path, release.rock.radius) && path.outcome.reason != EndReason::maximum_steps;
    if (!is_lawful && ++wrong <= 3) {
      ADD_FAILURE() << k << " angle " << angle << ' ' << name(path.outcome.reason)
                    << rows_up_to(path, path.log.rows.size() - 1);
    }
  }
  EXPECT_EQ(wrong, 0);
}

TEST(NothingFallsThrough, InASectionOfOnePlane) {
  Dice dice(2027);
  int wrong = 0;
  for (int k = 0; k < 1500; ++k) {
    const std::array angles{0.0, 1e-12, 1e-9, 4e-7, 1.4e-6, 3e-6, 1e-5, 1e-4, 1e-2};
    const double angle = angles[static_cast<std::size_t>(dice.between(0, angles.size()))] * (dice.chance(0.3) ? -1 : 1);
    const Profile profile(std::vector<Vec2>{{-30, 0}, {0, 10}, {5, 10}, {10, 10 - 5 * angle}, {40, 0}});
    const double x = std::array{0.0, 5.0, 10.0}[static_cast<std::size_t>(dice.between(0, 3))] +
                     (dice.chance(0.3) ? 0.0 : dice.magnitude(1e-13, 1e-6) * (dice.chance(0.5) ? 1 : -1));
    Laws laws = laws_of_a_sphere(std::array{1e-3, 0.01, 0.5}[static_cast<std::size_t>(dice.between(0, 3))]);
    if (dice.chance(0.3)) set_model(laws, RockModel::lumped_mass);
    laws.max_time = 20;
    Release release;
    release.rock = sphere_of_diameter(dice.magnitude(0.1, 2), 2700);
    const double reach = laws.model == RockModel::rigid_sphere ? release.rock.radius : 0;
    release.motion.position = {x, 0, *profile.elevation(x) + reach + dice.magnitude(1e-9, 1)};
    release.motion.position.z() += reach * std::abs(angle);  // clear of rising ground next to it
    if (dice.chance(0.5)) release.motion.velocity = Vec3(dice.between(-1, 1), 0, 0) * dice.magnitude(1e-6, 3);
    if (dice.chance(0.8)) release.motion.spin = Vec3(0, dice.between(-20, 20), 0);
    const Soil soil = random_soft_soil(dice);
    const Followed path = follow(profile, ground_of(soil), laws, release);
    const bool is_lawful = !has_been_beneath(profile, path, reach) && path.outcome.reason != EndReason::maximum_steps;
    if (!is_lawful && ++wrong <= 3) {
      ADD_FAILURE() << k << " angle " << angle << ' ' << name(path.outcome.reason)
                    << rows_up_to(path, path.log.rows.size() - 1);
    }
  }
  EXPECT_EQ(wrong, 0);
}

// ---- planes that a rock has left ----

/// A floor at height 0 with four facets around the vertex (0, 0). The one to the right ends along x = 0: beyond is
/// nothing, or ground that falls away.
TEST(SupportPlanes, AreMetWhereTheyContinue) {
  const Shape shape = net(
      2, 2, [](std::uint32_t i, std::uint32_t j) { return Vec3(5.0 * i - 5, 5.0 * j - 5, 0); },
      [](std::uint32_t, std::uint32_t) { return true; });
  const TriangleMesh mesh = shape.mesh();
  const Profile profile(std::vector<Vec2>{{-5, 0}, {0, 0}, {5, 0}});
  const Vec3 gravity(0, 0, -g);
  for (const double radius : {0.0, 0.5}) {
    const auto contact_of = [&](const auto& surface, const Vec3& place, const Vec3& velocity, double rise) {
      const Vec3 start = place + Vec3(0, 0, radius);
      const auto was_on = surface.ground_below(place - 0.01 * Vec3(velocity.x(), velocity.y(), 0));
      SupportPlanes left;
      left.add({0, 0, 1}, was_on->facet);
      return surface.first_contact({start, velocity + Vec3(0, 0, rise), gravity}, radius, 10, left);
    };
    const auto expect_met = [&](const auto& surface, const Vec3& place, const Vec3& velocity) {
      const auto contact = contact_of(surface, place, velocity, 0);
      ASSERT_TRUE(contact) << radius;
      EXPECT_LT(contact->t, 1e-3);
      EXPECT_EQ(contact->feature, Feature::facet);
    };
    // The plane continues beyond the vertex and beyond the edge.
    expect_met(mesh, {0, 0, 0}, {1, 0.3, 0});
    expect_met(mesh, {0, 0, 0}, {1, 1, 0});
    expect_met(mesh, {0, -2, 0}, {3, 0.01, 0});
    expect_met(profile, {0, 0, 0}, {2, 0, 0});
    // It does not continue beyond its end.
    EXPECT_FALSE(radius == 0 && contact_of(mesh, {5, 1, 0}, {2, 0, 0}, 0));
    EXPECT_FALSE(radius == 0 && contact_of(profile, {5, 0, 0}, {2, 0, 0}, 0));
    // A rock that rises from a plane has left it, and lands on the same facet.
    const auto back = contact_of(mesh, {-2, -2.5, 0}, {0.1, 0, 0}, 1);
    ASSERT_TRUE(back);
    EXPECT_NEAR(back->t, 2 / g, 1e-9);
  }
}

// ---- cutoffs of zero ----

TEST(WithoutACutoff, ARockThatDoesNotBounceStaysOnTheGround) {
  const Profile level(std::vector<Vec2>{{-20, 0}, {60, 0}}), slope(std::vector<Vec2>{{-20, 20}, {40, 0}, {400, 0}});
  const Profile pit(std::vector<Vec2>{{-20, 20}, {0, 0}, {20, 20}});
  Soil soil;
  soil.rolling = 0.1;
  for (const double rn : {0.0, 0.4}) {
    soil.rn = rn;
    for (const RockModel model : {RockModel::lumped_mass, RockModel::rigid_sphere}) {
      for (const bool rotates : {false, true}) {
        Laws laws = laws_of_a_sphere();
        set_model(laws, model, rotates);
        laws.normal_velocity_cutoff = 0;
        for (const Profile* ground : {&level, &slope, &pit}) {
          const Release release{{{-3, 0, *ground->elevation(-3) + 3}, {1, 0, 0}}, rock};
          const Followed path = follow(*ground, ground_of(soil), laws, release);
          EXPECT_EQ(path.outcome.reason, EndReason::at_rest) << rn << ' ' << rotates;
          EXPECT_LT(path.outcome.events, 200) << rn << ' ' << rotates;
        }
      }
    }
  }
}

}  // namespace
}  // namespace talus::edges_test
