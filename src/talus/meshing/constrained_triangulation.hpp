#pragma once
// Inserts lines into a triangulation so that its sides run along them: a constrained Delaunay triangulation, with the
// heights of its vertices.
//
// A segment is inserted by flipping the sides that cross it (Sloan 1993, "A fast algorithm for generating constrained
// Delaunay triangulations", Computers and Structures 47); the flipped sides are then flipped again until the
// triangulation is Delaunay wherever no segment prevents it. Obstacles along a segment are resolved first:
// - a vertex on the segment, within rounding (is_on_way), splits it in two and keeps its own height;
// - two crossing segments get a vertex at the grid point next to the crossing, so that both bend by at most half a
//   grid step. Its height is the mean of theirs;
// - overlapping segments share their sides: a segment bent at a crossing attracts those that run along it (iterated
//   snap rounding: Halperin and Packer 2002, Computational Geometry 23), so that a line drawn twice has as many
//   crossings as one.

#include <cstddef>
#include <vector>

#include "talus/meshing/findings.hpp"
#include "talus/meshing/triangulation.hpp"

namespace talus {

/// Heights that differ by less are equal [m].
inline constexpr double same_height_m = 0.001;

struct ConstraintReport {
  std::size_t segments = 0;                // inserted
  std::size_t zero_length = 0;             // left out: both ends at one place on plan
  std::size_t overlapping = 0;             // pieces that coincide with an earlier one
  Findings crossings;                      // of two segments
  Findings crossings_at_odds;              // crossings of segments at different heights
  double largest_difference_m = 0;         // between the heights at such a crossing
  Findings vertices_at_odds;               // vertices on a segment at another height; they keep their own
  double largest_vertex_difference_m = 0;  // between such a vertex and the segment
};

class ConstrainedTriangulation {
 public:
  using Vertex = Triangulation::Vertex;

  /// `heights` [m] holds one entry for each vertex; those of new vertices are appended. `grid` gives the places in
  /// metres for the report.
  ConstrainedTriangulation(Triangulation& triangulation, std::vector<double>& heights, const ExactGrid& grid)
      : triangulation_(triangulation), heights_(heights), grid_(grid) {}

  /// Joins two vertices by fixed sides.
  void add(Vertex a, Vertex b);

  [[nodiscard]] const ConstraintReport& report() const { return report_; }

 private:
  struct Segment {
    Vertex a = 0, b = 0;
    double z_a = 0, z_b = 0;  // heights of the line, which may differ from those of the vertices
  };

  /// The first obstacle along a segment, or its end.
  struct Meeting {
    Vertex reached = 0;                          // the end or a vertex on the way, unless a fixed side comes first
    std::optional<Segment> blocked;              // the fixed side that comes first, if any
    std::vector<std::array<Vertex, 2>> crossed;  // sides to flip on the way there
  };

  [[nodiscard]] Segment between(Vertex a, Vertex b) const { return {a, b, heights_[a], heights_[b]}; }
  [[nodiscard]] Meeting way_of(const Segment& segment) const;
  void lay(const Segment& segment);
  void flip_out_of_the_way(const Segment& segment, std::vector<std::array<Vertex, 2>> crossed);
  void cross(const Segment& segment, const Segment& fixed);
  [[nodiscard]] double height_on(const Segment& segment, GridPoint at) const;
  [[nodiscard]] Vec3 place(Vertex v) const;
  void note_beside(Vertex v, double line_height);

  Triangulation& triangulation_;
  std::vector<double>& heights_;
  const ExactGrid& grid_;
  std::vector<Segment> waiting_;
  ConstraintReport report_;
};

}  // namespace talus
