#include "talus/meshing/rock_shape.hpp"

#include <fmt/format.h>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cstdio>
#include <numbers>
#include <utility>

#include "talus/core/matrix.hpp"
#include "talus/core/problems.hpp"

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

/// Integrals over a body, about the origin.
struct Moments {
  double volume = 0;
  Vec3 first;   // of x
  Mat3 second;  // of x x^T
};

Moments moments_of(std::span<const Vec3> corners, const Triangles& triangles) {
  Moments sum;
  for (const auto& t : triangles) {
    const Vec3 &a = corners[t[0]], &b = corners[t[1]], &c = corners[t[2]], all = a + b + c;
    const double six_volumes = a.dot(b.cross(c));
    sum.volume += six_volumes / 6;
    sum.first += six_volumes / 24 * all;
    sum.second =
        sum.second +
        six_volumes / 120 * (outer_product(a, a) + outer_product(b, b) + outer_product(c, c) + outer_product(all, all));
  }
  return sum;
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
  std::vector<Vec3> corners = used_corners(scaled, triangles);
  const Vec3 centre = [&] {
    const Moments about_first = moments_of(corners, triangles);
    return about_first.first / about_first.volume;
  }();
  for (Vec3& corner : corners) corner -= centre;
  const Moments moments = moments_of(corners, triangles);

  Eigen::Matrix3d second;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      second(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = moments.second.rows[i][k] / moments.volume;
    }
  }
  // Ascending: the last is along the longest axis.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(second);
  const auto axis = [&](Eigen::Index k) {
    const Eigen::Vector3d v = axes.eigenvectors().col(k);
    return Vec3(v.x(), v.y(), v.z());
  };
  const Vec3 x = axis(2), y = axis(1), z = x.cross(y);
  const Eigen::Vector3d spread = axes.eigenvalues().cwiseMax(0);
  const double thickness = std::sqrt(spread(0) / spread(2));
  if (!(thickness > min_thickness)) {
    throw refused(fmt::format("it is {:.2g} as thick as long", thickness),
                  fmt::format("a rock is at least {:g}", min_thickness));
  }
  const double to_unit = 1 / std::cbrt(moments.volume);
  const Mat3 turned{{x, y, z}};
  for (Vec3& corner : corners) {
    corner = to_unit * (turned * corner);
    hull.shape.reach = std::max(hull.shape.reach, corner.norm());
  }
  const Vec3 q = to_unit * to_unit * Vec3(spread(2), spread(1), spread(0));
  hull.shape.gyration = {q[1] + q[2], q[0] + q[2], q[0] + q[1]};
  hull.shape.corners = std::move(corners);
  hull.shape.triangles = std::move(triangles);
  hull.volume = moments.volume * length * length * length;
  return hull;
}

RockShape box_shape(const Vec3& edges) {
  std::vector<Vec3> corners;
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      for (const double z : {-0.5, 0.5}) corners.push_back(edges.times({x, y, z}));
    }
  }
  return hull_of(corners).shape;
}

RockShape ellipsoid_shape(const Vec3& axes, int corners) {
  // A spiral of equal areas with the golden angle.
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  std::vector<Vec3> points;
  for (int i = 0; i < corners; ++i) {
    const double z = 1 - (2 * i + 1.0) / corners, r = std::sqrt(1 - z * z);
    points.push_back(0.5 * axes.times({r * std::cos(golden * i), r * std::sin(golden * i), z}));
  }
  return hull_of(points).shape;
}

RockShape regular_shape(RegularSolid solid) {
  constexpr double phi = std::numbers::phi;
  std::vector<Vec3> corners;
  const auto around = [&](double a, double b, double c) {  // all signs, turned through the axes
    for (const double s : {-1, 1}) {
      for (const double t : {-1, 1}) {
        corners.push_back({a, s * b, t * c});
        corners.push_back({t * c, a, s * b});
        corners.push_back({s * b, t * c, a});
      }
    }
  };
  switch (solid) {
    case RegularSolid::tetrahedron:
      corners = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
      break;
    case RegularSolid::cube:
      return box_shape({1, 1, 1});
    case RegularSolid::octahedron:
      corners = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
      break;
    case RegularSolid::dodecahedron:
      around(0, 1 / phi, phi);
      for (const double x : {-1, 1}) {
        for (const double y : {-1, 1}) {
          for (const double z : {-1, 1}) corners.push_back({x, y, z});
        }
      }
      break;
    case RegularSolid::icosahedron:
      around(0, 1, phi);
      break;
  }
  return hull_of(corners).shape;
}

RockShape prism_shape(int sides, double length) {
  std::vector<Vec3> corners;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    for (const double y : {-length, length}) corners.push_back({std::cos(angle), y, std::sin(angle)});
  }
  return hull_of(corners).shape;
}

}  // namespace talus
