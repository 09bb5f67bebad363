#pragma once
// What a surface answers: a contact, the end of the model, the outline of a facet.

#include <array>
#include <optional>

#include "talus/core/id.hpp"
#include "talus/core/vec.hpp"

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

/// Two facets whose normals have a greater cosine than 1 minus this are one plane (1.4e-6 rad apart): so far from each
/// other that rounding cannot confuse it, so near that no rock could tell.
inline constexpr double same_plane = 1e-12;

/// Planes that a rock has just slid off, or rolls on: it falls beneath such a plane at once, or stays on it, so that
/// whatever lies in it is not ahead.
struct LeftPlanes {
  std::array<Vec3, 2> normal;
  int count = 0;

  LeftPlanes() = default;
  explicit LeftPlanes(const Vec3& n) : normal{n, n}, count(1) {}
  LeftPlanes(const Vec3& first, const Vec3& second) : normal{first, second}, count(2) {}
  [[nodiscard]] bool contain(const Vec3& n, double tolerance) const {
    for (int i = 0; i < count; ++i) {
      if (n.dot(normal[static_cast<std::size_t>(i)]) > 1 - tolerance) return true;
    }
    return false;
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
