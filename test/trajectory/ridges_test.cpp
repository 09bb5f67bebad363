// Rocks with a shape on ground that is sharper than they are: spikes, ridges, steps, and meshes finer than their faces.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "support/dice.hpp"
#include "support/meshes.hpp"
#include "support/scenes.hpp"
#include "talus/meshing/rock_shape.hpp"
#include "talus/rocks/separation.hpp"
#include "talus/terrain/profile.hpp"
#include "talus/terrain/raster_surface.hpp"
#include "talus/terrain/triangle_mesh.hpp"
#include "talus/trajectory/rock_run.hpp"

namespace talus::ridges_test {
namespace {

using namespace testing_tools;

constexpr double g = 9.81;

Laws laws(bool in_section = false) {
  Laws laws;
  set_model(laws, RockModel::rigid_sphere);
  laws.gravity = {0, 0, -g};
  laws.stopped_velocity = 0.01;
  laws.in_section = in_section;
  return laws;
}

/// The facets near a body as polygons.
std::vector<std::vector<Vec3>> facets_near(const Profile& section, const Vec3& centre, double reach) {
  std::vector<std::vector<Vec3>> facets;
  section.supports(centre, reach, 0, [&](const Vec3&, const Vec3&, double, FacetId facet) {
    const Outline outline = section.outline(facet);
    facets.push_back({outline.edges[0].point, outline.edges[1].point});
  });
  return facets;
}
template <class Surface>
std::vector<std::vector<Vec3>> facets_near(const Surface& surface, const Vec3& centre, double reach) {
  std::vector<std::vector<Vec3>> facets;
  surface.supports(centre, reach, 0, [&](const Vec3&, const Vec3&, double, FacetId facet) {
    const Triangle corner = surface.triangle(facet);
    facets.push_back({corner.begin(), corner.end()});
  });
  return facets;
}

/// Whether a body is clear of all facets, by the search for distances, which knows nothing of ridges and corners.
template <class Surface>
bool is_clear(const Surface& surface, const Posture& body) {
  for (const auto& facet : facets_near(surface, body.centre, body.reach)) {
    if (!separation(body, facet)) return false;
  }
  return true;
}

/// How far a body would have to be moved along one of some directions to be clear of the ground, at least [m].
template <class Surface>
double depth_of(const Surface& surface, Posture body, std::span<const Vec3> ways) {
  constexpr double deepest = 1;
  if (is_clear(surface, body)) return 0;
  double least = deepest;
  const Vec3 centre = body.centre;
  for (const Vec3& way : ways) {
    const auto is_out = [&](double depth) {
      body.centre = centre + depth * way;
      return is_clear(surface, body);
    };
    if (!is_out(least)) continue;
    double in = 0;
    while (least - in > 1e-5) {
      const double middle = 0.5 * (in + least);
      (is_out(middle) ? least : in) = middle;
    }
  }
  return least;
}

/// The energy of a rock, and its posture along its path.
template <class Surface>
struct Watcher {
  const Surface& surface;
  std::vector<Vec3> ways{unit_z};
  bool looks = true;
  double deepest = 0, gain = 0;
  Motion deepest_at;
  std::vector<Motion> moments, rebounds;
  std::vector<Vec3> normals;
  RockRun<Surface, Watcher>* run = nullptr;
  Body body{};
  Rock rock;
  double least_energy = std::numeric_limits<double>::infinity();

