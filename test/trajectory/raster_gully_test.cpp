// Rocks in a gully of a raster, in eight directions: they run as far along the diagonals as along rows and columns.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "support/scenes.hpp"
#include "talus/terrain/raster_surface.hpp"

namespace talus::raster_gully_test {
namespace {

using namespace testing_tools;

/// A straight gully with plane sides, through the origin.
struct Gully {
  int eighth;  // of a turn: the direction in which it falls
  double fall, side, cell;
  std::uint32_t half = 40;  // cells to each side

  [[nodiscard]] Vec2 along() const {
    const double angle = eighth * std::numbers::pi / 4;
    return {std::cos(angle), std::sin(angle)};
  }
  [[nodiscard]] double way(const Vec3& p) const { return along().dot(p.xy()); }
  [[nodiscard]] double height(double x, double y) const {
    const Vec2 d = along();
    return side * std::abs(d.x() * y - d.y() * x) - fall * (d.x() * x + d.y() * y);
  }
  [[nodiscard]] RasterSurface raster() const {
    RasterGrid grid;
    grid.columns = grid.rows = 2 * half + 1;
    grid.dx = grid.dy = cell;
    grid.x0 = grid.y0 = -cell * half;
    for (std::uint32_t j = 0; j < grid.rows; ++j) {
      for (std::uint32_t i = 0; i < grid.columns; ++i) {
        grid.z.push_back(static_cast<float>(height(grid.x0 + i * cell, grid.y0 + j * cell)));
      }
    }
    return RasterSurface(std::move(grid));
  }
  /// A place over the bottom, and a velocity along it.
  [[nodiscard]] Motion moving(double from, double above, double speed) const {
    const Vec2 plan = from * along();
    Motion motion;
    motion.position = {plan.x(), plan.y(), height(plan.x(), plan.y()) + above};
    motion.velocity = speed * Vec3(along().x(), along().y(), -fall).normalized();
    return motion;
  }
};

// A mass slides in the bottom on both sides until friction has stopped it.
TEST(RasterGully, AMassSlidesAsFarInEightDirections) {
  constexpr double speed = 15, mu = 0.4;
  for (const double fall : {0.05, 0.2, 0.35}) {
    for (const double side : {0.3, 1.0}) {
      const double slant = 1 + fall * fall;
      const double drag = standard_gravity * (mu * std::sqrt(slant + side * side) / slant - fall / std::sqrt(slant));
      const double expected = speed * speed / (2 * drag) / std::sqrt(slant);
      for (int eighth = 0; eighth < 8; ++eighth) {
        const Gully gully{eighth, fall, side, 2, 70};
        const RasterSurface raster = gully.raster();
        Soil soil;
        soil.rt = 1;
        soil.phi = std::atan(mu);
        Laws laws;
        set_model(laws, RockModel::lumped_mass, false);  // at its release it loses nothing
        Release release;
        release.rock = sphere_of_mass(100, 2700);
        release.motion = gully.moving(-70, 0, speed);
        double& z = release.motion.position.z();
        z = raster.elevation(release.motion.position.x(), release.motion.position.y()).value();
        const Followed path = follow(raster, ground_of(soil), laws, release);
        EXPECT_EQ(path.outcome.reason, EndReason::at_rest);
        constexpr double half_step = 0.075;  // [m]
        EXPECT_NEAR(gully.way(path.outcome.end.position) + 70, expected, half_step + 0.01)
            << eighth << " eighths, fall " << fall << ", side " << side;
      }
    }
  }
}

// Rocks that bounce from side to side: means of many, apart by no more than chance.
TEST(RasterGully, RocksRunAsFarInEightDirections) {
  constexpr int rocks = 300;
  for (const RockModel model : {RockModel::lumped_mass, RockModel::rigid_sphere}) {
    Laws laws;
    set_model(laws, model);
    std::array<double, 8> mean{}, error{};
    for (int eighth = 0; eighth < 8; ++eighth) {
      const Gully gully{eighth, 0.15, 0.8, 2, 70};
      const RasterSurface raster = gully.raster();
      Soil soil;
      soil.rn = 0.3;
      soil.phi = std::atan(0.6);
      soil.mu = 0.6;
      soil.rolling = 0.5;
      soil.roughness = 0.08;
      double sum = 0, squares = 0;
      int left = 0;
      for (int k = 0; k < rocks; ++k) {
        Release release;
        release.rock = sphere_of_mass(100, 2700);
        release.motion = gully.moving(-40, 3, 12);
        const Followed path =
            follow(raster, ground_of(soil), laws, release, {}, static_cast<std::uint64_t>(eighth * rocks + k));
        left += path.outcome.reason == EndReason::at_rest ? 0 : 1;
        const double run = gully.way(path.outcome.end.position) + 40;
        sum += run;
        squares += run * run;
      }
      const auto i = static_cast<std::size_t>(eighth);
      mean[i] = sum / rocks;
      error[i] = std::sqrt(std::max(0.0, squares / rocks - mean[i] * mean[i]) / rocks);
      EXPECT_EQ(left, 0) << i << " eighths";
      EXPECT_GT(mean[i], 10);
    }
    for (std::size_t i = 1; i < 8; ++i) {
      EXPECT_NEAR(mean[i], mean[0], 4 * std::hypot(error[i], error[0])) << i << " eighths, " << error[i];
    }
  }
}

}  // namespace
}  // namespace talus::raster_gully_test
