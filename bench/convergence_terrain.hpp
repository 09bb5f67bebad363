#pragma once
// The terrains of bench_convergence: smooth surfaces, so that the same ground can be sampled on cells of any size.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/import/raster_file.hpp"

namespace talus::bench {

/// A rectangle of smooth ground, with the line from which rocks are released.
struct SmoothTerrain {
  std::string name;
  double width, height;                              // on plan; its south-west corner is the origin [m]
  std::function<double(double x, double y)> ground;  // elevation [m]
  Vec2 from, to;                                     // of the release line; rocks run to its right
  double line_at;                                    // how far to the right of it arrivals are counted, on plan [m]

  /// Its elevations on cells of this size [m].
  [[nodiscard]] RasterGrid sampled(double cell) const {
    RasterGrid grid;
    grid.dx = grid.dy = cell;
    grid.columns = static_cast<std::uint32_t>(std::floor(width / cell)) + 1;
    grid.rows = static_cast<std::uint32_t>(std::floor(height / cell)) + 1;
    grid.z.reserve(static_cast<std::size_t>(grid.columns) * grid.rows);
    for (std::uint32_t j = 0; j < grid.rows; ++j) {
      for (std::uint32_t i = 0; i < grid.columns; ++i) grid.z.push_back(static_cast<float>(ground(i * cell, j * cell)));
    }
    return grid;
  }
};

/// A uniform cubic B-spline: smooth to its second derivatives, with wavelengths of two knots and more. The elevations
/// of a file, averaged about each knot, are its coefficients: it smooths them.
class SplineGround {
 public:
  /// Of a rectangle of the file, from (west, south). Expects knots at least as far apart as the file's cells [m].
  SplineGround(const RasterGrid& grid, double west, double south, double width, double height, double knots)
      : knots_(knots), columns_(count(width)), rows_(count(height)) {
    coefficients_.reserve(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    for (int j = 0; j < rows_; ++j) {
      for (int i = 0; i < columns_; ++i) {
        coefficients_.push_back(mean_about(grid, west + (i - 1) * knots, south + (j - 1) * knots));
      }
    }
  }

  [[nodiscard]] double operator()(double x, double y) const {
    const auto [i, u] = place(x);
    const auto [j, v] = place(y);
    double z = 0;
    for (int b = 0; b < 4; ++b) {
      for (int a = 0; a < 4; ++a) {
        z += u[static_cast<std::size_t>(a)] * v[static_cast<std::size_t>(b)] *
             coefficients_[static_cast<std::size_t>(j + b) * static_cast<std::size_t>(columns_) +
                           static_cast<std::size_t>(i + a)];
      }
    }
    return z;
  }

 private:
  struct Place {
    int first;
    std::array<double, 4> weights;
  };
  [[nodiscard]] int count(double length) const { return static_cast<int>(std::floor(length / knots_)) + 4; }
  [[nodiscard]] Place place(double x) const {
    const double at = x / knots_, whole = std::floor(at), t = at - whole, s = 1 - t;
    return {static_cast<int>(whole),
            {s * s * s / 6, (3 * t * t * t - 6 * t * t + 4) / 6, (3 * s * s * s - 6 * s * s + 4) / 6, t * t * t / 6}};
  }
  [[nodiscard]] double mean_about(const RasterGrid& grid, double x, double y) const {
    const auto range = [&](double at, double start, double step, std::uint32_t nodes) {
      const double low = std::ceil((at - 0.5 * knots_ - start) / step),
                   high = std::floor((at + 0.5 * knots_ - start) / step);
      const auto bounded = [&](double k) { return static_cast<std::uint32_t>(std::clamp(k, 0.0, nodes - 1.0)); };
      return std::pair(bounded(low), bounded(high));
    };
    const auto [west, east] = range(x, grid.x0, grid.dx, grid.columns);
    const auto [south, north] = range(y, grid.y0, grid.dy, grid.rows);
    double sum = 0;
    int nodes = 0;
    for (std::uint32_t j = south; j <= north; ++j) {
      for (std::uint32_t i = west; i <= east; ++i, ++nodes) sum += static_cast<double>(grid.z[grid.index(i, j)]);
    }
    return sum / nodes;
  }

  double knots_;
  int columns_, rows_;
  std::vector<double> coefficients_;
};

/// The elevations of a file, unsmoothed, with cubic convolution between its nodes (R. G. Keys, IEEE Transactions on
/// Acoustics, Speech, and Signal Processing 29 (1981) 1153-1160, a = -1/2), as GDAL's `cubic`: on cells of the file's
/// size they are the file's, and finer cells are what such data are resampled to.
class RawGround {
 public:
  RawGround(RasterGrid grid, double west, double south) : grid_(std::move(grid)), west_(west), south_(south) {}

