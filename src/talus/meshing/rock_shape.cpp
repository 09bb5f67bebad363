#include "talus/meshing/rock_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "talus/core/orientation.hpp"
#include "talus/core/random.hpp"
#include "talus/meshing/rock_hull.hpp"

namespace talus {

namespace {

constexpr double pi = std::numbers::pi;

/// A spiral of equal areas on the unit sphere, with the golden angle.
std::vector<Vec3> spread_on_sphere(int count) {
  const double golden = pi * (3 - std::sqrt(5.0));
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count, r = std::sqrt(1 - z * z);
    points.push_back({r * std::cos(golden * i), r * std::sin(golden * i), z});
  }
  return points;
}

std::vector<Vec3> extruded(std::span<const Vec2> outline, double length) {
  std::vector<Vec3> corners;
  for (const Vec2& p : outline) {
    for (const double y : {-0.5 * length, 0.5 * length}) corners.push_back({p.x(), y, p.y()});
  }
  return corners;
}

std::vector<Vec3> corners_of(RegularSolid solid) {
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
  const auto cube = [&] {
    for (const double x : {-1, 1}) {
      for (const double y : {-1, 1}) {
        for (const double z : {-1, 1}) corners.push_back({x, y, z});
      }
    }
  };
  switch (solid) {
    case RegularSolid::tetrahedron:
      return {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    case RegularSolid::cube:
      cube();
      break;
    case RegularSolid::octahedron:
      return {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    case RegularSolid::dodecahedron:
      around(0, 1 / phi, phi);
      cube();
      break;
    case RegularSolid::icosahedron:
      around(0, 1, phi);
      break;
  }
  return corners;
}

}  // namespace

RockShape box_shape(const Vec3& edges) {
  std::vector<Vec3> corners = corners_of(RegularSolid::cube);
  for (Vec3& corner : corners) corner = 0.5 * edges.times(corner);
  return hull_of(corners).shape;
}

RockShape ellipsoid_shape(const Vec3& axes, int corners) {
  std::vector<Vec3> points = spread_on_sphere(corners);
  for (Vec3& point : points) point = 0.5 * axes.times(point);
  return hull_of(points).shape;
}

RockShape regular_shape(RegularSolid solid) { return hull_of(corners_of(solid)).shape; }

RockShape icosphere_shape(RegularSolid solid) {
  const RockShape base = regular_shape(solid);
  std::vector<Vec3> points = base.corners;
  for (const auto& t : base.triangles) {
    for (std::size_t k = 0; k < t.size(); ++k) {
      const Vec3 &a = base.corners[t[k]], &b = base.corners[t[(k + 1) % t.size()]];
      if (t[k] < t[(k + 1) % t.size()]) points.push_back(base.reach * (a + b).normalized());
    }
  }
  return hull_of(points).shape;
}

std::vector<Vec2> regular_outline(int sides) {
  std::vector<Vec2> outline;
  for (int i = 0; i < sides; ++i) {
    const double angle = -pi / 2 + pi * (2 * i + 1) / sides;
    outline.push_back({std::cos(angle), std::sin(angle)});
  }
  return outline;
}

std::vector<Vec2> superellipse_outline(double b_over_a, double power) {
  constexpr int count = 48;
  std::vector<Vec2> outline;
  for (int i = 0; i < count; ++i) {
    // Where the normal points this way: (x^(p-1)/a^p, z^(p-1)/b^p), for positive x and z.
    const double angle = 2 * pi * (i + 0.5) / count, c = std::cos(angle), s = std::sin(angle);
    const double x = std::pow(std::abs(c), 1 / (power - 1));
    const double z = std::pow(std::abs(s) * b_over_a, 1 / (power - 1)) * b_over_a;
    const double scale = std::pow(std::pow(x, power) + std::pow(z / b_over_a, power), -1 / power);
    outline.push_back({std::copysign(scale * x, c), std::copysign(scale * z, s)});
  }
  return outline;
}

std::vector<Vec2> rectangle_outline(double b_over_a) {
  return {{-0.5, -0.5 * b_over_a}, {0.5, -0.5 * b_over_a}, {0.5, 0.5 * b_over_a}, {-0.5, 0.5 * b_over_a}};
}

RockShape prism_shape(std::span<const Vec2> outline, double length) {
  const double area = hull_of(extruded(outline, 1)).volume;
  return hull_of(extruded(outline, length * std::sqrt(area))).shape;
}

RockShape section_shape(std::span<const Vec2> outline) {
  const RockShape prism = prism_shape(outline);
  const Vec3 along = prism.as_given.to_body(unit_y);
  RockShape section;
  section.gyration = Vec3::all(along.times(along).dot(prism.gyration));
  for (const Vec3& corner : prism.corners) {
    const Vec3 given = prism.as_given.to_world(corner);
    if (given.y() > 0) continue;
    section.corners.push_back({given.x(), 0, given.z()});
    section.reach = std::max(section.reach, section.corners.back().norm());
  }
  find_faces(section.corners, section.triangles, section.hull);
  return section;
}

std::vector<RockShape> irregular_balls(int corners) {
  constexpr std::uint64_t count = 32;
  constexpr auto stream = static_cast<Stream>(101);  // a purpose of its own (core/random.hpp)
  const double distance = std::sqrt(4 * pi / corners);
  std::vector<RockShape> balls;
  for (std::uint64_t ball = 0; ball < count; ++ball) {
    std::uint32_t index = 0;
    const auto draw = [&] { return uniform_pair(0, ball, stream, index++); };
    const auto [u, v] = draw();
    const Orientation turned = Orientation::uniform(u, v, draw()[0]);
    std::vector<Vec3> points = spread_on_sphere(corners);
    for (Vec3& point : points) {
      const auto [a, b] = draw();
      const Vec3 shift = 2 * Vec3(a, b, draw()[0]) - Vec3::all(1);
      point = turned.to_world(point + 0.35 * distance * shift).normalized();
    }
    balls.push_back(hull_of(points).shape);
  }
  return balls;
}

}  // namespace talus
