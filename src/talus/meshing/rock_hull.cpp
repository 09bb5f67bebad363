#include "talus/meshing/rock_hull.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>
#include <vector>

#include "talus/core/problems.hpp"
#include "talus/rocks/solid.hpp"

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace talus {

namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// A hull must be thicker than this share of its length: flatter ones are surfaces.
constexpr double min_thickness = 1e-3;

BadInput refused(std::string what, std::string why) {
  return BadInput(Problem{.what = std::move(what), .why = std::move(why)});
}

Vec3 range_of(std::span<const Vec3> points) {
  Vec3 low = points[0], high = points[0];
  for (const Vec3& p : points) low = low.min(p), high = high.max(p);
  return high - low;
}

/// A run of qhull, and its memory. The name of the member is the one that qhull's macros use.
struct QhullRun {
  qhT state{};
  qhT* qh = &state;
  std::FILE* unread = std::fopen("/dev/null", "w");  // what it prints

  QhullRun() { qh_zero(qh, unread); }
  QhullRun(const QhullRun&) = delete;
  QhullRun& operator=(const QhullRun&) = delete;
  ~QhullRun() {
    int left = 0, bytes = 0;
    qh_freeqhull(qh, !qh_ALL);
    qh_memfreeshort(qh, &left, &bytes);
    if (unread != nullptr) std::fclose(unread);
  }
};

/// The triangles of the hull, counter-clockwise from outside; none if the points lie in a plane.
Triangles triangles_of(std::span<const Vec3> points) {
  std::vector<double> flat;
  for (const Vec3& p : points) flat.insert(flat.end(), p.data(), p.data() + Vec3::size());
  QhullRun run;
  qhT* const qh = run.qh;
  char options[] = "qhull Qt";
  if (qh_new_qhull(qh, 3, static_cast<int>(points.size()), flat.data(), False, options, run.unread, run.unread) != 0) {
    return {};
  }
  Triangles triangles;
  facetT* facet = nullptr;
  FORALLfacets {
    std::array<std::uint32_t, 3> corners{};
    std::size_t k = 0;
    vertexT *vertex = nullptr, **vertexp = nullptr;
    FOREACHvertex_(facet->vertices) {
      if (k < corners.size()) corners[k++] = static_cast<std::uint32_t>(qh_pointid(qh, vertex->point));
    }
    const Vec3 normal(facet->normal[0], facet->normal[1], facet->normal[2]);
    const Vec3 &a = points[corners[0]], &b = points[corners[1]], &c = points[corners[2]];
    if ((b - a).cross(c - a).dot(normal) < 0) std::swap(corners[1], corners[2]);
    triangles.push_back(corners);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

/// Corners that are in a triangle, in their order; the triangles are renumbered.
std::vector<Vec3> used_corners(std::span<const Vec3> points, Triangles& triangles) {
  constexpr std::uint32_t unused = ~0U;
  std::vector<std::uint32_t> number(points.size(), unused);
  for (const auto& t : triangles) {
    for (const std::uint32_t corner : t) number[corner] = 0;
  }
  std::vector<Vec3> corners;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (number[i] == unused) continue;
    number[i] = static_cast<std::uint32_t>(corners.size());
    corners.push_back(points[i]);
  }
  for (auto& t : triangles) {
    for (std::uint32_t& corner : t) corner = number[corner];
  }
  return corners;
}

}  // namespace

Hull hull_of(std::span<const Vec3> points) {
  if (points.size() < 4) {
    throw refused(fmt::format("it has {} points", points.size()), "a hull has four or more");
  }
  const auto bad = std::find_if(points.begin(), points.end(), [](const Vec3& p) { return !p.is_finite(); });
  if (bad != points.end()) throw refused(fmt::format("point {} is not a number", bad - points.begin() + 1), "");
  const double length = range_of(points).largest();
  if (length == 0) throw refused("all its points are one", "a hull has a volume");

  // Near the origin and about 1 long: no unit and no place is too small or too far away.
  std::vector<Vec3> scaled;
  for (const Vec3& p : points) scaled.push_back((p - points[0]) / length);
  Hull hull;
  Triangles triangles = triangles_of(scaled);
  if (triangles.empty()) throw refused("its points lie in a plane", "a hull has a volume");
  hull.shape.corners = used_corners(scaled, triangles);
  hull.shape.triangles = std::move(triangles);
  const double volume = settle(hull.shape);
  const Vec3& k = hull.shape.gyration;
  const double thickness = std::sqrt(std::max(0.0, k[0] + k[1] - k[2]) / (k[1] + k[2] - k[0]));
  if (!(thickness > min_thickness)) {
    throw refused(fmt::format("it is {:.2g} as thick as long", thickness),
                  fmt::format("a rock is at least {:g}", min_thickness));
  }
  hull.volume = volume * length * length * length;
  return hull;
}

Hull thinned_hull_of(std::span<const Vec3> points, std::size_t max_corners) {
  Hull whole = hull_of(points);
  if (whole.shape.corners.size() <= max_corners) return whole;
  const std::vector<Vec3>& all = whole.shape.corners;
  std::vector<Vec3> kept;
  for (const Vec3& axis : {unit_x, -unit_x, unit_y, -unit_y, unit_z, -unit_z}) {
    const auto reaches = [&](const Vec3& a, const Vec3& b) { return a.dot(axis) < b.dot(axis); };
    const Vec3& farthest = *std::max_element(all.begin(), all.end(), reaches);
    if (kept.size() < max_corners && std::ranges::find(kept, farthest) == kept.end()) kept.push_back(farthest);
  }
  while (kept.size() < max_corners) {
    std::optional<Vec3> farthest;
    double outside = 0;
    for (const auto& t : triangles_of(kept)) {
      const Vec3 &a = kept[t[0]], normal = (kept[t[1]] - a).cross(kept[t[2]] - a).normalized();
      for (const Vec3& point : all) {
        if (const double distance = normal.dot(point - a); distance > outside) {
          outside = distance;
          farthest = point;
        }
      }
    }
    if (!farthest) break;
    kept.push_back(*farthest);
  }
  Hull thinned = hull_of(kept);
  thinned.shape.as_given = whole.shape.as_given * thinned.shape.as_given;
  thinned.volume *= whole.volume;  // that of the whole shape is 1
  return thinned;
}

}  // namespace talus
