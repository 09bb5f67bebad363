// Rocks on rough ground: where they meet bumps, which faces they strike, and what must not depend on the facets.

#include "talus/ground/rough_ground.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "sampling/goodness_of_fit.hpp"
#include "support/scenes.hpp"
#include "talus/terrain/profile.hpp"

namespace talus::trajectory_rough_ground_test {
namespace {

using namespace testing_tools;

/// A slope down to the right, as a section of this many segments.
Profile slope(double angle, int segments, double length = 4000) {
  std::vector<Vec2> section;
  for (int k = 0; k <= segments; ++k) {
    const double x = length * k / segments;
    section.emplace_back(x, -std::tan(angle) * x);
  }
  return Profile(section);
}

/// A rock that slides or rolls down a slope from x = 10.
Release along(double angle, double speed, const Laws& laws, double radius = 0.4) {
  Release release;
  release.rock = sphere_of_diameter(2 * radius, 2700);
  const Vec3 n(std::sin(angle), 0, std::cos(angle)), down(std::cos(angle), 0, -std::sin(angle));
  const double reach = laws.model == RockModel::rigid_sphere ? radius : 0;
  release.motion.position = Vec3(10, 0, -10 * std::tan(angle)) + (reach + 1e-6) * n;
  release.motion.velocity = speed * down - 0.02 * n;
  if (reach > 0) release.motion.spin = Vec3(0, speed / radius, 0);
  return release;
}

struct Kind {
  const char* name;
  RockModel model;
  SlidingMethod sliding;
};
constexpr Kind kinds[] = {{"stepped", RockModel::lumped_mass, SlidingMethod::stepped},
                          {"closed form", RockModel::lumped_mass, SlidingMethod::closed_form},
                          {"sphere", RockModel::rigid_sphere, SlidingMethod::stepped}};

Laws laws_of(const Kind& kind) {
  Laws laws;
  set_model(laws, kind.model);
  laws.sliding = kind.sliding;
  laws.in_section = true;
  laws.max_time = 15;
  return laws;
}

/// The way along the ground from where a rock comes to it to its first bump; zero if it meets none. The release has an
/// impact of its own, which leaves the rock on the ground.
double way_to_first_bump(const Followed& path) {
  const auto& rows = path.log.rows;
  for (std::size_t k = 1; k + 1 < rows.size(); ++k) {
    if (rows[k].state == PathState::impact && rows[k - 1].state != PathState::impact &&
        rows[k - 1].state != PathState::projectile) {
      return (rows[k].motion.position - rows[k - 1].motion.position).norm();
    }
  }
  return 0;
}

// Rn = 0 on gentle faces: the first contact of the release leaves the rock on the ground, from where the way to the
// first bump is exponential, whatever the law of motion.
TEST(RocksOnRoughGround, TheWayToTheFirstBumpIsExponential) {
  constexpr double spacing = 6, angle = 0.6;
  const Profile ground = slope(angle, 1);
  for (const Kind& kind : kinds) {
    const Laws laws = laws_of(kind);
    std::vector<double> ways;
    for (std::uint64_t rock = 0; rock < 4000; ++rock) {
      const Followed path = follow(
          ground,
          ground_of(
              {.rn = 0, .rt = 1, .phi = 0.55, .mu = 0.6, .rolling = 0.6, .roughness = 1e-4, .bump_spacing = spacing}),
          laws, along(angle, 5, laws), {}, rock);
      if (const double way = way_to_first_bump(path); way > 0) ways.push_back(way);
    }
    ASSERT_GT(ways.size(), 3990U) << kind.name;
    const double distance = kolmogorov_distance(ways, [](double way) { return 1 - std::exp(-way / spacing); });
    EXPECT_GT(kolmogorov_probability(distance, ways.size()), 0.01) << kind.name;
    // A spacing that is wrong by a tenth is seen.
    const double wrong = kolmogorov_distance(ways, [](double way) { return 1 - std::exp(-way / (0.9 * spacing)); });
    EXPECT_LT(kolmogorov_probability(wrong, ways.size()), 1e-3) << kind.name;
  }
}

// Bumps and all that follows are the same on a plane of one facet and on one of a thousand.
TEST(RocksOnRoughGround, FacetsOfAPlaneDoNotMatter) {
  constexpr double angle = 0.62;
  const Profile whole = slope(angle, 1), divided = slope(angle, 1000);
  const Soil soil{.rn = 0.35, .rt = 0.85, .phi = 0.58, .mu = 0.6, .rolling = 0.5, .roughness = 0.17, .bump_spacing = 5};
  for (const Kind& kind : kinds) {
    const Laws laws = laws_of(kind);
    std::size_t compared = 0;
    for (std::uint64_t rock = 0; rock < 60; ++rock) {
      const Followed a = follow(whole, ground_of(soil), laws, along(angle, 6, laws), {}, rock);
      const Followed b = follow(divided, ground_of(soil), laws, along(angle, 6, laws), {}, rock);
      // Rounding grows tenfold at every bounce.
      double allowed = 1e-11;
      for (std::size_t k = 0; k < std::min(a.log.rows.size(), b.log.rows.size()) && allowed < 1e-4; ++k, ++compared) {
        ASSERT_EQ(name(a.log.rows[k].state), name(b.log.rows[k].state))
            << kind.name << " rock " << rock << " row " << k;
        ASSERT_LT((a.log.rows[k].motion.position - b.log.rows[k].motion.position).norm(), allowed)
            << kind.name << " rock " << rock << " row " << k;
        allowed *= 10;
      }
    }
    EXPECT_GT(compared, 200U) << kind.name;
  }
}

// A rock that slid is thrown up by the faces that rise against it: the struck normals of bumps lean back by a tilt with
// density psi exp(-psi^2 / 2 sd^2), for small tilts.
TEST(RocksOnRoughGround, BumpsAreRisingFaces) {
  constexpr double sd = 0.02, angle = 0.6;
  const Profile ground = slope(angle, 1);
  const Vec3 n(std::sin(angle), 0, std::cos(angle));
  for (const Kind& kind : kinds) {
    const Laws laws = laws_of(kind);
    std::vector<double> tilts;
    for (std::uint64_t rock = 0; rock < 3000; ++rock) {
      Followed path;
      path.log.keep_impacts(true);
      const Draws draws(SamplingPlan{}, rock);
      const Ground rough =
          ground_of({.rn = 0, .rt = 1, .phi = 0.55, .mu = 0.6, .rolling = 0.6, .roughness = sd, .bump_spacing = 5});
      static_cast<void>(follow_rock(Scene<Profile>{ground, rough, {}, laws}, along(angle, 5, laws), draws, path.log));
      for (std::size_t k = 1; k < path.log.impacts.size() && k < 2; ++k) {
        const Impact& impact = path.log.impacts[k];
        const double into = -impact.before.velocity.dot(n) / impact.before.velocity.norm();
        if (into > 1e-6) continue;  // not along the ground
        const Vec3& struck = impact.struck_normal;
        tilts.push_back(std::asin(n.cross(struck).dot(Vec3(0, -1, 0))));
      }
    }
    ASSERT_GT(tilts.size(), 1000U) << kind.name;
    const double distance =
        kolmogorov_distance(tilts, [](double psi) { return psi <= 0 ? 0 : 1 - std::exp(-0.5 * psi * psi / sd / sd); });
    EXPECT_GT(kolmogorov_probability(distance, tilts.size()), 0.01) << kind.name;
  }
}

// On smooth ground no bit depends on the law of roughness.
TEST(RocksOnRoughGround, SmoothGroundIsUntouched) {
  const Profile ground(std::vector<Vec2>{{0, 0}, {20, -16}, {30, -20}, {34, -26}, {80, -40}, {200, -44}});
  for (const Kind& kind : kinds) {
    Laws faces = laws_of(kind), tilts = faces;
    tilts.roughness = RoughnessLaw::tilts;
    const Soil soil{.rn = 0.35, .rt = 0.85, .bump_spacing = 2};
    for (std::uint64_t rock = 0; rock < 20; ++rock) {
      const Release release = along(std::atan(0.8), 1 + 0.3 * static_cast<double>(rock), faces);
      const Followed a = follow(ground, ground_of(soil), faces, release, {}, rock);
      const Followed b = follow(ground, ground_of(soil), tilts, release, {}, rock);
      ASSERT_EQ(a.log.rows.size(), b.log.rows.size());
      for (std::size_t k = 0; k < a.log.rows.size(); ++k) {
        ASSERT_EQ(a.log.rows[k].motion.position, b.log.rows[k].motion.position) << kind.name;
        ASSERT_EQ(a.log.rows[k].motion.velocity, b.log.rows[k].motion.velocity) << kind.name;
        ASSERT_EQ(a.log.rows[k].motion.spin, b.log.rows[k].motion.spin) << kind.name;
      }
    }
  }
}

}  // namespace
}  // namespace talus::trajectory_rough_ground_test
