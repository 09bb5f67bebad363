// Which rasters are recognized as interpolated or rounded.

#include "talus/model/coarse_raster.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "support/dice.hpp"

namespace talus::project {
namespace {

using testing_tools::Dice;

RasterGrid sampled(std::uint32_t columns, std::uint32_t rows, double cell,
                   const std::function<double(double x, double y)>& ground) {
  RasterGrid grid{.columns = columns, .rows = rows, .dx = cell, .dy = cell};
  for (std::uint32_t j = 0; j < rows; ++j) {
    for (std::uint32_t i = 0; i < columns; ++i) grid.z.push_back(static_cast<float>(ground(i * cell, j * cell)));
  }
  return grid;
}

/// A slope with bumps of 2 to 60 cells in size, at places, of sizes and of heights by chance.
RasterGrid measured(std::uint32_t columns, std::uint32_t rows, double cell) {
  Dice dice(31);
  RasterGrid grid = sampled(columns, rows, cell, [](double x, double y) { return 150 - 0.6 * x + 0.1 * y; });
  for (std::uint32_t bumps = 0; bumps < columns * rows / 8; ++bumps) {
    const double size = dice.magnitude(2, 60), x = dice.between(0, columns), y = dice.between(0, rows);
    // Most are small: as many as would cover the ground once for each doubling of their size.
    if (!dice.chance(4 / (size * size))) continue;
    const double height = dice.between(-0.1, 0.1) * size * cell;
    const auto within = [&](double middle, std::uint32_t count) {
      return std::pair(static_cast<std::uint32_t>(std::max(0.0, middle - 2 * size)),
                       static_cast<std::uint32_t>(std::min<double>(count, middle + 2 * size)));
    };
    const auto [west, east] = within(x, columns);
    const auto [south, north] = within(y, rows);
    for (std::uint32_t j = south; j < north; ++j) {
      for (std::uint32_t i = west; i < east; ++i) {
        const double squared = ((i - x) * (i - x) + (j - y) * (j - y)) / (size * size);
        grid.z[grid.index(i, j)] += static_cast<float>(height * std::exp(-2 * squared));
      }
    }
  }
  for (float& z : grid.z) z += static_cast<float>(dice.between(-0.02, 0.02) * cell);
  return grid;
}

using Kernel = double (*)(double);

double nearest(double t) { return t >= -0.5 && t < 0.5 ? 1 : 0; }
double bilinear(double t) { return std::max(0.0, 1 - std::abs(t)); }
double cubic(double t) {
  const double s = std::abs(t);
  return s < 1 ? 1.5 * s * s * s - 2.5 * s * s + 1 : s < 2 ? -0.5 * s * s * s + 2.5 * s * s - 4 * s + 2 : 0;
}
double cubic_spline(double t) {
  const double s = std::abs(t);
  return s < 1 ? 0.5 * s * s * s - s * s + 2.0 / 3 : s < 2 ? (2 - s) * (2 - s) * (2 - s) / 6 : 0;
}

/// On smaller cells with the same edges, as programs resample rasters.
RasterGrid interpolated(const RasterGrid& from, double ratio, Kernel kernel) {
  const auto count = [&](std::uint32_t nodes) { return static_cast<std::uint32_t>(nodes * ratio); };
  const auto place = [&](double node) { return (node + 0.5) / ratio - 0.5; };
  const auto bounded = [](double node, std::uint32_t nodes) {
    return static_cast<std::uint32_t>(std::clamp(node, 0.0, nodes - 1.0));
  };
  return sampled(count(from.columns), count(from.rows), from.dx / ratio, [&](double x, double y) {
    const double u = place(x * ratio / from.dx), v = place(y * ratio / from.dx);
    double z = 0;
    for (double j = std::floor(v) - 1; j <= std::floor(v) + 2; ++j) {
      for (double i = std::floor(u) - 1; i <= std::floor(u) + 2; ++i) {
        const double weight = kernel(u - i) * kernel(v - j);
        if (weight != 0)
          z += weight * static_cast<double>(from.z[from.index(bounded(i, from.columns), bounded(j, from.rows))]);
      }
    }
    return z;
  });
}

TEST(CoarseRaster, IsRecognizedWhenInterpolated) {
  const RasterGrid coarse = measured(110, 120, 5);
  EXPECT_EQ(interpolated_from(coarse), std::nullopt);
  for (const auto& [name, kernel] : {std::pair<const char*, Kernel>{"nearest", nearest},
                                     {"bilinear", bilinear},
                                     {"cubic", cubic},
                                     {"cubic spline", cubic_spline}}) {
    for (const double ratio : {2.0, 2.5, 3.0, 5.0, 7.3, 10.0}) {
      const auto from = interpolated_from(interpolated(coarse, ratio, kernel));
      ASSERT_TRUE(from) << name << ' ' << ratio;
      EXPECT_NEAR(from->x(), 5, 0.06 * 5) << name << ' ' << ratio;
      EXPECT_NEAR(from->y(), 5, 0.06 * 5) << name << ' ' << ratio;
    }
  }
}

TEST(CoarseRaster, MayHaveHoles) {
  RasterGrid fine = interpolated(measured(110, 120, 5), 5, bilinear);
  Dice dice(32);
  for (int hole = 0; hole < 60; ++hole) {
    const auto west = dice.below(fine.columns - 80), south = dice.below(fine.rows - 80);
    for (std::uint32_t j = 0; j < 80; ++j) {
      for (std::uint32_t i = 0; i < 80; ++i) fine.z[(south + j) * fine.columns + west + i] = std::nanf("");
    }
  }
  const auto from = interpolated_from(fine);
  ASSERT_TRUE(from);
  EXPECT_NEAR(from->x(), 5, 0.3);
  for (float& z : fine.z) z = std::nanf("");
  EXPECT_EQ(interpolated_from(fine), std::nullopt);
  EXPECT_EQ(elevation_step(fine), std::nullopt);
}

TEST(CoarseRaster, IsNotRecognizedInMeasuredOrSmoothGround) {
  EXPECT_EQ(interpolated_from(measured(300, 200, 1)), std::nullopt);
  EXPECT_EQ(interpolated_from(measured(50, 60, 10)), std::nullopt);
  const double turn = 2 * std::numbers::pi;
  const auto ground = [&](auto&& formula) { return interpolated_from(sampled(300, 300, 1, formula)); };
  EXPECT_EQ(ground([](double, double) { return 1200.0; }), std::nullopt);
  EXPECT_EQ(ground([](double x, double y) { return 1200 - 0.7 * x + 0.3 * y; }), std::nullopt);
  EXPECT_EQ(ground([](double x, double y) { return std::round(100 * (1200 - 0.7 * x + 0.3 * y)) / 100; }),
            std::nullopt);
  EXPECT_EQ(ground([](double x, double y) { return std::round(0.1 * (400 - x) * (400 - x) + 0.2 * y * y) / 100; }),
            std::nullopt);
  EXPECT_EQ(ground([](double x, double y) { return 0.001 * (400 - x) * (400 - x) + 0.002 * y * y; }), std::nullopt);
  for (const double length : {12.0, 20.0, 40.0}) {
    EXPECT_EQ(ground([&](double x, double y) {
                return -0.6 * x + std::sin(turn * x / length) * std::sin(turn * y / (1.25 * length)) +
                       0.5 * std::sin(turn * (x + y) / (1.125 * length));
              }),
              std::nullopt)
        << length;
  }
}

TEST(CoarseRaster, HasElevationsInSteps) {
  RasterGrid grid = measured(200, 200, 2);
  EXPECT_EQ(elevation_step(grid), std::nullopt);
  for (const double step : {1.0, 0.5, 5.0}) {
    RasterGrid rounded = grid;
    for (float& z : rounded.z) z = static_cast<float>(step * std::round(static_cast<double>(z) / step));
    EXPECT_EQ(elevation_step(rounded), step);
  }
  // Centimetres are no steps, and whole numbers on a plane bend nothing.
  for (float& z : grid.z) z = std::round(z * 100) / 100;
  EXPECT_EQ(elevation_step(grid), std::nullopt);
  EXPECT_EQ(elevation_step(sampled(100, 100, 1, [](double x, double y) { return 900 - x + 2 * y; })), std::nullopt);
}

}  // namespace
}  // namespace talus::project
