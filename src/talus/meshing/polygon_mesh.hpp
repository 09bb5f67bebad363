#pragma once
// Triangulates closed polylines in space.
//
// A polygon is projected along the normal of its best-fit plane (Newell's: the sum of the areas its sides span) and
// cut by a constrained Delaunay triangulation of its corners. The corners keep their places in space, so a polygon that
// is not quite plane bends along the cuts. It may be vertical, overhanging or concave, and have holes.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "talus/meshing/findings.hpp"
#include "talus/meshing/raw_mesh.hpp"

namespace talus {

struct SpacePolygon {
  std::string name;                      // for messages, for example "polylines[2]"
  std::vector<std::vector<Vec3>> rings;  // outer ring, then holes; the first vertex is not repeated; global [m]
};

struct PolygonReport {
  std::size_t polygons = 0;
  std::size_t triangles = 0;
  Findings bent;                   // polygons with a corner further than bent_m from their plane
  double largest_departure_m = 0;  // of a corner from the plane of its polygon

  [[nodiscard]] std::string text() const;
};

/// A polygon with a corner further than this from its plane is reported [m].
inline constexpr double bent_m = 0.01;

/// Each corner of each polygon becomes a vertex of its own; clean() welds those that coincide. Throws BadInput with all
/// polygons that have fewer than three corners or no area, or that cross or touch themselves, and where.
[[nodiscard]] RawMesh triangulated(std::span<const SpacePolygon> polygons, const std::string& source,
                                   PolygonReport& report);

}  // namespace talus
