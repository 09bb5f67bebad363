// Rocks carried by two facets: along straight valleys, past their ends and across borders of materials.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "support/meshes.hpp"
#include "support/scenes.hpp"
#include "talus/terrain/raster_surface.hpp"

namespace talus::valleys_test {
namespace {

using namespace testing_tools;

constexpr double g = standard_gravity;
const std::array both_methods{SlidingMethod::stepped, SlidingMethod::closed_form};

/// z = fall (length - x) + side |y|, on nodes `cell` apart.
struct Channel {
  double fall, side, cell;
  std::uint32_t columns = 40, half_rows = 4;

  [[nodiscard]] double height(double x, double y) const { return fall * (columns * cell - x) + side * std::abs(y); }
  [[nodiscard]] RasterSurface raster(double rounding = 0) const {
    RasterGrid grid;
    grid.columns = columns + 1;
    grid.rows = 2 * half_rows + 1;
    grid.dx = grid.dy = cell;
    grid.y0 = -cell * half_rows;
    for (std::uint32_t j = 0; j < grid.rows; ++j) {
      for (std::uint32_t i = 0; i < grid.columns; ++i) {
        const double z = height(i * cell, grid.y0 + j * cell);
        grid.z.push_back(static_cast<float>(rounding > 0 ? std::round(z / rounding) * rounding : z));
      }
    }
    return RasterSurface(grid);
  }
  [[nodiscard]] TriangleMesh mesh() const {
    return net(
               columns, 2 * half_rows,
               [&](std::uint32_t i, std::uint32_t j) {
                 const double x = i * cell, y = (static_cast<double>(j) - half_rows) * cell;
                 return Vec3(x, y, height(x, y));
               },
               [](std::uint32_t, std::uint32_t) { return true; })
        .mesh();
  }
  /// Gravity along the bottom.
  [[nodiscard]] double pull() const { return g * fall / std::sqrt(1 + fall * fall); }
  /// The normal acceleration of one side; both are equal, by symmetry.
  [[nodiscard]] double pressure() const {
    return 0.5 * g * std::sqrt(1 + fall * fall + side * side) / (1 + fall * fall);
  }
};

Motion at_rest_in(const Channel& channel, double x) { return {{x, 0, channel.height(x, 0)}, Vec3{}}; }

Soil slippery(double mu) {
  Soil soil;
  soil.rn = 0.2;
  soil.phi = std::atan(mu);
  return soil;
}

/// The material of each facet: the second if `is_second` is true for its middle, else the first.
template <class Surface, class IsSecond>
Ground two_grounds(const Surface& surface, double first, double second, const IsSecond& is_second) {
  std::vector<std::uint8_t> of_facet(surface.facet_count());
  for (std::uint32_t k = 0; k < surface.facet_count(); ++k) {
    const Outline outline = surface.outline(FacetId{k});
    Vec3 middle;
    for (int e = 0; e < 3; ++e) middle += outline.edges[static_cast<std::size_t>(e)].point / 3;
    of_facet[surface.source(FacetId{k})] = is_second(middle) ? 1 : 0;
  }
  return Ground({material_of(slippery(first)), material_of(slippery(second))}, of_facet);
}

// Elevations in single precision bend the bottom slightly at every node.
TEST(Valleys, OnARasterAreSlidThroughToTheirEnd) {
  constexpr double mu = 0.07;
  for (const Channel& channel : {Channel{0.36, 1, 10}, Channel{0.30, 0.7, 1}, Channel{0.31, 0.83, 5}}) {
    const RasterSurface surface = channel.raster();
    for (const SlidingMethod sliding : both_methods) {
      for (const double grazing : {0.1, 1.0}) {
        Laws laws;
        laws.sliding = sliding;
        laws.timestep = 0.002;
        laws.grazing = grazing * std::numbers::pi / 180;
        const double start = 0.4 * channel.cell,
                     length = 39.6 * channel.cell * std::sqrt(1 + channel.fall * channel.fall);
        const Motion at_rest{{start, 0, *surface.elevation(start, 0)}, Vec3{}};
        const Followed path = follow(surface, ground_of(slippery(mu)), laws, {at_rest, sphere_of_diameter(1.0, 2700)});
        ASSERT_EQ(path.outcome.reason, EndReason::left_model) << channel.cell;
        const double speed = std::sqrt(2 * (channel.pull() - 2 * mu * channel.pressure()) * length);
        // In the first step of a stepped slide the rock already has the speed of its end.
        EXPECT_NEAR(path.outcome.end.velocity.norm(), speed, 0.005 * speed) << channel.cell;
      }
    }
  }
}

TEST(Valleys, OfRoundedElevationsDoNotStopRocks) {
  const Channel channel{0.37, 0.61, 5};
  const RasterSurface surface = channel.raster(0.1);
  for (std::uint64_t rock = 0; rock < 50; ++rock) {
    const double y = -9 + 18 * static_cast<double>(rock) / 49;
    const Motion start{{3, y, channel.height(3, y) + 1}, Vec3(1, 0, 0)};
    const Followed path = follow(surface, ground_of(slippery(0.07)), Laws{}, {start, sphere_of_diameter(1.0, 2700)});
    EXPECT_EQ(path.outcome.reason, EndReason::left_model) << y;
  }
}

TEST(Valleys, BetweenTwoMaterialsHaveTheFrictionOfBothSides) {
  const Channel channel{0.36, 1, 10};
  const TriangleMesh surface = channel.mesh();
  constexpr double left = 0.035, right = 0.25;
  const Ground ground = two_grounds(surface, left, right, [](const Vec3& middle) { return middle.y() < 0; });
  const double speed = std::sqrt(2 * (channel.pull() - (left + right) * channel.pressure()) * 396 *
                                 std::sqrt(1 + channel.fall * channel.fall));
  Laws laws;
  laws.sliding = SlidingMethod::closed_form;
  for (const double y : {-1e-6, 1e-6}) {  // it reaches the bottom from either side
    Motion start = at_rest_in(channel, 4);
    start.position += Vec3(0, y, channel.side * std::abs(y));
    const Followed path = follow(surface, ground, laws, {start, sphere_of_diameter(1.0, 2700)});
    EXPECT_EQ(path.outcome.reason, EndReason::left_model);
    EXPECT_NEAR(path.outcome.end.velocity.norm(), speed, 1e-6 * speed);  // it starts 1e-6 m beside the bottom
  }
}

TEST(Valleys, ChangeTheirFrictionWhereTheirMaterialChanges) {
  const Channel channel{0.36, 1, 10};
  const TriangleMesh surface = channel.mesh();
  constexpr double smooth = 0.07, harsh = 0.58;
  const Ground ground = two_grounds(surface, smooth, harsh, [](const Vec3& middle) { return middle.x() > 200; });
  const double slope = std::sqrt(1 + channel.fall * channel.fall);
  const double gain = channel.pull() - 2 * smooth * channel.pressure(),
               loss = 2 * harsh * channel.pressure() - channel.pull();
  ASSERT_GT(loss, 0);
  const double stops_at = 200 + 196 * gain / loss;
  Laws laws;
  laws.sliding = SlidingMethod::closed_form;
  const Rock rock = sphere_of_diameter(1.0, 2700);
  const Followed path = follow(surface, ground, laws, {at_rest_in(channel, 4), rock});
  EXPECT_EQ(path.outcome.reason, EndReason::at_rest);
  EXPECT_NEAR(path.outcome.end.position.x(), stops_at, 1e-6);
  const double maximum = rock.mass * gain * 196 * slope;
  EXPECT_NEAR(path.outcome.max_kinetic_energy, maximum, 1e-6 * maximum);
}

TEST(MaxKineticEnergy, CanBeAtABorderOfMaterialsWithinAPlane) {
  const Channel plane{0.5, 0, 10};
  const TriangleMesh surface = plane.mesh();
  const Ground ground = two_grounds(surface, 0.09, 1, [](const Vec3& middle) { return middle.x() > 200; });
  const double slope = std::sqrt(1.25), gain = g * (0.5 - 0.09) / slope;
  const Rock rock = sphere_of_diameter(1.0, 2700);
  Laws laws;
  laws.sliding = SlidingMethod::closed_form;
  const Followed path = follow(surface, ground, laws, {at_rest_in(plane, 4), rock});
  EXPECT_EQ(path.outcome.reason, EndReason::at_rest);
  EXPECT_NEAR(path.outcome.max_kinetic_energy, rock.mass * gain * 196 * slope, 1e-6 * rock.mass * gain * 196 * slope);
}

// Ground that falls towards +x and more gently towards -y, where a low step up to x = 10 holds a sphere.
TEST(Valleys, AStepHoldsASphereOnlyUpToItsEnd) {
  const auto floor = [](double x, double y) { return -0.3 * x + 0.1 * y; };
  Shape shape;
  const auto add = [&](std::array<Vec3, 4> corners) {
    const auto first = static_cast<std::uint32_t>(shape.vertices.size());
    for (const Vec3& corner : corners) shape.vertices.push_back(corner);
    shape.triangles.push_back({first, first + 1, first + 2});
    shape.triangles.push_back({first, first + 2, first + 3});
  };
  const auto at = [&](double x, double y, double above = 0) { return Vec3(x, y, floor(x, y) + above); };
  constexpr double step = 0.4;
  add({at(-5, 0), at(10, 0), at(10, 20), at(-5, 20)});
  add({at(10, -20), at(40, -20), at(40, 0), at(10, 0)});
  add({at(10, 0), at(40, 0), at(40, 20), at(10, 20)});
  add({at(-5, -20, step), at(10, -20, step), at(10, 0, step), at(-5, 0, step)});
  add({at(-5, 0, step), at(10, 0, step), at(10, 0), at(-5, 0)});
  add({at(10, 0, step), at(10, -20, step), at(10, -20), at(10, 0)});
  Shape welded;
  for (const auto& triangle : shape.triangles) {
    TriangleMesh::Corners corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& v = shape.vertices[triangle[k]];
      std::uint32_t n = 0;
      while (n < welded.vertices.size() && (welded.vertices[n] - v).norm() > 1e-9) ++n;
      if (n == welded.vertices.size()) welded.vertices.push_back(v);
      corners[k] = n;
    }
    welded.triangles.push_back(corners);
  }
  const TriangleMesh surface = welded.mesh();
  Soil soil;
  soil.rn = 0;
  soil.rt = 1;
  soil.rolling = 0.01;
  const Rock rock = sphere_of_diameter(1.0, 2700);
  Laws laws;
  set_model(laws, RockModel::rigid_sphere);
  const Followed path = follow(surface, ground_of(soil), laws, {{at(0, 0.55, 0.53), Vec3{}, Vec3{}}, rock});
  double held = 0;
  for (const PathPiece& piece : path.log.pieces) {
    const Vec3& p = piece.path.p;
    if (p.x() > 5 && p.x() < 9.5) held = std::max(held, std::abs(p.y() - 0.49));
  }
  // The sphere of radius 0.5 touches the floor and the edge of the step, 0.4 high: its centre moves along y = 0.49.
  EXPECT_LT(held, 0.05);  // the floor is inclined: at right angles to it, the edge is lower
  EXPECT_LT(path.outcome.end.position.y(), -2) << "beyond the step it turns down the slope";
}

}  // namespace
}  // namespace talus::valleys_test
