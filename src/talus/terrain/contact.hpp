#pragma once
// The results of queries on a surface: a contact, the exit from the model, the outline of a facet.

#include <algorithm>
#include <array>
#include <optional>

#include "talus/core/id.hpp"
#include "talus/core/tolerances.hpp"
#include "talus/core/vec.hpp"
#include "talus/rocks/touch.hpp"

namespace talus {

/// The part of the surface that a rock touches. A point only touches facets.
enum class Feature { facet, edge, vertex };

/// The first contact of a rock with the surface.
struct Contact {
  double t = 0;   // parameter of the path [s]
  Vec3 normal;    // unit, out of the ground; at an edge or a vertex from there to the rock's centre
  FacetId facet;  // at an edge or a vertex: one of the facets that meet there
  Feature feature = Feature::facet;
};

/// The planes that carry a rock, or carried it until now. At the start of a flight or leg the rock touches them, and
/// what lies in the same plane; that is no new contact.
///
/// On a leg along the ground nothing in these planes is a contact, nor anything touched at the edge or the vertex that
/// carries a sphere.
///
/// In flight they are the planes whose end the rock has reached. Until it has risen from a plane, it cannot meet the
/// facet that it was on. It meets another facet of the plane if it is over that facet when it has sunk in by
/// `touching_plane`: the plane continues there.
struct SupportPlanes {
  std::array<Vec3, 2> normal;
  std::array<FacetId, 2> facet;  // the facets that it was on; only in flight
  int count = 0;
  bool has_facets = false;
  // For a sphere on an edge or a vertex: the point that carries it, and the direction of the edge; zero at a vertex.
  bool has_pivot = false;
  Vec3 pivot, axis;

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
  /// Whether a place on the surface is on the edge or vertex that carries the sphere.
  [[nodiscard]] bool is_at_pivot(const Vec3& place) const {
    return has_pivot && tangential(place - pivot, axis).squared_norm() < tolerance::at_pivot * tolerance::at_pivot;
  }
  /// Whether the contact with a facet of unit normal `n` does not count. The rock is h0 + vn t + an t^2/2 above its
  /// plane; `is_over(t)`: whether it is then over the facet.
  template <class IsOver>
  [[nodiscard]] bool excludes(FacetId contact, const Vec3& n, double h0, double vn, double an, IsOver&& is_over) const {
    if (count == 0 || h0 > tolerance::touching_plane || !contain(n, same_plane)) return false;
    const bool rises = vn > 0 && (an >= 0 || h0 - 0.5 * vn * vn / an > tolerance::touching_plane);
    if (rises) return false;
    if (!has_facets) return true;
    for (int i = 0; i < count; ++i) {
      if (facet[static_cast<std::size_t>(i)] == contact) return true;
    }
    const auto sunk = falling_root(tolerance::touching_plane + std::max(h0, 0.0), vn, an, 0);
    return sunk && !is_over(*sunk);
  }
};

/// Where a flight without contact leaves the model.
struct Exit {
  double t = 0;          // when its centre crosses the edge of the terrain [s]
  bool beneath = false;  // it left below the surface: a lost rock
  bool in_hole = false;  // it left over a part without data, not over the edge of the terrain
};

/// The ground straight below a place.
struct GroundBelow {
  double z;       // [m]
  FacetId facet;  // one of the facets there
};

/// One side of a facet: points with (x - point) . inward >= 0 are on the facet's side of it.
struct OutlineEdge {
  Vec3 point;                     // somewhere on the edge
  Vec3 inward;                    // unit, in the facet's plane
  std::optional<FacetId> beyond;  // the facet on the other side; nullopt at the edge of the surface
};

/// A facet for motion along the ground: a plane and the lines that bound it.
struct Outline {
  Vec3 point;   // on the facet
  Vec3 normal;  // unit, out of the ground
  std::array<OutlineEdge, 3> edges;
  int edge_count = 0;
};

}  // namespace talus
