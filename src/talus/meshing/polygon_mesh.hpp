#pragma once
// Closed polylines in space, each made a polygon and cut into triangles.
//
// A polygon is seen along the normal of its best-fit plane (Newell's: the sum of the areas its sides span), cut there
// by a constrained Delaunay triangulation of its corners, and put back into space: its corners stay where they are, so
// that one that is not quite plane is bent along the cuts. It may be vertical or overhang, concave, and have holes.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "talus/meshing/findings.hpp"
#include "talus/meshing/raw_mesh.hpp"

namespace talus {

struct SpacePolygon {
  std::string name;                      // for messages, for example "polylines[2]"
  std::vector<std::vector<Vec3>> rings;  // the outer one, then holes; without the first vertex repeated; global [m]
};

struct PolygonReport {
  std::size_t polygons = 0;
  std::size_t triangles = 0;
  Findings bent;                    // polygons of which a corner lies further than bent_m from their plane
  double greatest_departure_m = 0;  // of a corner from the plane of its polygon

  [[nodiscard]] std::string text() const;
};

/// A polygon whose corners depart from its plane by more is told of [m].
inline constexpr double bent_m = 0.01;

/// Triangles with a corner of their own for each corner of each polygon: clean() makes one of those that lie together.
/// Throws BadInput with all polygons that have fewer than three corners, no area, or that cross or touch themselves,
/// and where.
[[nodiscard]] RawMesh triangulated(std::span<const SpacePolygon> polygons, const std::string& source,
                                   PolygonReport& report);

}  // namespace talus
