// For any slope and any rock: energy never rises, no rock gets below the ground, every trajectory ends.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <ostream>
#include <string>

#include "support/meshes.hpp"
#include "support/scenes.hpp"
#include "talus/rocks/touch.hpp"
#include "talus/terrain/profile.hpp"

namespace talus::random_rocks_test {
namespace {

using namespace testing_tools;

Laws random_laws(Dice& dice) {
  Laws laws;
  const RockModel model = dice.chance(0.5) ? RockModel::lumped_mass : RockModel::rigid_sphere;
  set_model(laws, model, dice.chance(0.5));
  laws.sliding = dice.chance(0.5) ? SlidingMethod::stepped : SlidingMethod::closed_form;
  if (dice.chance(0.25)) laws.roughness = RoughnessLaw::tilts;
  const bool is_damped = dice.chance(0.2);
  if (auto* sphere = std::get_if<RigidSphereImpact>(&laws.impact)) sphere->has_crsp_damping = is_damped;
  return laws;
}

Soil random_soil(Dice& dice) {
  Soil soil;
  soil.rn = dice.chance(0.15) ? 0.0 : dice.between(0, 0.9);
  soil.rt = dice.chance(0.1) ? 0.0 : dice.chance(0.1) ? 1.0 : dice.between(0, 1);
  soil.phi = dice.between(0.05, 0.9);
  soil.mu = dice.between(0.05, 1);
  soil.rolling = dice.between(0.02, 0.4);
  if (dice.chance(0.4)) {
    soil.roughness = dice.between(0.01, 0.3);
    soil.bump_spacing = dice.chance(0.2) ? 0 : dice.magnitude(0.05, 20);
  }
  return soil;
}

std::string describe(const Laws& laws, const Soil& soil, const Release& release, int number) {
  const Motion& m = release.motion;
  const bool is_plain = std::holds_alternative<PlainImpact>(laws.impact);
  const auto* const sphere = std::get_if<RigidSphereImpact>(&laws.impact);
  return "rock " + std::to_string(number) + (laws.model == RockModel::rigid_sphere ? " sphere" : " lumped") +
         (is_plain ? " plain" : "") + (laws.sliding == SlidingMethod::stepped ? " stepped" : " closed") +
         (sphere && sphere->has_crsp_damping ? " damped" : "") + " rn " + std::to_string(soil.rn) + " rt " +
         std::to_string(soil.rt) + " phi " + std::to_string(soil.phi) + " mu " + std::to_string(soil.mu) + " rolling " +
         std::to_string(soil.rolling) + " rough " + std::to_string(soil.roughness) + " bumps " +
         std::to_string(soil.bump_spacing) + " p " + text(m.position) + " v " + text(m.velocity) + " w " +
         text(m.spin) + " r " + std::to_string(release.rock.radius);
}

// A description of what is wrong with a path; empty if nothing is. The rows are complete: an arrival and a departure
// for each contact.
std::string what_is_wrong(const Followed& path, const Rock& rock, const Laws& laws, const Soil& soil) {
  const auto& rows = path.log.rows;
  const EndReason reason = path.outcome.reason;
  if (rows.size() < 2 || rows.front().state != PathState::projectile || rows.back().state != PathState::ended) {
    return "the rows do not begin with the release and end with the end";
  }
  // If a contact leaves hardly any tangential speed, a rock may stop at every bend of the slope.
  const bool may_take_for_ever = laws.model == RockModel::lumped_mass && soil.rt < 0.02;
  if (reason == EndReason::lost || (reason == EndReason::maximum_steps && !may_take_for_ever)) {
    return name(reason) + rows_up_to(path, rows.size() - 1);
  }
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (!is_finite(rows[i].motion)) return "not finite" + rows_up_to(path, i);
    if (rows[i].motion.time < rows[i - 1].motion.time) return "time runs backwards" + rows_up_to(path, i);
    const double before = total_energy(rows[i - 1].motion, rock, laws.gravity);
    const double after = total_energy(rows[i].motion, rock, laws.gravity);
    // Rounding of energies, and of heights of the size of the model. Also, a rock may be lifted by the thickness within
    // which it counts as on the ground, once for every leg between two rows.
    const double weight = rock.mass * laws.gravity.norm();
    const double scale = kinetic_energy(rows[i].motion, rock) + weight * 100;
    if (after > before + 1e-11 * scale + 64 * contact_slack * weight) {
      return "gains " + std::to_string(after - before) + " J of " + std::to_string(scale) + rows_up_to(path, i);
    }
    const bool flew = rows[i - 1].state == PathState::projectile && rows[i].state != PathState::ended;
    if (flew && after < before - 1e-11 * scale) return "loses energy in flight" + rows_up_to(path, i);
  }
  return "";
}

// Simulates many rocks; counts those with errors, and shows the first few.
class Verdict {
 public:
  void add(const Followed& path, const Rock& rock, const Laws& laws, const Soil& soil, const std::string& who) {
    const std::string wrong = what_is_wrong(path, rock, laws, soil);
    if (wrong.empty()) return;
    if (++wrong_ <= 3) ADD_FAILURE() << who << '\n' << wrong;
  }
  ~Verdict() { EXPECT_EQ(wrong_, 0) << "rocks have errors"; }

