// A slide over a polygon tends to the slide on the smooth curve: on circular arcs, hollow and crest, for both models.
//
// With E = v^2, c = 2 for a slide and 10/7 for a rolling sphere, R the radius of the centre's path, and the slope a,
// the normal acceleration is N = g cos a + v^2/R in a hollow and g cos a - v^2/R on a crest, and
//   hollow (a falls):  dE/da = -c g R (sin a - mu cos a) + c mu E
//   crest (a grows):   dE/da =  c g R (sin a - mu cos a) + c mu E
// with the solutions E = C exp(c mu a) + A cos a + B sin a below.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/scenes.hpp"
#include "talus/terrain/profile.hpp"

namespace talus::bends_test {
namespace {

using namespace testing_tools;

constexpr double g = standard_gravity;
const Rock small_sphere = sphere_of_diameter(0.2, 2700);

/// A slide from the slope angle `from` to `to`, on a circle of radius `radius`.
struct Arc {
  double from, to, radius, speed, mu;
  [[nodiscard]] bool is_hollow() const { return from > to; }
};
constexpr Arc hollow{0.8, 0, 50, 6, 0.3}, crest{0.3, 0.6, 50, 9, 0.3};

std::vector<Vec2> polygon(const Arc& arc, int facets) {
  std::vector<Vec2> section;
  for (int k = 0; k <= facets; ++k) {
    const double a = arc.from + (arc.to - arc.from) * k / facets;
    const double x = arc.radius * std::sin(a), z = arc.radius * std::cos(a);
    section.push_back(arc.is_hollow() ? Vec2(-x, -z) : Vec2(x, z));
  }
  return section;
}

double speed_on_the_curve(const Arc& arc, double c, double radius, double speed) {
  const double mu = arc.mu, sign = arc.is_hollow() ? 1 : -1;
  const double cosine = sign * c * g * radius * (1 - c * mu * mu) / (1 + c * c * mu * mu);
  const double sine = c * mu * (cosine + sign * g * radius);
  const auto particular = [&](double a) { return cosine * std::cos(a) + sine * std::sin(a); };
  const double constant = speed * speed - particular(arc.from);
  return std::sqrt(constant * std::exp(c * mu * (arc.to - arc.from)) + particular(arc.to));
}

Followed over(const Arc& arc, int facets, RockModel model, SlidingMethod sliding) {
  Laws laws;
  set_model(laws, model);
  laws.sliding = sliding;
  laws.timestep = 0.0005;
  const std::vector<Vec2> section = polygon(arc, facets);
  const Vec2 way = (section[1] - section[0]).normalized();
  const Vec3 ahead(way.x(), 0, way.y()), up(-way.y(), 0, way.x());
  const double reach = model == RockModel::rigid_sphere ? small_sphere.radius : 0;
  const Vec3 start = Vec3(section[0].x(), 0, section[0].y()) + 1e-3 * ahead + reach * up;
  Soil soil{.rn = 0.3, .rt = 1, .phi = std::atan(arc.mu)};
  soil.mu = 0.9;
  soil.rolling = arc.mu;
  const Vec3 spin = up.cross(arc.speed * ahead) / small_sphere.radius;
  return follow(Profile(section), ground_of(soil), laws, {{start, arc.speed * ahead, spin}, small_sphere});
}

/// The error of the speed at the end, as a share.
double error_of(const Arc& arc, int facets, RockModel model, SlidingMethod sliding) {
  const Followed path = over(arc, facets, model, sliding);
  EXPECT_EQ(path.outcome.reason, EndReason::left_model) << facets;
  const bool rolls = model == RockModel::rigid_sphere;
  const double reach = rolls ? small_sphere.radius : 0;
  const double radius = arc.radius + (arc.is_hollow() ? -reach : reach);
  // The impact with which the rock is set down takes some speed from the lumped mass.
  const double speed = path.log.rows.at(2).motion.velocity.norm();
  const double exact = speed_on_the_curve(arc, rolls ? 10.0 / 7 : 2.0, radius, speed);
  return path.outcome.end.velocity.norm() / exact - 1;
}

TEST(Bends, OfAPolygonTendToTheCurve) {
  for (const Arc& arc : {hollow, crest}) {
    for (const SlidingMethod sliding : {SlidingMethod::stepped, SlidingMethod::closed_form}) {
      for (int facets = 8; facets <= 512; facets *= 2) {
        // The first and the last facet, half of which the curve's bends do not reach; and steps of 0.5 ms.
        const double allowed = 0.4 / facets + 0.001;
        EXPECT_NEAR(error_of(arc, facets, RockModel::lumped_mass, sliding), 0, allowed)
            << facets << (arc.is_hollow() ? " hollow" : " crest");
      }
    }
    for (int facets = 8; facets <= 512; facets *= 2) {
      EXPECT_NEAR(error_of(arc, facets, RockModel::rigid_sphere, SlidingMethod::stepped), 0, 0.4 / facets + 0.001)
          << facets << (arc.is_hollow() ? " hollow" : " crest");
    }
  }
}

TEST(Bends, NeverAddEnergy) {
  for (const RockModel model : {RockModel::lumped_mass, RockModel::rigid_sphere}) {
    for (Arc arc : {hollow, crest}) {
      arc.mu = 0;
      for (int facets = 8; facets <= 128; facets *= 2) {
        const Followed path = over(arc, facets, model, SlidingMethod::closed_form);
        double before = 1e300;
        for (const PathRow& row : path.log.rows) {
          const Motion& m = row.motion;
          const double energy = small_sphere.mass * (0.5 * m.velocity.squared_norm() + g * m.position.z()) +
                                0.5 * small_sphere.inertia * m.spin.squared_norm();
          EXPECT_LE(energy, before + 1e-6 * small_sphere.mass) << facets;
          before = energy;
        }
      }
    }
  }
}

}  // namespace
}  // namespace talus::bends_test