  [[nodiscard]] double operator()(double x, double y) const {
    const auto [i, u] = place((west_ + x - grid_.x0) / grid_.dx, grid_.columns);
    const auto [j, v] = place((south_ + y - grid_.y0) / grid_.dy, grid_.rows);
    double z = 0;
    for (std::uint32_t b = 0; b < 4; ++b) {
      for (std::uint32_t a = 0; a < 4; ++a) z += u[a] * v[b] * static_cast<double>(grid_.z[grid_.index(i + a, j + b)]);
    }
    return z;
  }

 private:
  struct Place {
    std::uint32_t first;
    std::array<double, 4> weights;
  };
  [[nodiscard]] static Place place(double at, std::uint32_t nodes) {
    const double whole = std::clamp(std::floor(at), 1.0, nodes - 3.0), t = at - whole;
    const double squared = t * t, cubed = squared * t;
    return {static_cast<std::uint32_t>(whole) - 1,
            {0.5 * (-cubed + 2 * squared - t), 0.5 * (3 * cubed - 5 * squared + 2),
             0.5 * (-3 * cubed + 4 * squared + t), 0.5 * (cubed - squared)}};
  }

  RasterGrid grid_;
  double west_, south_;
};

/// A slope that bends along a circular arc of radius 250 m from 45 degrees to level ground.
inline SmoothTerrain arc_terrain() {
  const auto ground = [](double x, double) {
    constexpr double radius = 250, crest = 60, foot = crest + radius / std::numbers::sqrt2;
    if (x >= foot) return 0.0;
    if (x <= crest) return (crest - x) + radius * (1 - 1 / std::numbers::sqrt2);
    return radius - std::sqrt(radius * radius - (foot - x) * (foot - x));
  };
  return {"arc", 700, 400, ground, {10, 100}, {10, 300}, 140};
}

/// A slope that levels out, with waves of 40 m and more in length.
inline SmoothTerrain waves_terrain() {
  const auto ground = [](double x, double y) {
    constexpr double turn = 2 * std::numbers::pi;
    const double down = std::max(0.0, 400 - x);
    const double waves = 0.9 * std::sin(turn * x / 52) * std::sin(turn * y / 64) + 0.5 * std::sin(turn * (x + y) / 57);
    return 0.001 * down * down + 0.2 * down + waves;
  };
  return {"waves", 900, 400, ground, {10, 100}, {10, 300}, 250};
}

/// Part of a raster, as FILE,west,south,east,north,x1,y1,x2,y2,distance in the file's coordinates: rocks are released
/// from (x1, y1) to (x2, y2), run to the right of that line, and are counted at this distance from it. `knots`: 0 for
/// raw ground.
inline SmoothTerrain file_terrain(const std::string& text, double knots) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t comma = std::min(text.find(',', at), text.size());
    parts.push_back(text.substr(at, comma - at));
    at = comma + 1;
  }
  std::vector<double> numbers;
  for (std::size_t k = 1; k < parts.size(); ++k) numbers.push_back(std::strtod(parts[k].c_str(), nullptr));
  if (numbers.size() != 9) throw std::invalid_argument("expected FILE,west,south,east,north,x1,y1,x2,y2,distance");
  Problems warnings;
  RasterFile file = read_raster_file(parts[0], warnings);
  const double west = numbers[0], south = numbers[1], width = numbers[2] - west, height = numbers[3] - south;
  const Vec2 corner(west, south);
  std::function<double(double, double)> ground;
  if (knots > 0) {
    ground = SplineGround(file.grid, west, south, width, height, knots);
  } else {
    ground = RawGround(std::move(file.grid), west, south);
  }
  return {std::filesystem::path(parts[0]).filename().string(),
          width,
          height,
          std::move(ground),
          Vec2(numbers[4], numbers[5]) - corner,
          Vec2(numbers[6], numbers[7]) - corner,
          numbers[8]};
}

}  // namespace talus::bench