 private:
  int wrong_ = 0;
};

template <class Surface>
Release random_release(Dice& dice, const Surface& surface, double x, double y, const Laws& laws, double size) {
  Release release;
  const double radius = dice.magnitude(0.02, 1) * size;
  release.rock = sphere_of_diameter(2 * radius, 2700);
  const double reach = laws.model == RockModel::rigid_sphere ? radius : 0;
  const double height = dice.between(0, 5);
  release.motion.position = {x, y, *surface.elevation(x, y) + 4 * reach + height};
  // Next to a wall it may be in the wall: lifted until it is clear.
  bool is_clear = false;
  while (!is_clear) {
    is_clear = true;
    surface.supports(release.motion.position, reach, 1e-3, [&](auto&&...) { is_clear = false; });
    if (!is_clear) release.motion.position.z() += 0.5;
  }
  release.motion.velocity = dice.direction();
  release.motion.velocity *= dice.between(0, 8);
  if (dice.chance(0.5)) {
    release.motion.spin = dice.direction();
    release.motion.spin *= dice.between(0, 20);
  }
  return release;
}

// A kind of terrain, the places of release on plan, and the largest radius.
struct Scenery {
  const char* name;
  Shape (*make)(Dice&);
  double low, high, largest;
  int grounds, rocks;
};

std::ostream& operator<<(std::ostream& out, const Scenery& scenery) { return out << scenery.name; }

Shape rough_slope(Dice& dice) {
  const double relief = dice.magnitude(0.01, 3), grade = dice.between(0, 1.5);
  return random_slope(dice, 20, 60, grade, relief);
}

Shape fine_slope(Dice& dice) {
  const double relief = dice.magnitude(0.001, 0.5), grade = dice.between(0, 1.2);
  return random_slope(dice, 60, 20, grade, relief);
}

Shape bowl(Dice& dice) {
  const double depth = dice.between(0.002, 0.05);
  return irregular_field(dice, 16, 16, 40, 40,
                         [&](double x, double y) { return depth * ((x - 20) * (x - 20) + (y - 20) * (y - 20)); });
}

Shape valley_or_ridge(Dice& dice) {
  const double steep = dice.between(0.2, 2) * (dice.chance(0.5) ? 1 : -1), fall = dice.between(0, 0.6);
  return net(
      8, 8,
      [&](std::uint32_t i, std::uint32_t j) {
        const double x = 5.0 * i, y = 5.0 * j;
        return Vec3(x, y, steep * std::abs(y - 20) - fall * x);
      },
      [&](std::uint32_t, std::uint32_t) { return dice.chance(0.5); });
}

// Terraces with vertical faces, some up, some down.
Shape terraces(Dice& dice) {
  const double step = dice.between(0.5, 3), fall = dice.between(0, 0.4);
  return net(
      13, 6,
      [&](std::uint32_t i, std::uint32_t j) {
        const double x = 5.0 * ((i + 1) / 2);
        return Vec3(x, 5.0 * j, ((i / 2) % 2 == 0 ? 0.0 : step) - fall * x);
      },
      [&](std::uint32_t, std::uint32_t) { return dice.chance(0.5); });
}

struct Launch {
  Laws laws;
  Soil soil;
  Release release;
};

Launch random_launch(const Scenery& scenery, const TriangleMesh& mesh, int ground, int number) {
  Dice dice(static_cast<std::uint64_t>(1000 * ground + number + 1));
  Launch it;
  it.laws = random_laws(dice);
  it.soil = random_soil(dice);
  const double x = dice.between(scenery.low, scenery.high), y = dice.between(scenery.low, scenery.high);
  it.release = random_release(dice, mesh, x, y, it.laws, scenery.largest);
  return it;
}

TriangleMesh random_ground(const Scenery& scenery, int number) {
  Dice dice(static_cast<std::uint64_t>(number));
  return scenery.make(dice).mesh();
}

void follow_random(const Scenery& scenery, const TriangleMesh& mesh, int ground, int number, Verdict& verdict) {
  const auto [laws, soil, release] = random_launch(scenery, mesh, ground, number);
  const Followed path = follow(mesh, ground_of(soil), laws, release, {}, static_cast<std::uint64_t>(number));
  verdict.add(path, release.rock, laws, soil,
              "ground " + std::to_string(ground) + ' ' + describe(laws, soil, release, number));
}

// `make soak` multiplies the number of rocks.
int effort() {
  const char* wish = std::getenv("TALUS_TEST_EFFORT");
  return wish == nullptr ? 1 : std::max(1, std::atoi(wish));
}

class RandomRocks : public testing::TestWithParam<Scenery> {};

TEST_P(RandomRocks, PathsObeyTheLaws) {
  const Scenery& scenery = GetParam();
  Verdict verdict;
  for (int ground = 0; ground < effort() * scenery.grounds; ++ground) {
    const TriangleMesh mesh = random_ground(scenery, ground);
    for (int number = 0; number < scenery.rocks; ++number) follow_random(scenery, mesh, ground, number, verdict);
  }
}

const std::array sceneries{
    Scenery{"RoughSlope", rough_slope, 5, 55, 1.0, 40, 100},
    Scenery{"LargerThanTheFacets", fine_slope, 4, 16, 3.0, 10, 60}, Scenery{"Bowl", bowl, 8, 32, 1.0, 10, 100},
    Scenery{"ValleyOrRidge", valley_or_ridge, 8, 32, 1.0, 10, 100}, Scenery{"Terraces", terraces, 4, 26, 0.8, 10, 100}};

INSTANTIATE_TEST_SUITE_P(Everywhere, RandomRocks, testing::ValuesIn(sceneries),
                         [](const auto& family) { return std::string(family.param.name); });

// What soaks have found: spheres between a facet and an edge into which they had sunk a little, in pits of three
// facets, and guided along a facet; and a lumped mass at the foot of a vertical wall.
TEST(RandomRocksOfSoaks, PathsObeyTheLaws) {
  struct Found {
    std::size_t scenery;
    int ground, number;
  };
  Verdict verdict;
  for (const Found& found :
       {Found{0, 104, 74}, Found{0, 104, 86}, Found{0, 206, 1}, Found{0, 282, 26}, Found{0, 299, 65}, Found{0, 328, 18},
        Found{1, 67, 47}, Found{1, 67, 59}, Found{4, 25, 49}}) {
    const Scenery& scenery = sceneries[found.scenery];
    follow_random(scenery, random_ground(scenery, found.ground), found.ground, found.number, verdict);
  }
}

TEST(RandomRocksInSection, PathsObeyTheLaws) {
  Dice dice(16);
  Verdict verdict;
  for (int slope = 0; slope < 60; ++slope) {
    std::vector<Vec2> section{{0, 0}};
    for (int k = 0; k < (slope % 3 == 0 ? 80 : 12); ++k) {
      const double dx = dice.chance(0.1) ? 0.0 : dice.between(0.1, 4);
      section.emplace_back(section.back() + Vec2(dx, dice.between(-4, 1.5)));
    }
    const Profile profile(section);
    for (int number = 0; number < 60; ++number) {
      Laws laws = random_laws(dice);
      laws.in_section = true;
      const Soil soil = random_soil(dice);
      const double x = dice.between(0.1, 0.9) * section.back().x();
      Release release = random_release(dice, profile, x, 0, laws, 1.0);
      release.motion.velocity.y() = 0;
      release.motion.spin = {0, release.motion.spin.norm(), 0};
      const Followed path = follow(profile, ground_of(soil), laws, release, {}, static_cast<std::uint64_t>(number));
      verdict.add(path, release.rock, laws, soil,
                  "slope " + std::to_string(slope) + ' ' + describe(laws, soil, release, number));
      ASSERT_LT(std::abs(path.outcome.end.position.y()), 1e-12);
    }
  }
}

}  // namespace
}  // namespace talus::random_rocks_test
