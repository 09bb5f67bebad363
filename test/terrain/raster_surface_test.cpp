// A raster has the same contacts as the mesh of its triangles.

#include "talus/terrain/raster_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "support/dice.hpp"
#include "support/meshes.hpp"
#include "support/scenes.hpp"

namespace talus::raster_surface_test {
namespace {

using namespace testing_tools;

constexpr float none = std::numeric_limits<float>::quiet_NaN();

RasterGrid random_grid(Dice& dice, std::uint32_t columns, std::uint32_t rows, double grade, double relief) {
  RasterGrid grid;
  grid.columns = columns;
  grid.rows = rows;
  grid.x0 = dice.between(-100, 100);
  grid.y0 = dice.between(-100, 100);
  grid.dx = dice.between(0.5, 2);
  grid.dy = dice.between(0.5, 2);
  for (std::uint32_t j = 0; j < rows; ++j) {
    for (std::uint32_t i = 0; i < columns; ++i) {
      grid.z.push_back(static_cast<float>(-grade * i * grid.dx + dice.between(-relief, relief)));
    }
  }
  return grid;
}

// The mesh of all facets: facet i of the raster is triangle i of the mesh.
TriangleMesh mesh_of(const RasterSurface& raster) {
  const RasterGrid& grid = raster.grid();
  Shape shape = net(
      grid.columns - 1, grid.rows - 1,
      [&](std::uint32_t i, std::uint32_t j) {
        return Vec3(grid.x0 + i * grid.dx, grid.y0 + j * grid.dy, static_cast<double>(grid.z[grid.index(i, j)]));
      },
      [&](std::uint32_t i, std::uint32_t j) { return raster.is_cut_north_east(i, j); });
  return shape.mesh();
}

struct Ground {
  RasterSurface raster;
  TriangleMesh mesh;
  Box box;
};

Ground random_ground(Dice& dice) {
  const double grade = dice.between(0, 1.2), relief = dice.magnitude(0.01, 2);
  RasterSurface raster(random_grid(dice, 12, 9, grade, relief));
  const Box box = raster.bounds();
  TriangleMesh mesh = mesh_of(raster);
  return {std::move(raster), std::move(mesh), box};
}

Parabola random_flight(Dice& dice, const Box& box, double radius) {
  const Vec3 size = box.high - box.low;
  const Vec3 p(box.low.x() + dice.between(0.05, 0.95) * size.x(), box.low.y() + dice.between(0.05, 0.95) * size.y(),
               box.high.z() + 1.5 * radius + dice.between(0, 3));
  Vec3 v = dice.direction();
  v *= dice.between(0, 12);
  if (dice.chance(0.1)) v.x() = 0;
  if (dice.chance(0.1)) v.y() = 0;
  return {p, v, {0, 0, -9.81}};
}

void expect_same(const std::optional<Contact>& raster, const std::optional<Contact>& mesh) {
  ASSERT_EQ(raster.has_value(), mesh.has_value());
  if (!raster) return;
  ASSERT_NEAR(raster->t, mesh->t, 1e-9);
  ASSERT_LT((raster->normal - mesh->normal).norm(), 1e-6);
}

TEST(RasterSurface, HasTheContactsOfAPointOnTheMesh) {
  Dice dice(201);
  int met = 0;
  for (int k = 0; k < 100; ++k) {
    const Ground ground = random_ground(dice);
    for (int i = 0; i < 200; ++i) {
      const Parabola path = random_flight(dice, ground.box, 0);
      const auto contact = ground.raster.first_contact(path, 0, 100);
      expect_same(contact, ground.mesh.first_contact(path, 0, 100));
      if (contact) {
        ++met;
        // And the next contact, after a bounce.
        Vec3 v = path.velocity(contact->t);
        v -= 1.5 * v.dot(contact->normal) * contact->normal;
        const Parabola next{path.at(contact->t), v, path.a};
        expect_same(ground.raster.first_contact(next, 0, 100), ground.mesh.first_contact(next, 0, 100));
      }
      if (HasFatalFailure()) return;
    }
  }
  EXPECT_GT(met, 10'000);
}

TEST(RasterSurface, HasTheContactsOfASphereOnTheMesh) {
  Dice dice(202);
  std::array<int, 3> met{};
  for (int k = 0; k < 60; ++k) {
    const Ground ground = random_ground(dice);
    for (int i = 0; i < 100; ++i) {
      const double radius = dice.magnitude(0.05, 3);
      const Parabola path = random_flight(dice, ground.box, radius);
      const auto contact = ground.raster.first_contact(path, radius, 100);
      expect_same(contact, ground.mesh.first_contact(path, radius, 100));
      if (contact) {
        ++met[static_cast<std::size_t>(contact->feature)];
        Vec3 v = path.velocity(contact->t);
        v -= 1.3 * v.dot(contact->normal) * contact->normal;
        const Parabola next{path.at(contact->t), v, path.a};
        expect_same(ground.raster.first_contact(next, radius, 100), ground.mesh.first_contact(next, radius, 100));
        const Parabola leg{path.at(contact->t), tangential(v, contact->normal), Vec3{}};
        const SupportPlanes on(contact->normal);
        expect_same(ground.raster.first_contact_on_leg(leg, radius, 0.1, on),
                    ground.mesh.first_contact_on_leg(leg, radius, 0.1, on));
      }
      if (HasFatalFailure()) return;
    }
  }
  for (const int each : met) EXPECT_GT(each, 50);
}

// Among cells much smaller than the sphere its path is searched in parts of many cells.
TEST(RasterSurface, HasTheContactsOfALargeSphereOnTheMesh) {
  Dice dice(206);
  int met = 0;
  for (int k = 0; k < 60; ++k) {
    const Ground ground = random_ground(dice);
    for (int i = 0; i < 40; ++i) {
      const double radius = dice.magnitude(20, 2000);
      const Parabola path = random_flight(dice, ground.box, radius);
      const auto contact = ground.raster.first_contact(path, radius, 100);
      expect_same(contact, ground.mesh.first_contact(path, radius, 100));
      met += contact ? 1 : 0;
      if (HasFatalFailure()) return;
    }
  }
  EXPECT_GT(met, 1000);
}

// On ground so smooth that neighbouring facets are nearly one plane, where a bouncing or rolling sphere is close to
// many of them at the same time.
TEST(RasterSurface, ASphereBouncesDownSmoothGroundAsOnTheMesh) {
  Dice dice(205);
  std::array<int, 3> met{};
  for (int k = 0; k < 40; ++k) {
    const double roughness = dice.magnitude(1e-3, 0.3), wave = dice.between(3, 20);
    RasterGrid grid = random_grid(dice, 40, 40, dice.between(0.3, 1), roughness);
    for (std::uint32_t j = 0; j < grid.rows; ++j) {
      for (std::uint32_t i = 0; i < grid.columns; ++i) {
        grid.z[grid.index(i, j)] += static_cast<float>(0.1 * wave * std::sin(i / wave) * std::cos(j / wave));
      }
    }
    const RasterSurface raster(std::move(grid));
    const TriangleMesh mesh = mesh_of(raster);
    for (int i = 0; i < 60; ++i) {
      const double radius = dice.magnitude(0.05, 1.5);
      Parabola path = random_flight(dice, raster.bounds(), radius);
      for (int bounce = 0; bounce < 20; ++bounce) {
        const double known = dice.chance(0.5) ? 0 : dice.between(0, 5);
        const auto [contact, highest] = raster.flight(path, radius, 100, {}, known);
        expect_same(contact, mesh.first_contact(path, radius, 100));
        if (HasFatalFailure()) return;
        if (!contact) break;
        ASSERT_EQ(highest, raster.max_height(path, contact->t, known));
        ++met[static_cast<std::size_t>(contact->feature)];
        const Vec3& n = contact->normal;
        const Vec3 place = path.at(contact->t), arriving = path.velocity(contact->t);
        if (arriving.dot(n) > -0.05) break;  // the times of endless small bounces are rounding
        const Vec3 along = 0.9 * tangential(arriving, n);
        const Parabola leg{place, along, 0.5 * tangential(path.a, n)};
        expect_same(raster.first_contact_on_leg(leg, radius, 0.05, SupportPlanes(n)),
                    mesh.first_contact_on_leg(leg, radius, 0.05, SupportPlanes(n)));
        if (HasFatalFailure()) return;
        path = {place, along - 0.5 * arriving.dot(n) * n, path.a};
      }
    }
  }
  EXPECT_GT(met[0], 2000);
  EXPECT_GT(met[1], 100);
}

TEST(RasterSurface, HasTheHeightsOutlinesAndExitsOfTheMesh) {
  Dice dice(203);
  for (int k = 0; k < 50; ++k) {
    const Ground ground = random_ground(dice);
    std::vector<std::uint32_t> place(ground.mesh.facet_count());
    for (std::uint32_t f = 0; f < place.size(); ++f) place[ground.mesh.source({f})] = f;
    ASSERT_EQ(ground.raster.facet_count(), ground.mesh.facet_count());
    for (std::uint32_t f = 0; f < place.size(); ++f) {
      const Outline a = ground.raster.outline({f}), b = ground.mesh.outline({place[f]});
      ASSERT_LT((a.normal - b.normal).norm(), 1e-12);
      for (std::size_t c = 0; c < 3; ++c) {
        ASSERT_LT((a.edges[c].point - b.edges[c].point).norm(), 1e-12);
        ASSERT_EQ(a.edges[c].beyond.has_value(), b.edges[c].beyond.has_value());
        if (!a.edges[c].beyond) continue;
        ASSERT_EQ(a.edges[c].beyond->index, ground.mesh.source(*b.edges[c].beyond));
      }
    }
    for (int i = 0; i < 100; ++i) {
      const Parabola path = random_flight(dice, ground.box, 0);
      const auto here = ground.raster.elevation(path.p.x(), path.p.y());
      ASSERT_NEAR(here.value(), ground.mesh.elevation(path.p.x(), path.p.y()).value(), 1e-9);
      const double t_end = dice.between(0.1, 2);
      ASSERT_NEAR(ground.raster.max_height(path, t_end, 0), ground.mesh.max_height(path, t_end, 0), 1e-9);
      const double known = dice.chance(0.5) ? 0 : dice.between(0, 5), radius = dice.magnitude(0.05, 1.5);
      const Parabola of_sphere = random_flight(dice, ground.box, radius);
      if (const auto sphere = ground.raster.flight(of_sphere, radius, 100, {}, known); sphere.contact) {
        ASSERT_EQ(sphere.max_height, ground.raster.max_height(of_sphere, sphere.contact->t, known));
      }
      const auto [contact, highest] = ground.raster.flight(path, 0, 100, {}, known);
      if (contact) {
        ASSERT_EQ(highest, ground.raster.max_height(path, contact->t, known));
        continue;
      }
      const Exit a = ground.raster.exit(path), b = ground.mesh.exit(path);
      ASSERT_NEAR(a.t, b.t, 1e-9);
      ASSERT_EQ(a.beneath, b.beneath);
      ASSERT_FALSE(a.in_hole);
    }
    const Vec3 size = ground.box.high - ground.box.low;
    const Vec2 from(ground.box.low.x() + 0.1 * size.x(), ground.box.low.y() + 0.2 * size.y());
    const Vec2 to(ground.box.low.x() + 0.8 * size.x(), ground.box.low.y() + 0.9 * size.y());
    const auto a = ground.raster.draped(from, to), b = ground.mesh.draped(from, to);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) ASSERT_LT((a[i] - b[i]).norm(), 1e-6);
  }
}

// Whole paths on both, as long as rounding has not grown.
TEST(RasterSurface, RocksFollowTheSamePathAsOnTheMesh) {
  Dice dice(204);
  int compared = 0;
  for (int k = 0; k < 40; ++k) {
    const Ground ground = random_ground(dice);
    for (const RockModel model : {RockModel::lumped_mass, RockModel::rigid_sphere}) {
      Laws laws;
      set_model(laws, model);
      Soil soil;
      soil.rn = 0.3;
      Release release;
      release.rock = sphere_of_diameter(0.4, 2700);
      release.motion.position = random_flight(dice, ground.box, 0.2).p;
      release.motion.velocity = {dice.between(0, 3), dice.between(-1, 1), 0};
      const Followed a = follow(ground.raster, ground_of(soil), laws, release);
      const Followed b = follow(ground.mesh, ground_of(soil), laws, release);
      const std::size_t rows = std::min<std::size_t>({a.log.rows.size(), b.log.rows.size(), 8});
      if (rows >= 4) ++compared;
      for (std::size_t i = 0; i < rows; ++i) {
        ASSERT_EQ(a.log.rows[i].state, b.log.rows[i].state);
        ASSERT_LT((a.log.rows[i].motion.position - b.log.rows[i].motion.position).norm(), 1e-6);
      }
      ASSERT_NE(a.outcome.reason, EndReason::lost);
    }
  }
  EXPECT_GT(compared, 40);  // of 80; the others leave the model after one or two impacts
}

// ---- holes ----

// Flat ground with a hole of four cells around the node (5, 5).
RasterSurface holed_plain() {
  RasterGrid grid;
  grid.columns = grid.rows = 11;
  grid.z.assign(121, 0.0F);
  grid.z[grid.index(5, 5)] = none;
  return RasterSurface(grid);
}

TEST(RasterSurface, ARockThatFallsIntoAHoleEndsAtItsRim) {
  const RasterSurface plain = holed_plain();
  const Parabola path{{2, 5, 1}, {2, 0, 0}, {0, 0, -1}};  // at z = 0 at x = 4.83, beyond the rim at x = 4
  EXPECT_FALSE(plain.first_contact(path, 0, 100));
  const Exit exit = plain.exit(path);
  EXPECT_DOUBLE_EQ(exit.t, 1);
  EXPECT_TRUE(exit.in_hole);
  EXPECT_FALSE(exit.beneath);
}

TEST(RasterSurface, ARockMayFlyOverAHole) {
  const RasterSurface plain = holed_plain();
  const Parabola path{{2, 5, 1}, {4, 0, 0}, {0, 0, -1}};  // lands at x = 7.66
  const auto contact = plain.first_contact(path, 0, 100);
  ASSERT_TRUE(contact);
  EXPECT_DOUBLE_EQ(contact->t, std::sqrt(2.0));
}

TEST(RasterSurface, ARockThatFliesOverAHoleAndOutLeavesTheModel) {
  const RasterSurface plain = holed_plain();
  const Exit exit = plain.exit({{2, 5, 1}, {20, 0, 0}, {0, 0, -1}});
  EXPECT_DOUBLE_EQ(exit.t, 0.4);
  EXPECT_FALSE(exit.in_hole);
}

TEST(RasterSurface, ARockThatRollsIntoAHoleEndsThere) {
  const RasterSurface plain = holed_plain();
  for (const RockModel model : {RockModel::lumped_mass, RockModel::rigid_sphere}) {
    Laws laws;
    set_model(laws, model);
    Release release;
    release.rock = sphere_of_diameter(0.4, 2700);
    release.motion.position = {1, 5, model == RockModel::rigid_sphere ? 0.2 : 0};
    release.motion.velocity = {10, 0, 0};
    const Followed path = follow(plain, ground_of({}), laws, release);
    EXPECT_EQ(path.outcome.reason, EndReason::no_data);
    EXPECT_NEAR(path.outcome.end.position.x(), 4, 1e-6);
  }
}

TEST(RasterSurface, AHoleHasNoGround) {
  const RasterSurface plain = holed_plain();
  EXPECT_FALSE(plain.elevation(4.5, 4.5));
  EXPECT_TRUE(plain.elevation(3.5, 4.5));
  EXPECT_FALSE(plain.has_data(4, 5));
  EXPECT_TRUE(plain.has_data(6, 5));
}

}  // namespace
}  // namespace talus::raster_surface_test
