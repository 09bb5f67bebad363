#pragma once
// What a surface answers: a contact, the end of the model, the outline of a facet.

#include <algorithm>
#include <array>
#include <optional>

#include "talus/core/id.hpp"
#include "talus/core/tolerances.hpp"
#include "talus/core/vec.hpp"
#include "talus/flight/touch.hpp"

namespace talus {

/// Which part of the surface a rock touches. A point touches facets only.
enum class Feature { facet, edge, vertex };

/// The first contact of a rock with the surface.
struct Contact {
  double t = 0;   // on the path asked about [s]
  Vec3 normal;    // unit, out of the ground; at an edge or a vertex from there to the rock's centre
  FacetId facet;  // at an edge or a vertex: one of the facets that meet there
  Feature feature = Feature::facet;
};

/// What carries a rock, or has carried it until now: where a part of its path begins, the rock touches that, and what
/// lies in the same plane, without meeting it.
///
/// On a leg along the ground nothing is ahead that lies in the planes, nor what is touched at the edge or the vertex
/// that carries a sphere.
///
/// In flight it is what the rock has come to the end of. As long as it has not risen from the plane, it cannot meet the
/// facet that it was on. Another facet of the plane it meets if it is over it when it has sunk in a trace, which is
/// `touching_plane`: there the plane goes on.
struct SupportPlanes {
  std::array<Vec3, 2> normal;
  std::array<FacetId, 2> facet;  // that it was on
  int count = 0;
  bool has_facets = false;  // of a flight
  // Of a leg of a sphere on an edge or a vertex: a point that carries it, and the edge's direction, or zero.
  bool has_pivot = false;
  Vec3 pivot = Vec3::Zero(), axis = Vec3::Zero();

  SupportPlanes() = default;
  explicit SupportPlanes(const Vec3& n) : normal{n, n}, count(1) {}
  SupportPlanes(const Vec3& first, const Vec3& second) : normal{first, second}, count(2) {}
  void turn_about(const Vec3& point, const Vec3& edge) {
    has_pivot = true;
    pivot = point;
    axis = edge;
  }
  void add(const Vec3& n, FacetId of) {
    normal[static_cast<std::size_t>(count)] = n;
    facet[static_cast<std::size_t>(count++)] = of;
    has_facets = true;
  }
  [[nodiscard]] bool contain(const Vec3& n, double tolerance) const {
    for (int i = 0; i < count; ++i) {
      if (n.dot(normal[static_cast<std::size_t>(i)]) > 1 - tolerance) return true;
    }
    return false;
  }
  /// Whether a place on the surface is where the sphere is carried.
  [[nodiscard]] bool is_at_pivot(const Vec3& place) const {
    return has_pivot && tangential(place - pivot, axis).squaredNorm() < tolerance::at_pivot * tolerance::at_pivot;
  }
  /// Whether a rock does not meet a facet of unit normal `n` after all, whose plane it falls through, when it is h0 +
  /// vn t
  /// + an t^2/2 high over it. `is_over(t)`: whether it is over the facet at a time.
  template <class IsOver>
  [[nodiscard]] bool let_through(FacetId asked, const Vec3& n, double h0, double vn, double an,
                                 IsOver&& is_over) const {
    if (count == 0 || h0 > tolerance::touching_plane || !contain(n, same_plane)) return false;
    const bool rises = vn > 0 && (an >= 0 || h0 - 0.5 * vn * vn / an > tolerance::touching_plane);
    if (rises) return false;
    if (!has_facets) return true;
    for (int i = 0; i < count; ++i) {
      if (facet[static_cast<std::size_t>(i)] == asked) return true;
    }
    const auto sunk = falling_root(tolerance::touching_plane + std::max(h0, 0.0), vn, an, 0);
    return sunk && !is_over(*sunk);
  }
};

/// Where a path without contact leaves the model.
struct Exit {
  double t = 0;          // when its centre crosses the edge of the terrain [s]
  bool beneath = false;  // it left below the surface: a lost rock
  bool in_hole = false;  // where it left, the terrain has no data; otherwise it ends there
};

/// What lies straight below a place.
struct GroundBelow {
  double z;       // [m]
  FacetId facet;  // one of those there
};

/// One side of a facet: points with (x - point) . inward >= 0 are on the facet's side of it.
struct OutlineEdge {
  Vec3 point;                     // somewhere on the edge
  Vec3 inward;                    // unit, in the facet's plane
  std::optional<FacetId> beyond;  // the facet on the other side; none at the surface's edge
};

/// A facet as a law of sliding needs it: a plane and the lines that bound it.
struct Outline {
  Vec3 point;   // on the facet
  Vec3 normal;  // unit, out of the ground
  std::array<OutlineEdge, 3> edges;
  int edge_count = 0;
};

}  // namespace talus
