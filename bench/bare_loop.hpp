#pragma once
// A baseline: a loop that only simulates points on a raster (cell walk, two quadratics per cell, the CRSP impact; no
// distributions, no sliding, no recording).

#include "common.hpp"
#include "talus/impact/crsp.hpp"

namespace talus::bench {

struct BareCount {
  std::uint64_t impacts = 0, cells = 0;
  double sum = 0;  // of the end points, so that the compiler removes nothing
};

// One rock, as simply as possible.
inline void bare_rock(const RasterGrid& grid, Vec3 p, Vec3 v, const Rock& rock, BareCount& count) {
  constexpr double g = standard_gravity;
  const auto z = [&](int i, int j) {
    return static_cast<double>(grid.z[static_cast<std::size_t>(j) * grid.columns + static_cast<std::size_t>(i)]);
  };
  const int last = static_cast<int>(grid.columns) - 2;
  Vec3 w;
  int i = static_cast<int>(p.x()), j = static_cast<int>(p.y());
  for (int impact = 0; impact < 1000; ++impact) {
    // The cells of this flight.
    double t0 = 0;
    bool hit = false;
    while (!hit) {
      ++count.cells;
      const double tx = v.x() > 0 ? (i + 1 - p.x()) / v.x() : v.x() < 0 ? (i - p.x()) / v.x() : 1e300;
      const double ty = v.y() > 0 ? (j + 1 - p.y()) / v.y() : v.y() < 0 ? (j - p.y()) / v.y() : 1e300;
      const double t1 = std::max(t0, std::min(tx, ty));
      const double a = z(i, j), b = z(i + 1, j), c = z(i + 1, j + 1), d = z(i, j + 1);
      double best = 1e300, sx_best = 0, sy_best = 0;
      for (int half = 0; half < 2; ++half) {
        const double sx = half == 0 ? b - a : c - d, sy = half == 0 ? c - b : d - a;
        const double h0 = p.z() - (a + sx * (p.x() - i) + sy * (p.y() - j));
        const double h1 = v.z() - sx * v.x() - sy * v.y();
        const double q = h1 * h1 + 2 * g * h0;
        if (q < 0) continue;
        const double t = (h1 + std::sqrt(q)) / g;
        if (t < t0 + 1e-12 || t > t1 || t >= best) continue;
        const double fx = p.x() + t * v.x() - i, fy = p.y() + t * v.y() - j;
        if ((half == 0) != (fx >= fy)) continue;
        best = t;
        sx_best = sx;
        sy_best = sy;
      }
      if (best < 1e300) {
        ++count.impacts;
        const Vec3 n = Vec3(-sx_best, -sy_best, 1).normalized();
        p += best * v - Vec3(0, 0, 0.5 * g * best * best);
        v.z() -= g * best;
        const Rebound rebound = crsp_rebound(v, w, n, rock, {0.35, 0.85});
        v = rebound.velocity;
        w = rebound.spin;
        hit = true;
        break;
      }
      if (t1 > 100) {
        count.sum += p.x();
        return;
      }
      (tx < ty ? i : j) += tx < ty ? (v.x() > 0 ? 1 : -1) : (v.y() > 0 ? 1 : -1);
      if (i < 0 || j < 0 || i > last || j > last) {
        count.sum += p.x() + t1 * v.x();
        return;
      }
      t0 = t1;
    }
    if (v.squared_norm() < 0.01) break;
  }
  count.sum += p.x();
}

inline double bare_loop(const RasterGrid& grid, const RasterSurface& surface, std::uint64_t rocks, BareCount& count) {
  const Rock rock = sphere_of_mass(1000, 2700);
  return seconds([&] {
    for (std::uint64_t k = 0; k < rocks; ++k) {
      const auto u = uniform_pair(1, k, Stream::release_position, 0);
      const double x = 5 + 5 * u[0], y = 100 + (grid.rows - 200) * u[1];
      bare_rock(grid, {x, y, *surface.elevation(x, y) + 6}, {1, 0, 0}, rock, count);
    }
  });
}

}  // namespace talus::bench