  void look(const Vec3& centre, const Mat3& turned) {
    if (!looks) return;
    const double depth = depth_of(surface, body.at(centre, turned), ways);
    if (depth > deepest) deepest = depth, deepest_at = run->state().motion;
  }
  void see(const Motion& motion) {
    const double energy = kinetic_energy(motion, rock) + rock.mass * g * motion.position.z();
    gain = std::max(gain, energy - least_energy);
    least_energy = std::min(least_energy, energy);
  }
  void operator()(const event::Flight& flight) {
    const auto* phase = std::get_if<Tumbling>(&run->state().phase);
    if (phase == nullptr) return;
    const FreeRotation rotation(body.inertia, phase->orientation, phase->spin);
    constexpr int parts = 8;
    for (int k = 0; k <= parts && flight.duration > 1e-3; ++k) {
      const double t = flight.duration * k / parts;
      look(flight.path.at(t), rotation.turned_at(flight.before.time - phase->since + t).matrix);
    }
  }
  void operator()(const event::Leg& leg) {
    const auto* phase = std::get_if<Touching>(&run->state().phase);
    if (phase != nullptr) look(leg.after.position, phase->orientation.matrix());
    see(leg.before);
    see(leg.after);
    moments.push_back(leg.after);
  }
  void operator()(const event::Contact& contact) {
    if (contact.impact != nullptr) {
      rebounds.push_back(contact.impact->after);
      normals.push_back(contact.impact->normal);
    }
    see(contact.before);
    see(contact.after);
    moments.push_back(contact.after);
  }
  void operator()(const event::End& end) { moments.push_back(end.motion); }
};

template <class Surface>
struct Watched {
  Watcher<Surface> seen;
  RockOutcome outcome;
};
template <class Surface>
Watched<Surface> follow(const Surface& surface, const Soil& soil, const Laws& with, const RockShape& shape,
                        Release release, bool looks = false, std::vector<Vec3> ways = {unit_z}) {
  const Ground ground = ground_of(soil);
  release.shape = &shape;
  const Draws draws(SamplingPlan{}, 0);
  Watched<Surface> watched{{surface, std::move(ways), looks}, {}};
  watched.seen.body = body_of(shape, release.rock);
  watched.seen.rock = release.rock;
  RockRun<Surface, Watcher<Surface>> run({surface, ground, {}, with}, release, draws, watched.seen);
  watched.seen.run = &run;
  watched.outcome = run.follow();
  watched.seen.run = nullptr;
  return watched;
}

/// Of 2.7 t to the cubic metre.
Release release_of(double volume, const Vec3& centre, const Orientation& orientation = {}) {
  Release release;
  release.rock = sphere_of_mass(2700 * volume, 2700);
  release.orientation = orientation;
  release.motion.position = centre;
  return release;
}

/// Level ground with a pyramid on it: 0.4 m wide, its tip at (0, 0, 1).
Shape spike() {
  const double far = 20, half = 0.2;
  return {{{-far, -far, 0},
           {far, -far, 0},
           {far, far, 0},
           {-far, far, 0},
           {-half, -half, 0},
           {half, -half, 0},
           {half, half, 0},
           {-half, half, 0},
           {0, 0, 1}},
          {{4, 5, 8},
           {5, 6, 8},
           {6, 7, 8},
           {7, 4, 8},
           {0, 1, 5},
           {0, 5, 4},
           {1, 2, 6},
           {1, 6, 5},
           {2, 3, 7},
           {2, 7, 6},
           {3, 0, 4},
           {3, 4, 7}}};
}
/// A ridge along y at z = 1, from which the ground falls to both sides.
Shape roof() {
  const double far = 20, slope = 1.5;
  return {{{-far, -far, 1 - slope * far},
           {0, -far, 1},
           {far, -far, 1 - slope * far},
           {-far, far, 1 - slope * far},
           {0, far, 1},
           {far, far, 1 - slope * far}},
          {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}}};
}

// Without friction the impulse is up, through the tip: the box turns by what it does aside of the centre.
TEST(Ridges, ABoxFallsOnASpike) {
  const TriangleMesh ground = spike().mesh();
  const RockShape box = box_shape({1, 1, 1});
  const double mass = 2700, moment = mass / 6, fall = 2, rn = 0.4;
  for (const double aside : {0.0, 0.15, 0.4}) {
    const auto [seen, outcome] =
        follow(ground, {.rn = rn, .mu = 0, .rolling = 0}, laws(), box, release_of(1, {aside, 0, 1 + 0.5 + fall}));
    ASSERT_GE(seen.rebounds.size(), 1U);
    const double speed = std::sqrt(2 * g * fall), impulse = (1 + rn) * speed / (1 / mass + aside * aside / moment);
    EXPECT_NEAR(seen.rebounds[0].time, speed / g, 1e-7) << aside;
    EXPECT_NEAR(seen.rebounds[0].velocity.z(), impulse / mass - speed, 1e-6) << aside;
    EXPECT_NEAR((seen.normals[0] - unit_z).norm(), 0, 1e-6) << "of the face";
    // Its spin is that of the sphere of the same energy.
    const double spin = aside * impulse / moment;
    EXPECT_NEAR(std::abs(seen.rebounds[0].spin.y()), spin * std::sqrt(moment / seen.rock.inertia), 1e-5) << aside;
  }
}

// The weight turns the box with the lever of its centre from the tip, and rolling friction resists with mu_r r.
TEST(Ridges, ABoxBalancesOnASpikeOrTopples) {
  const TriangleMesh ground = spike().mesh();
  const RockShape box = box_shape({1, 1, 1});
  const double rolling = 0.2, held = rolling * sphere_of_mass(2700, 2700).radius;
  for (const double share : {0.0, 0.5, 0.9, 1.1}) {
    const Release release = release_of(1, {share * held, 0, 1.5 + 1e-6});
    const auto [seen, outcome] = follow(ground, {.rn = 0, .mu = 1, .rolling = rolling}, laws(), box, release, true,
                                        {unit_z, unit_x, -unit_x, unit_y, -unit_y});
    EXPECT_EQ(outcome.reason, EndReason::at_rest);
    const double moved = (outcome.end.position - release.motion.position).norm();
    EXPECT_LT(seen.deepest, 1e-3);
    if (share < 1) {
      EXPECT_LT(moved, 1e-4) << share;
    } else {
      EXPECT_GT(moved, 0.1) << share;
    }
  }
}

// A long box on one of its edges, across a roof's ridge: both edges touch where they cross.
TEST(Ridges, ALongBoxFallsAcrossARidge) {
  const TriangleMesh ground = roof().mesh();
  const RockShape box = box_shape({3, 0.6, 0.6});
  const Orientation on_edge = Orientation::of_turn({std::numbers::pi / 4, 0, 0});
  const double fall = 1, volume = 3 * 0.36, half = 0.3 * std::numbers::sqrt2, turn = 0.3;
  for (const double about_z : {0.0, turn}) {
    const Release release =
        release_of(volume, {0, 0.1, 1 + half + fall}, Orientation::of_turn({0, 0, about_z}) * on_edge);
    const auto [seen, outcome] = follow(ground, {.rn = 0.4, .mu = 0.5, .rolling = 0}, laws(), box, release);
    ASSERT_GE(seen.rebounds.size(), 1U);
    EXPECT_NEAR(seen.rebounds[0].time, std::sqrt(2 * fall / g), 1e-7);
    EXPECT_NEAR(seen.rebounds[0].velocity.z(), 0.4 * std::sqrt(2 * g * fall), 1e-6);
    EXPECT_LT(seen.rebounds[0].spin.norm(), 1e-6);
    EXPECT_NEAR((seen.normals[0] - unit_z).norm(), 0, 1e-6);
  }
}

/// A terrace above a lower one: a vertical step, or one that leans by `lean` [m].
std::vector<Vec2> step_section(double lean) { return {{-30, 6}, {0, 2}, {lean, 0}, {6, -1}, {7, -1.8}, {40, -4}}; }

Shape extruded(const std::vector<Vec2>& section, double half) {
  Shape shape;
  const auto count = static_cast<std::uint32_t>(section.size());
  for (const double y : {-half, half}) {
    for (const Vec2& p : section) shape.vertices.push_back({p.x(), y, p.y()});
  }
  for (std::uint32_t i = 0; i + 1 < count; ++i) {
    shape.triangles.push_back({i, i + 1, count + i + 1});
    shape.triangles.push_back({i, count + i + 1, count + i});
  }
  return shape;
}

// Random blocks fall and slide over the edges of steps, in section and in space. They sink in while they are on the
// ground, in steps of 2 ms, by as much as on a plane: 5 mm. (Without ridges the upper edge comes 0.9 m into a block.)
TEST(Ridges, BlocksStayOutOfSteps) {
  Dice dice(71);
  const std::vector<RockShape> in_section{section_shape(rectangle_outline(1)), section_shape(rectangle_outline(0.4)),
                                          section_shape(regular_outline(3))};
  const std::vector<RockShape> in_space{box_shape({1, 1, 1}), box_shape({1, 0.8, 0.3}),
                                        regular_shape(RegularSolid::tetrahedron)};
  std::vector<Vec3> around;
  for (int k = 0; k < 8; ++k) {
    const double angle = k * std::numbers::pi / 8;
    around.push_back({std::cos(angle), 0, std::sin(angle)});
  }
  constexpr double sunk_in_a_step = 5e-3;
  Laws with_section = laws(true), with_space = laws();
  with_section.timestep = with_space.timestep = 0.002;
  for (int k = 0; k < 40; ++k) {
    const std::vector<Vec2> section = step_section(dice.between(0.05, 0.6));
    const Soil soil{.rn = dice.between(0, 0.4), .mu = dice.between(0.2, 0.8), .rolling = 0};
    const double x = dice.between(-4, 1), volume = dice.between(0.5, 1.5);
    Release release = release_of(volume, {x, 0, 4.5});
    release.motion.velocity = {dice.between(0, 4), 0, 0};
    release.motion.spin = {0, dice.between(-3, 3), 0};
    release.orientation = Orientation::of_turn({0, dice.between(0, 3), 0});
    const Profile profile(section);
    const auto flat = follow(profile, soil, with_section, in_section[dice.below(3)], release, true, around);
    EXPECT_NE(flat.outcome.reason, EndReason::lost) << k;
    EXPECT_LT(flat.seen.gain, 1e-9 * release.rock.mass * g) << k;
    EXPECT_LT(flat.seen.deepest, sunk_in_a_step)
        << k << " at " << flat.seen.deepest_at.position << " t " << flat.seen.deepest_at.time;

    const TriangleMesh mesh = extruded(section, 20).mesh();
    release.orientation = Orientation::of_turn(dice.between(0, 3) * dice.direction());
    release.motion.spin = dice.in_cube(2);
    const auto solid = follow(mesh, soil, with_space, in_space[dice.below(3)], release, true, around);
    EXPECT_NE(solid.outcome.reason, EndReason::lost) << k;
    EXPECT_LT(solid.seen.gain, 1e-9 * release.rock.mass * g) << k;
    EXPECT_LT(solid.seen.deepest, sunk_in_a_step)
        << k << " at " << solid.seen.deepest_at.position << " t " << solid.seen.deepest_at.time;
  }
}

// The first touch in random falls on ground finer than the rocks: against distances from all facets, at times between
// which halving closes in on it.
template <class Surface>
void expect_first_touches(const Surface& surface, Dice& dice, double from, double to) {
  const std::vector<RockShape> shapes{box_shape({1, 1, 1}), box_shape({1, 0.7, 0.4}), ellipsoid_shape({1, 0.8, 0.6})};
  int on_ridges = 0;
  for (int k = 0; k < 150; ++k) {
    const RockShape& shape = shapes[dice.below(shapes.size())];
    Release release = release_of(dice.between(0.5, 4), {dice.between(from, to), dice.between(from, to), 0});
    release.motion.position.z() = *surface.elevation(release.motion.position.x(), release.motion.position.y()) + 3;
    release.orientation = Orientation::of_turn(dice.between(0, 3) * dice.direction());
    release.motion.velocity = {dice.between(-3, 3), dice.between(-3, 3), dice.between(-3, 0)};
    release.motion.spin = dice.in_cube(4);
    Laws with = laws();
    with.max_steps = 3;
    const auto [seen, outcome] = follow(surface, Soil{.rn = 0.3}, with, shape, release);
    ASSERT_GE(seen.rebounds.size(), 1U) << k;
    const double found = seen.rebounds[0].time;

    const FreeRotation rotation(seen.body.inertia, release.orientation, release.motion.spin);
    const Parabola path{release.motion.position, release.motion.velocity, with.gravity};
    const auto clear_at = [&](double t) {
      return is_clear(surface, seen.body.at(path.at(t), rotation.turned_at(t).matrix));
    };
    constexpr double step = 2e-3;
    double t = 0;
    while (t < 3 && clear_at(t + step)) t += step;
    double in = t + step;
    while (in - t > 1e-9) {
      const double middle = 0.5 * (t + in);
      (clear_at(middle) ? t : in) = middle;
    }
    EXPECT_NEAR(found, in, 1e-6) << k;
    // Whether all corners are still above the ground there.
    const Posture touching = seen.body.at(path.at(found), rotation.turned_at(found).matrix);
    double lowest = 1;
    for (std::size_t i = 0; i < touching.corners.size(); ++i) {
      const Vec3 place = touching.place(i);
      lowest = std::min(lowest, place.z() - *surface.elevation(place.x(), place.y()));
    }
    on_ridges += lowest > 1e-6 ? 1 : 0;
  }
  EXPECT_GT(on_ridges, 30);
}

TEST(Ridges, FirstTouchesAgreeWithDistancesOnAMesh) {
  Dice dice(72);
  const TriangleMesh mesh =
      irregular_field(dice, 60, 60, 15, 15, [&](double, double) { return dice.between(0, 0.3); }).mesh();
  expect_first_touches(mesh, dice, 5, 10);
}

TEST(Ridges, FirstTouchesAgreeWithDistancesOnARaster) {
  Dice dice(73);
  RasterGrid grid;
  grid.columns = grid.rows = 60;
  grid.dx = 0.25, grid.dy = 0.3;
  for (int k = 0; k < 60 * 60; ++k) grid.z.push_back(static_cast<float>(dice.between(0, 0.3)));
  expect_first_touches(RasterSurface(grid), dice, 5, 10);
}

// A prism that falls along a convex slope without turning out of its plane moves as its section does.
TEST(Ridges, ASectionIsItsPrism) {
  const std::vector<Vec2> section{{-20, 6}, {-1, 2}, {-0.2, 1.9}, {0.3, 1.5}, {1.2, 0.2}, {4, -1}, {30, -3}};
  const Profile profile(section);
  const TriangleMesh mesh = extruded(section, 20).mesh();
  const RockShape flat = section_shape(rectangle_outline(0.5)), solid = prism_shape(rectangle_outline(0.5));
  for (const double x : {-0.9, -0.3, 0.2}) {
    Laws with = laws(true);
    with.max_time = 2;
    Release release = release_of(1, {x, 0, 4});
    const Soil soil{.rn = 0.3, .mu = 0.5, .rolling = 0};
    const auto in_section = follow(profile, soil, with, flat, release);
    release.orientation = solid.as_given;
    const auto in_space = follow(mesh, soil, with, solid, release);
    ASSERT_GE(in_section.seen.rebounds.size(), 1U);
    ASSERT_GE(in_space.seen.rebounds.size(), 1U);
    EXPECT_NEAR(in_section.seen.rebounds[0].time, in_space.seen.rebounds[0].time, 1e-6) << x;
    EXPECT_NEAR((in_section.seen.rebounds[0].velocity - in_space.seen.rebounds[0].velocity).norm(), 0, 1e-5) << x;
    EXPECT_NEAR((in_section.outcome.end.position - in_space.outcome.end.position).norm(), 0, 1e-3) << x;
  }
}

// Over random ground finer than the rocks: energy never grows, none is lost, and they stay out of the ground.
template <class Surface>
void expect_watertight(const Surface& surface, Dice& dice, int rocks) {
  const std::vector<RockShape> shapes{box_shape({1, 1, 1}), box_shape({1, 0.9, 0.4}), box_shape({1, 0.5, 0.4}),
                                      ellipsoid_shape({1, 0.8, 0.6})};
  constexpr double sunk_in_a_step = 0.02;  // of 10 ms
  for (int k = 0; k < rocks; ++k) {
    const bool looks = k < 8;  // which takes time
    Release release = release_of(dice.between(0.3, 2), {dice.between(5, 10), dice.between(5, 10), 0});
    release.motion.position.z() = *surface.elevation(release.motion.position.x(), release.motion.position.y()) + 2;
    release.orientation = Orientation::of_turn(dice.between(0, 3) * dice.direction());
    release.motion.velocity = {dice.between(0, 3), dice.between(-1, 1), 0};
    release.motion.spin = dice.in_cube(3);
    const Soil soil{.rn = dice.between(0, 0.5), .mu = dice.between(0.2, 1.2), .rolling = 0.05};
    const auto [seen, outcome] = follow(surface, soil, laws(), shapes[dice.below(4)], release, looks);
    EXPECT_NE(outcome.reason, EndReason::lost) << k;
    EXPECT_NE(outcome.reason, EndReason::maximum_steps) << k;
    EXPECT_LT(seen.gain, 1e-9 * release.rock.mass * g) << k;
    EXPECT_LT(seen.deepest, sunk_in_a_step) << k << " at " << seen.deepest_at.position << " t " << seen.deepest_at.time;
  }
}

TEST(Ridges, RocksStayOutOfAFineMesh) {
  Dice dice(74);
  const TriangleMesh mesh =
      irregular_field(dice, 60, 60, 20, 15, [&](double x, double) { return -0.5 * x + dice.between(0, 0.3); }).mesh();
  expect_watertight(mesh, dice, 60);
}

TEST(Ridges, RocksStayOutOfAFineRaster) {
  Dice dice(75);
  RasterGrid grid;
  grid.columns = grid.rows = 80;
  grid.dx = grid.dy = 0.25;
  for (int j = 0; j < 80; ++j) {
    for (int i = 0; i < 80; ++i) grid.z.push_back(static_cast<float>(-0.125 * i + dice.between(0, 0.3)));
  }
  expect_watertight(RasterSurface(grid), dice, 60);
}

}  // namespace
}  // namespace talus::ridges_test
