// Energies and heights from the pieces of a path, compared to those of the run and to closed forms.

#include "talus/trajectory/piece_maxima.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/meshes.hpp"
#include "support/scenes.hpp"
#include "talus/terrain/profile.hpp"
#include "talus/terrain/raster_surface.hpp"

namespace talus::piece_maxima_test {
namespace {

using namespace testing_tools;

template <class Surface>
Followed follow_pieces(const Surface& surface, const Soil& soil, const Laws& laws, const Release& release) {
  Followed result{{}, RockLog(true, true)};
  const Ground ground = ground_of(soil);
  const Draws draws(SamplingPlan{}, 0);
  result.outcome = follow_rock(Scene<Surface>{surface, ground, {}, laws}, release, draws, result.log);
  return result;
}

Release start_at(const Vec3& position, const Vec3& velocity, const Vec3& spin = Vec3{}) {
  Release release;
  release.rock = sphere_of_mass(1000, 2700);
  release.motion.position = position;
  release.motion.velocity = velocity;
  release.motion.spin = spin;
  return release;
}

Profile slope_of_30_degrees() {
  const Vec2 vertices[] = {{0, 0}, {100 * std::sqrt(3.0), -100}};
  return Profile(vertices);
}

// The kinetic energy of a sphere that rolls without resistance is m g h at the end of every leg, h its fall.
TEST(PieceMaxima, TheMaximumEnergyOfARollingSphereIsAtTheEndOfItsLegs) {
  const Profile slope = slope_of_30_degrees();
  Laws laws;
  set_model(laws, RockModel::rigid_sphere);
  const Vec3 normal(0.5, 0, std::sqrt(0.75));
  Release release = start_at(Vec3(10, 0, -10 / std::sqrt(3.0)), Vec3{});
  release.motion.position += release.rock.radius * normal;
  const Followed path = follow_pieces(slope, {.rn = 0, .mu = 10, .rolling = 0}, laws, release);
  std::size_t legs = 0;
  for (const PathPiece& piece : path.log.pieces) {
    if (!piece.on_ground) continue;
    const double fallen = release.motion.position.z() - piece.path.z(piece.duration);
    const double energy = max_motion(piece, release.rock, 0, piece.duration).energy_total;
    const double expected = release.rock.mass * standard_gravity * fallen;
    ASSERT_NEAR(energy, expected, 1e-9 * expected + 1e-9);  // rounding in a sum over some hundred legs
    ++legs;
  }
  EXPECT_GT(legs, 300U);
  EXPECT_NEAR(path.outcome.max_kinetic_energy,
              release.rock.mass * standard_gravity * (release.motion.position.z() - path.outcome.end.position.z()),
              1e-9 * path.outcome.max_kinetic_energy);
}

// A rock with spin lands and gains speed: its slide starts faster than it arrived.
TEST(PieceMaxima, IncludeTheSpeedAtTheStartOfASlide) {
  const Vec2 level[] = {{0, 0}, {100, 0}};
  Laws laws;
  laws.timestep = 0.1;
  const Followed path = follow_pieces(Profile(level), {.rn = 0.02, .rt = 0.9, .phi = 0.2}, laws,
                                      start_at({10, 0, 1}, {1, 0, 0}, {0, 30, 0}));
  const auto sliding = std::ranges::find(path.log.rows, PathState::sliding, &PathRow::state);
  ASSERT_NE(sliding, path.log.rows.end());
  const double began = sliding->motion.velocity.squared_norm();
  double greatest = 0;
  std::size_t glides = 0;
  for (const PathPiece& piece : every_piece(path.log)) {
    if (!piece.on_ground) continue;
    greatest = std::max(greatest, max_motion(piece, sphere_of_mass(1000, 2700), 0, piece.duration).squared_velocity);
    ++glides;
  }
  ASSERT_GT(glides, 3U);
  EXPECT_EQ(greatest, began);
}

/// Compares the rows and the outcome of a rock to its pieces.
template <class Surface>
void expect_agreement(const Surface& surface, const Followed& path, const Rock& rock, bool is_sphere, Dice& dice) {
  const double reach = is_sphere ? rock.radius : 0;
  double energy = 0, height = reach, energy_in_parts = 0, height_in_parts = reach;
  for (const PathPiece& piece : every_piece(path.log)) {
    energy = std::max(energy, max_motion(piece, rock, 0, piece.duration).energy_total);
    height = max_height(surface, piece, is_sphere, 0, piece.duration, height);
    double from = 0;
    for (int part = 0; part < 4; ++part) {
      const double to = part == 3 ? piece.duration : dice.between(from, piece.duration);
      energy_in_parts = std::max(energy_in_parts, max_motion(piece, rock, from, to).energy_total);
      height_in_parts = max_height(surface, piece, is_sphere, from, to, height_in_parts);
      from = to;
    }
  }
  double rows = 0;
  for (const PathRow& row : path.log.rows) rows = std::max(rows, kinetic_energy(row.motion, rock));
  // Except for rounding, of positions at 100 m and of energies.
  EXPECT_NEAR(path.outcome.max_bounce, lowest_point(height, reach), 1e-9);
  EXPECT_NEAR(height_in_parts, height, 1e-9);
  EXPECT_NEAR(path.outcome.max_kinetic_energy, energy, 1e-12 * energy);
  EXPECT_NEAR(energy_in_parts, energy, 1e-12 * energy);
  EXPECT_LE(rows, energy * (1 + 1e-12));
}

template <class MakeSurface>
void expect_agreement_of_rocks(std::uint64_t seed, MakeSurface&& make_surface) {
  Dice dice(seed);
  std::size_t legs = 0;
  for (int slope = 0; slope < 6; ++slope) {
    const auto surface = make_surface(dice);
    for (int k = 0; k < 40; ++k) {
      Laws laws;
      set_model(laws, k % 2 == 0 ? RockModel::lumped_mass : RockModel::rigid_sphere);
      laws.sliding = dice.chance(0.5) ? SlidingMethod::stepped : SlidingMethod::closed_form;
      laws.timestep = dice.chance(0.5) ? 0.01 : 0.1;
      const bool is_sphere = laws.model == RockModel::rigid_sphere;
      const Soil soil{.rn = dice.between(0, 0.6),
                      .rt = dice.between(0.5, 1),
                      .phi = dice.between(0.1, 0.7),
                      .mu = dice.between(0.05, 1),
                      .rolling = dice.between(0, 0.3)};
      Release release = start_at({dice.between(5, 50), dice.between(20, 40), 0}, dice.in_cube(5), dice.in_cube(10));
      const Vec3& place = release.motion.position;
      release.motion.position.z() = *surface.elevation(place.x(), place.y()) + 4 * release.rock.radius;
      const Followed path = follow_pieces(surface, soil, laws, release);
      expect_agreement(surface, path, release.rock, is_sphere, dice);
      for (const PathPiece& piece : path.log.pieces) legs += piece.on_ground ? 1 : 0;
      ASSERT_FALSE(testing::Test::HasFailure()) << "slope " << slope << " rock " << k;
    }
  }
  EXPECT_GT(legs, 1000U);
}

TEST(PieceMaxima, AreThoseOfTheRunOverAMesh) {
  expect_agreement_of_rocks(
      21, [](Dice& dice) { return random_slope(dice, 20, 60, dice.between(0.2, 0.8), dice.magnitude(0.1, 2)).mesh(); });
}

TEST(PieceMaxima, AreThoseOfTheRunOverARaster) {
  expect_agreement_of_rocks(22, [](Dice& dice) {
    RasterGrid grid{.columns = 61, .rows = 61};
    const double grade = dice.between(0.2, 0.8), relief = dice.magnitude(0.05, 0.5);
    for (int k = 0; k < 61 * 61; ++k) grid.z.push_back(static_cast<float>(-grade * (k % 61) + dice.between(0, relief)));
    return RasterSurface(grid);
  });
}

TEST(PieceMaxima, AreThoseOfTheRunOverASection) {
  expect_agreement_of_rocks(23, [](Dice& dice) {
    std::vector<Vec2> vertices;
    const double grade = dice.between(0.2, 0.8);
    for (int k = 0; k <= 40; ++k) vertices.emplace_back(1.5 * k, -grade * 1.5 * k + dice.between(0, 0.5));
    return Profile(vertices);
  });
}

// All parts in one walk along the surface, or in one search, or each part alone: across borders of cells and within
// them.
template <class Surface>
void expect_heights_of_parts_alone(Dice& dice, const Surface& surface, double size) {
  int above = 0;
  for (int trial = 0; trial < 500; ++trial) {
    PathPiece piece;
    const double x = dice.between(-3, size + 3), y = dice.between(-3, size + 3);
    piece.path = {{x, y, surface.elevation(x, y).value_or(0) + dice.between(1, 7)}, dice.in_cube(8), {0, 0, -9.81}};
    if (dice.chance(0.1)) piece.path.v = {0, 0, piece.path.v.z()};
    piece.duration = dice.between(0.1, 2);
    std::vector<double> borders{0, piece.duration};
    for (std::size_t k = dice.below(20); k > 0; --k) borders.push_back(piece.duration * dice.unit());
    std::sort(borders.begin(), borders.end());
    std::vector<double> heights(borders.size() - 1, -1);
    max_heights(surface, piece, false, borders, heights);
    for (std::size_t k = 0; k < heights.size(); ++k) {
      const double alone = max_height_of_flight(surface, piece.path, borders[k], borders[k + 1], 0);
      ASSERT_NEAR(heights[k], alone, 1e-9) << trial << ": part " << k;
      above += heights[k] > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(above, 1000);
}

TEST(PieceMaxima, HeightsOfAllPartsAreThoseOfEachAlone) {
  Dice dice(24);
  RasterGrid grid{.columns = 31, .rows = 31};
  for (int k = 0; k < 31 * 31; ++k) grid.z.push_back(static_cast<float>(dice.between(0, 2)));
  expect_heights_of_parts_alone(dice, RasterSurface(grid), 30);
  expect_heights_of_parts_alone(dice, random_slope(dice, 10, 20, 0.5, 1).mesh(), 20);
  Shape roof_over_floor = box({4, 4, 4}, {16, 16, 5});  // flights pass through the roof
  const auto first = static_cast<std::uint32_t>(roof_over_floor.vertices.size());
  roof_over_floor.vertices.insert(roof_over_floor.vertices.end(), {{0, 0, 0}, {20, 0, 0}, {20, 20, 0}, {0, 20, 0}});
  roof_over_floor.triangles.push_back({first, first + 1, first + 2});
  roof_over_floor.triangles.push_back({first, first + 2, first + 3});
  expect_heights_of_parts_alone(dice, roof_over_floor.mesh(), 20);
}

// If a facet is below the whole leg, the height is computed from it alone; if not, from the surface.
TEST(PieceMaxima, HeightOfALegOverOneFacetIsThatOverTheSurface) {
  Dice dice(25);
  int over_one = 0;
  const auto expect = [&](const auto& surface, double size) {
    for (int trial = 0; trial < 4000; ++trial) {
      const double x = dice.between(0, size), y = dice.between(0, size);
      const Vec3 start(x, y, surface.elevation(x, y).value() + dice.between(0.1, 2));
      const Parabola leg{start, dice.magnitude(1e-3, 3) * dice.direction(), Vec3{}};
      const auto below = surface.ground_below(start);
      ASSERT_TRUE(below);
      const FacetId facet =
          dice.chance(0.9) ? below->facet : FacetId{static_cast<std::uint32_t>(dice.below(surface.facet_count()))};
      const Outline outline = surface.outline(facet);
      const double known = dice.chance(0.5) ? 0 : dice.between(0, 2);
      const double from = dice.between(0, 0.5), to = dice.between(0.5, 1);
      over_one += height_over(outline, leg.at(from)) && height_over(outline, leg.at(to)) ? 1 : 0;
      const double found = max_height_of_leg(surface, outline, leg, 1, from, to, known);
      const double expected = surface.max_height({leg.at(from), leg.v, Vec3{}}, to - from, known);
      ASSERT_NEAR(found, expected, 1e-9) << trial;
    }
  };
  expect(random_slope(dice, 10, 20, 0.5, 1).mesh(), 20);
  RasterGrid grid{.columns = 21, .rows = 21};
  for (int k = 0; k < 21 * 21; ++k) grid.z.push_back(static_cast<float>(dice.between(0, 1)));
  expect(RasterSurface(grid), 20);
  EXPECT_GT(over_one, 2000);
}

// The ground below a leg is a roof above the given facet.
TEST(PieceMaxima, HeightOfALegAboveARoofIsMeasuredFromTheRoof) {
  Shape shape = box({4, 4, 1}, {6, 6, 1.5});
  const auto first = static_cast<std::uint32_t>(shape.vertices.size());
  shape.vertices.insert(shape.vertices.end(), {{0, 0, 0}, {20, 0, 0}, {0, 20, 0}});
  shape.triangles.push_back({first, first + 1, first + 2});
  const TriangleMesh mesh = shape.mesh();
  const Parabola leg{{4.5, 5, 4}, {1, 0, 0}, Vec3{}};
  const auto floor = mesh.ground_below({1, 1, 1});
  ASSERT_TRUE(floor);
  EXPECT_NEAR(max_height_of_leg(mesh, mesh.outline(floor->facet), leg, 1, 0, 1, 0), 2.5, 1e-9);
}

}  // namespace
}  // namespace talus::piece_maxima_test
