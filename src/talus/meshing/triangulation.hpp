#pragma once
// A Delaunay triangulation on plan, with sides that may be fixed. Exact: nothing in it is rounded.
//
// Points are put in one by one (Lawson 1977: a point splits the triangle or the side that it lies on, then sides are
// flipped until no circle around a triangle holds a point), in an order that keeps them close together and yet random
// enough that no input is slow (Amenta, Choi and Rote 2003, "Incremental constructions con BRIO"; Hilbert's curve
// within a round). Beyond each side of the hull stands a triangle with its third corner at infinity, so that a point
// outside is put in like any other.
//
// Why not a library's: Boost.Polygon's Voronoi diagram is exact in what it decides but merges vertices that are equal
// to 1e-14, so that its triangles would have to be repaired by flips; it takes six times the memory; and flips and
// insertions are needed for breaklines anyway (constrained_triangulation.hpp). The tests hold the two against each
// other. Memory: 2 x 25 + 12 = 62 bytes a point, and 24 more while the points are put in order.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "talus/meshing/triangulation_grid.hpp"

namespace talus {

class Triangulation {
 public:
  using Vertex = std::uint32_t;
  /// Stands for the corner at infinity of the triangles beyond the hull.
  static constexpr Vertex infinity = 0xffffffffU;

  /// A side of a triangle as that triangle has it: from corner k to corner k + 1, the triangle on its left.
  struct Side {
    std::uint32_t triangle = 0;
    std::uint32_t k = 0;
  };

  struct Triangle {
    std::array<Vertex, 3> corner{};            // counter-clockwise; at most one at infinity
    std::array<std::uint32_t, 3> neighbour{};  // across the side from corner k to corner k + 1
  };

  /// Whether the points, at least three, do not all lie on one line.
  [[nodiscard]] static bool span_a_plane(std::span<const GridPoint> points);

  /// Points must be distinct and span a plane. A vertex is the number of its point.
  explicit Triangulation(std::vector<GridPoint> points);

  [[nodiscard]] std::size_t vertex_count() const { return points_.size(); }
  [[nodiscard]] GridPoint point(Vertex v) const { return points_[v]; }
  /// All triangles, those beyond the hull too.
  [[nodiscard]] std::span<const Triangle> triangles() const { return triangles_; }
  /// Whether a triangle has all its corners on plan.
  [[nodiscard]] bool is_real(std::uint32_t triangle) const;

  [[nodiscard]] Vertex from(Side s) const { return triangles_[s.triangle].corner[s.k]; }
  [[nodiscard]] Vertex to(Side s) const { return triangles_[s.triangle].corner[next(s.k)]; }
  /// The corner opposite.
  [[nodiscard]] Vertex apex(Side s) const { return triangles_[s.triangle].corner[before(s.k)]; }
  /// The same side as the triangle beyond has it.
  [[nodiscard]] Side twin(Side s) const;
  [[nodiscard]] Side next_side(Side s) const { return {s.triangle, next(s.k)}; }
  /// Some side that begins at a vertex, and the next one around it, counter-clockwise.
  [[nodiscard]] Side side_from(Vertex v) const { return {triangle_of_[v], corner_number(triangle_of_[v], v)}; }
  [[nodiscard]] Side next_around(Side s) const { return twin({s.triangle, before(s.k)}); }
  /// The side between two vertices, if they are joined.
  [[nodiscard]] std::optional<Side> side(Vertex a, Vertex b) const;

  [[nodiscard]] bool is_fixed(Side s) const { return (fixed_[s.triangle] >> s.k & 1U) != 0; }
  /// A fixed side is never flipped.
  void fix(Side s, bool fixed = true);

  /// Whether the side is not Delaunay: the circle around one of its triangles holds the other's corner.
  [[nodiscard]] bool wants_flip(Side s) const;
  /// Whether its two triangles make a strictly convex quadrilateral.
  [[nodiscard]] bool can_flip(Side s) const;
  /// Puts the other diagonal into the quadrilateral of a side's two triangles, which must be strictly convex.
  void flip(Side s);
  /// Flips these sides, where they want it and are not fixed, and what is around them, until no side wants it.
  void flip_until_delaunay(std::vector<std::array<Vertex, 2>> sides);

  struct Inserted {
    Vertex vertex = 0;
    bool is_new = true;
    std::optional<std::array<Vertex, 2>> on_fixed;  // the fixed side that it split in two fixed ones
  };
  /// Puts in a further point, unless there is one.
  Inserted insert(GridPoint p);

 private:
  static constexpr std::uint32_t next(std::uint32_t k) { return k == 2 ? 0 : k + 1; }
  static constexpr std::uint32_t before(std::uint32_t k) { return k == 0 ? 2 : k - 1; }

  struct Located {
    std::uint32_t triangle = 0;
    std::uint32_t on_sides = 0;  // a bit for each side on which the point lies: two at a corner
  };

  [[nodiscard]] std::uint32_t corner_number(std::uint32_t triangle, Vertex v) const;
  void begin(Vertex a, Vertex b, Vertex c);
  [[nodiscard]] Located locate(GridPoint p);
  Inserted put_in(Vertex v);
  void split_triangle(std::uint32_t t, Vertex v);
  void split_side(Side s, Vertex v);
  void flip_around(Vertex v);
  /// Writes a triangle; sides that are fixed have their bit.
  void set(std::uint32_t t, const std::array<Vertex, 3>& corner, const std::array<std::uint32_t, 3>& neighbour,
           std::uint32_t fixed);
  void replace_neighbour(std::uint32_t of, std::uint32_t old, std::uint32_t now, Vertex from);

  std::vector<GridPoint> points_;
  std::vector<Triangle> triangles_;
  std::vector<std::uint8_t> fixed_;         // of each triangle, a bit for each side
  std::vector<std::uint32_t> triangle_of_;  // of each vertex, some triangle that has it
  std::vector<std::uint32_t> waiting_;      // triangles whose side opposite the new vertex is yet to be looked at
  std::uint32_t last_ = 0;                  // triangle from which the next search starts
  std::uint32_t dice_ = 0x9E3779B9U;        // turns searches, so that none runs in a circle
};

}  // namespace talus
