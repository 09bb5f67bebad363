#pragma once
// A Delaunay triangulation on plan, with sides that may be fixed. All decisions are exact; nothing is rounded.
//
// Points are inserted one by one (Lawson 1977: a point splits the triangle or side it lies on, then sides are flipped
// until no triangle's circumcircle contains a point). The order keeps successive points close together, yet is random
// enough that no input is slow (Amenta, Choi and Rote 2003, "Incremental constructions con BRIO"; a Hilbert curve
// within each round). Beyond each side of the hull is a triangle with its third corner at infinity, so that a point
// outside is inserted like any other.
//
// Why not a library: Boost.Polygon's Voronoi diagram has exact predicates but merges vertices that are equal to 1e-14,
// so that its triangles would have to be repaired by flips; it takes six times the memory; and breaklines need flips
// and insertions anyway (constrained_triangulation.hpp). A test compares the two. Memory: 2 x 25 + 12 = 62 bytes per
// point, and 24 more while the points are sorted.

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
  /// The corner at infinity of the triangles beyond the hull.
  static constexpr Vertex infinity = 0xffffffffU;

  /// A directed side of a triangle: from corner k to corner k + 1, with the triangle on its left.
  struct Side {
    std::uint32_t triangle = 0;
    std::uint32_t k = 0;
  };

  struct Triangle {
    std::array<Vertex, 3> corner{};            // counter-clockwise; at most one at infinity
    std::array<std::uint32_t, 3> neighbour{};  // across the side from corner k to corner k + 1
  };

  /// Whether the points (three or more) do not all lie on one line.
  [[nodiscard]] static bool span_a_plane(std::span<const GridPoint> points);

  /// Points must be distinct and span a plane. A vertex is the number of its point.
  explicit Triangulation(std::vector<GridPoint> points);

  [[nodiscard]] std::size_t vertex_count() const { return points_.size(); }
  [[nodiscard]] GridPoint point(Vertex v) const { return points_[v]; }
  /// All triangles, including those beyond the hull.
  [[nodiscard]] std::span<const Triangle> triangles() const { return triangles_; }
  /// Whether no corner of a triangle is at infinity.
  [[nodiscard]] bool is_real(std::uint32_t triangle) const;

  [[nodiscard]] Vertex from(Side s) const { return triangles_[s.triangle].corner[s.k]; }
  [[nodiscard]] Vertex to(Side s) const { return triangles_[s.triangle].corner[next(s.k)]; }
  /// The corner opposite.
  [[nodiscard]] Vertex apex(Side s) const { return triangles_[s.triangle].corner[before(s.k)]; }
  /// The same side in the triangle beyond, in the opposite direction.
  [[nodiscard]] Side twin(Side s) const;
  [[nodiscard]] Side next_side(Side s) const { return {s.triangle, next(s.k)}; }
  /// Some side that begins at a vertex; next_around gives the next one around it, counter-clockwise.
  [[nodiscard]] Side side_from(Vertex v) const { return {triangle_of_[v], corner_number(triangle_of_[v], v)}; }
  [[nodiscard]] Side next_around(Side s) const { return twin({s.triangle, before(s.k)}); }
  /// The side from a to b, if there is one.
  [[nodiscard]] std::optional<Side> side(Vertex a, Vertex b) const;

  [[nodiscard]] bool is_fixed(Side s) const { return (fixed_[s.triangle] >> s.k & 1U) != 0; }
  /// A fixed side is never flipped.
  void fix(Side s, bool fixed = true);

  /// Whether the side is not Delaunay: the circumcircle of one of its triangles contains the other's far corner.
  [[nodiscard]] bool needs_flip(Side s) const;
  /// Whether the side's two triangles form a strictly convex quadrilateral.
  [[nodiscard]] bool can_flip(Side s) const;
  /// Replaces a side by the other diagonal of its two triangles' quadrilateral, which must be strictly convex.
  void flip(Side s);
  /// Flips these sides, and then those around them, until each is Delaunay or fixed.
  void flip_until_delaunay(std::vector<std::array<Vertex, 2>> sides);

  struct Inserted {
    Vertex vertex = 0;
    bool is_new = true;
    std::optional<std::array<Vertex, 2>> on_fixed;  // the fixed side that was split into two fixed ones
  };
  /// Inserts a point, unless there is a vertex at its place already.
  Inserted insert(GridPoint p);

 private:
  static constexpr std::uint32_t next(std::uint32_t k) { return k == 2 ? 0 : k + 1; }
  static constexpr std::uint32_t before(std::uint32_t k) { return k == 0 ? 2 : k - 1; }

  struct Located {
    std::uint32_t triangle = 0;
    std::uint32_t on_sides = 0;  // a bit for each side that the point is on; two at a corner
  };

  [[nodiscard]] std::uint32_t corner_number(std::uint32_t triangle, Vertex v) const;
  void begin(Vertex a, Vertex b, Vertex c);
  [[nodiscard]] Located locate(GridPoint p);
  Inserted insert_vertex(Vertex v);
  void split_triangle(std::uint32_t t, Vertex v);
  void split_side(Side s, Vertex v);
  void flip_around(Vertex v);
  /// Sets a triangle; `fixed` has a bit for each fixed side.
  void set(std::uint32_t t, const std::array<Vertex, 3>& corner, const std::array<std::uint32_t, 3>& neighbour,
           std::uint32_t fixed);
  void replace_neighbour(std::uint32_t of, std::uint32_t old, std::uint32_t now, Vertex from);

  std::vector<GridPoint> points_;
  std::vector<Triangle> triangles_;
  std::vector<std::uint8_t> fixed_;         // per triangle, a bit for each side
  std::vector<std::uint32_t> triangle_of_;  // per vertex, some triangle with that corner
  std::vector<std::uint32_t> waiting_;      // triangles whose side opposite the new vertex is still to be checked
  std::uint32_t last_ = 0;                  // triangle from which the next search starts
  std::uint32_t random_ = 0x9E3779B9U;      // state of the xorshift generator for searches (see locate)
};

}  // namespace talus
