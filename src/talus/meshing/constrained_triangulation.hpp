#pragma once
// Lines brought into a triangulation, so that its sides run along them: a constrained Delaunay triangulation, and the
// heights of its vertices.
//
// A segment is put in by flipping the sides that cross it (Sloan 1993, "A fast algorithm for generating constrained
// Delaunay triangulations", Computers and Structures 47), then what was flipped is flipped on until it is Delaunay
// again wherever no segment is in the way. What meets a segment on its way is settled first:
// - a vertex that lies on it but for rounding (is_on_way) cuts it in two; the vertex keeps its own height;
// - where two segments cross there will be a vertex, at the grid point next to the crossing, so that both bend by at
//   most half a step of the grid. Its height is the mean of theirs;
// - segments that lie upon each other share their sides: what is bent at crossings draws to it what runs along it
//   (iterated snap rounding: Halperin and Packer 2002, Computational Geometry 23), so that a line drawn twice has as
//   many crossings as one.

#include <cstddef>
#include <vector>

#include "talus/meshing/findings.hpp"
#include "talus/meshing/triangulation.hpp"

namespace talus {

/// Heights that differ by less are the same [m].
inline constexpr double same_height_m = 0.001;

struct ConstraintReport {
  std::size_t segments = 0;        // that were put in
  std::size_t without_length = 0;  // left out: both ends at one place on plan
  std::size_t upon_another = 0;    // pieces that lie upon a piece that was there before
  Findings crossings;              // of two segments
  Findings crossings_at_odds;      // of them, where the two have different heights
  double greatest_odds_m = 0;      // of those
  Findings vertices_beside;        // on the way of a segment that is at another height there; they keep theirs
  double greatest_beside_m = 0;    // of those
};

class ConstrainedTriangulation {
 public:
  using Vertex = Triangulation::Vertex;

  /// `heights` [m] has one for each vertex and gets those of new vertices. `grid` only tells where things are.
  ConstrainedTriangulation(Triangulation& triangulation, std::vector<double>& heights, const ExactGrid& grid)
      : triangulation_(triangulation), heights_(heights), grid_(grid) {}

  /// Joins two vertices by fixed sides.
  void add(Vertex a, Vertex b);

  [[nodiscard]] const ConstraintReport& report() const { return report_; }

 private:
  struct Segment {
    Vertex a = 0, b = 0;
    double z_a = 0, z_b = 0;  // of the line there, which need not be those of the vertices
  };

  /// What a segment meets first on its way.
  struct Meeting {
    Vertex reached = 0;                          // its end or a vertex on the way, where nothing fixed is before it
    std::optional<Segment> blocked;              // else the first fixed side
    std::vector<std::array<Vertex, 2>> crossed;  // the sides to be flipped until there
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
