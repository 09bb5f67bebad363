#pragma once
// Triangulated shapes for simulations. All are manifold and wound counter-clockwise seen from outside the ground, like
// cleaned meshes.

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "support/dice.hpp"
#include "talus/terrain/triangle_mesh.hpp"

namespace talus::testing_tools {

struct Shape {
  std::vector<Vec3> vertices;
  std::vector<TriangleMesh::Corners> triangles;

  [[nodiscard]] std::vector<TriangleMesh::Corners> neighbours() const {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> owner;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) owner[{triangles[i][k], triangles[i][(k + 1) % 3]}] = i;
    }
    std::vector<TriangleMesh::Corners> beyond(triangles.size());
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto other = owner.find({triangles[i][(k + 1) % 3], triangles[i][k]});
        beyond[i][k] = other == owner.end() ? TriangleMesh::no_neighbour : other->second;
      }
    }
    return beyond;
  }
  [[nodiscard]] TriangleMesh mesh() const { return {vertices, triangles, neighbours()}; }

  /// With `map`, which must preserve orientation, applied to every vertex.
  template <class Map>
  [[nodiscard]] Shape moved(Map&& map) const {
    Shape shape = *this;
    for (Vec3& v : shape.vertices) v = map(v);
    return shape;
  }
  /// Mirrored in the plane x = 0.
  [[nodiscard]] Shape mirrored() const {
    Shape shape = *this;
    for (Vec3& v : shape.vertices) v.x() = -v.x();
    for (auto& corners : shape.triangles) std::swap(corners[1], corners[2]);
    return shape;
  }
  [[nodiscard]] Vec3 normal(std::size_t i) const {
    const Vec3 &a = vertices[triangles[i][0]], &b = vertices[triangles[i][1]], &c = vertices[triangles[i][2]];
    return (b - a).cross(c - a).normalized();
  }
};

/// A net of `columns` by `rows` cells over (0, 0) to (width, depth), each cell split along one of its diagonals.
/// `place(i, j)` gives the vertex of column i and row j; `slash(i, j)` chooses the diagonal.
template <class Place, class Slash>
[[nodiscard]] Shape net(std::uint32_t columns, std::uint32_t rows, Place&& place, Slash&& slash) {
  Shape shape;
  for (std::uint32_t j = 0; j <= rows; ++j) {
    for (std::uint32_t i = 0; i <= columns; ++i) shape.vertices.push_back(place(i, j));
  }
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return j * (columns + 1) + i; };
  for (std::uint32_t j = 0; j < rows; ++j) {
    for (std::uint32_t i = 0; i < columns; ++i) {
      const std::uint32_t a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      if (slash(i, j)) {
        shape.triangles.push_back({a, b, c});
        shape.triangles.push_back({a, c, d});
      } else {
        shape.triangles.push_back({a, b, d});
        shape.triangles.push_back({b, c, d});
      }
    }
  }
  return shape;
}

/// A height field on an irregular net with random diagonals. `height(x, y)` is the ground elevation.
template <class Height>
[[nodiscard]] Shape irregular_field(Dice& dice, std::uint32_t columns, std::uint32_t rows, double width, double depth,
                                    Height&& height) {
  const double dx = width / columns, dy = depth / rows;
  return net(
      columns, rows,
      [&](std::uint32_t i, std::uint32_t j) {
        // The rim stays straight; interior vertices move by less than the quarter cell that could turn a triangle over.
        const double x = dx * (i + (i > 0 && i < columns ? dice.between(-0.24, 0.24) : 0.0));
        const double y = dy * (j + (j > 0 && j < rows ? dice.between(-0.24, 0.24) : 0.0));
        return Vec3(x, y, height(x, y));
      },
      [&](std::uint32_t, std::uint32_t) { return dice.chance(0.5); });
}

/// A slope that falls along x, with random bumps.
[[nodiscard]] inline Shape random_slope(Dice& dice, std::uint32_t cells, double size, double grade, double relief) {
  return irregular_field(dice, cells, cells, size, size,
                         [&](double x, double) { return -grade * x + dice.between(-relief, relief); });
}

/// A polyline of the x-z plane, extruded from y = 0 to y = width in `strips` strips.
[[nodiscard]] inline Shape extruded(std::span<const Vec2> section, double width, std::uint32_t strips, Dice& dice) {
  return net(
      static_cast<std::uint32_t>(section.size() - 1), strips,
      [&](std::uint32_t i, std::uint32_t j) { return Vec3(section[i].x(), width * j / strips, section[i].y()); },
      [&](std::uint32_t, std::uint32_t) { return dice.chance(0.5); });
}

/// An icosahedron, subdivided `levels` times, on the unit sphere about the origin; facing outwards.
[[nodiscard]] inline Shape icosphere(int levels) {
  const double q = (1 + std::sqrt(5.0)) / 2;
  Shape shape;
  shape.vertices = {{-1, q, 0},  {1, q, 0},  {-1, -q, 0}, {1, -q, 0}, {0, -1, q},  {0, 1, q},
                    {0, -1, -q}, {0, 1, -q}, {q, 0, -1},  {q, 0, 1},  {-q, 0, -1}, {-q, 0, 1}};
  shape.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                     {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                     {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middle;
    const auto halfway = [&](std::uint32_t a, std::uint32_t b) {
      const auto [place, is_new] =
          middle.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(shape.vertices.size()));
      if (is_new) shape.vertices.push_back(0.5 * (shape.vertices[a] + shape.vertices[b]));
      return place->second;
    };
    std::vector<TriangleMesh::Corners> finer;
    for (const auto& [a, b, c] : shape.triangles) {
      const std::uint32_t ab = halfway(a, b), bc = halfway(b, c), ca = halfway(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    shape.triangles = std::move(finer);
  }
  for (Vec3& v : shape.vertices) v = v.normalized();
  return shape;
}

/// A closed body, star-shaped about the origin: an icosphere with randomly scaled vertices.
[[nodiscard]] inline Shape random_boulder(Dice& dice, int levels, double radius, double noise) {
  return icosphere(levels).moved([&](const Vec3& v) { return radius * (1 + dice.between(-noise, noise)) * v; });
}

/// The box between two corners, two triangles a side, facing outwards.
[[nodiscard]] inline Shape box(const Vec3& low, const Vec3& high) {
  Shape shape;
  for (int k = 0; k < 8; ++k) {
    shape.vertices.emplace_back((k & 1) != 0 ? high.x() : low.x(), (k & 2) != 0 ? high.y() : low.y(),
                                (k & 4) != 0 ? high.z() : low.z());
  }
  shape.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                     {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return shape;
}

}  // namespace talus::testing_tools
