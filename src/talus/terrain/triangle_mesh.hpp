#pragma once
// A triangulated surface of any shape, including overhangs and vertical faces. The mesh must be clean and oriented
// (cleaning.hpp). Coordinates are local (local_frame.hpp).

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "talus/core/large_pages.hpp"
#include "talus/rocks/shape.hpp"
#include "talus/terrain/bvh.hpp"
#include "talus/terrain/facet_contact.hpp"

namespace talus {

struct OverPlane;

class TriangleMesh {
 public:
  using Corners = std::array<std::uint32_t, 3>;
  /// No triangle beyond this edge.
  static constexpr std::uint32_t no_neighbour = 0xffffffffU;

  /// `neighbours[i][k]` is the triangle beyond the edge from corner k to corner k+1 of triangle i. Windings are
  /// counter-clockwise seen from outside the ground.
  TriangleMesh(std::span<const Vec3> vertices, std::span<const Corners> triangles, std::span<const Corners> neighbours);

  [[nodiscard]] std::size_t facet_count() const { return facets_.size(); }
  /// Facets are numbered in the order of the tree; this is the triangle's number in the constructor.
  [[nodiscard]] std::uint32_t source(FacetId facet) const { return facets_[facet.index].source; }
  [[nodiscard]] const Box& bounds() const { return bounds_; }
  [[nodiscard]] bool may_overhang() const { return !is_height_field_; }
  /// Memory that grows with the number of triangles.
  [[nodiscard]] std::size_t bytes() const;

  // The queries of TerrainSurface (surface.hpp).
  [[nodiscard]] std::optional<Contact> first_contact(const Parabola& path, double radius, double t_max,
                                                     const SupportPlanes& left = {}) const;
  /// The number of facets that this search tests, for benchmarks.
  [[nodiscard]] std::uint32_t facets_tested(const Parabola& path, double radius, double t_max) const;
  [[nodiscard]] std::optional<Contact> first_contact_on_leg(const Parabola& leg, double radius, double t_max,
                                                            const SupportPlanes& on) const;
  [[nodiscard]] Exit exit(const Parabola& path) const;
  [[nodiscard]] double max_height(const Parabola& path, double t_end, double known) const;
  /// As that of a raster (raster_surface.hpp).
  void max_heights(const Parabola& path, std::span<const double> borders, std::span<double> heights) const;
  [[nodiscard]] std::optional<double> elevation(double x, double y,
                                                double below = std::numeric_limits<double>::infinity()) const;
  [[nodiscard]] bool has_ground_below(const Vec3& place, FacetId near) const;
  [[nodiscard]] std::optional<GroundBelow> ground_below(const Vec3& place) const;
  /// The ratio of heights over any facet that faces up to distances from it, at most.
  [[nodiscard]] double slant() const { return slant_; }
  /// As that of a raster (raster_surface.hpp), of a mesh without overhangs.
  template <class Visit>
  void visit_low_corners(const Posture& body, double bound, Visit&& visit) const;
  [[nodiscard]] std::optional<double> ground_over(const Vec3& place) const;
  /// The highest surface along a straight line on plan: a point at each bend, two at each step; stretches without
  /// ground are missing.
  [[nodiscard]] std::vector<Vec3> draped(const Vec2& from, const Vec2& to) const;

  [[nodiscard]] Vec3 normal(FacetId facet) const;
  [[nodiscard]] const Vec3& point_of(FacetId facet) const { return facets_[facet.index].corner[0]; }
  [[nodiscard]] Outline outline(FacetId facet) const;
  /// Its corners; shared corners of neighbours are equal bit for bit.
  [[nodiscard]] const Triangle& triangle(FacetId facet) const { return facets_[facet.index].corner; }

  template <class Touch>
  void supports(const Vec3& centre, double radius, double reach, Touch&& touch) const;

  // Convex edges, as those of RasterSurface.
  [[nodiscard]] Ridge ridge(FacetId facet, std::uint32_t side) const {
    const Triangle& corner = facets_[facet.index].corner;
    return {corner[side], corner[next_corner[side]], facet, side};
  }
  [[nodiscard]] std::array<Vec3, 2> beside(const Ridge& ridge) const {
    const Facet& facet = facets_[ridge.facet.index];
    const std::uint32_t beyond = facet.neighbour[ridge.side];
    return {far_corner(facet.corner, ridge),
            far_corner(beyond == no_neighbour ? facet.corner : facets_[beyond].corner, ridge)};
  }
  template <class Visit>
  void visit_ridges(const Vec3& low, const Vec3& high, double min_bend, Visit&& visit) const;

 private:
  struct Facet {
    Triangle corner;
    Corners neighbour;     // facets here
    std::uint32_t source;  // triangle of the input
    // Edges (bits 0 to 2) and corners (bits 3 to 5) that a sphere can touch before a facet, because the surface is
    // convex there or ends. Each belongs to one of the facets that share it.
    std::uint32_t sharp;
  };
  [[nodiscard]] auto sharp_of(std::uint32_t k) const {
    return [sharp = facets_[k].sharp](std::size_t what, double) { return (sharp & (1U << what)) != 0; };
  }

  template <class EachFacet>
  std::optional<Contact> search_flight(const Parabola& path, double radius, double t_max, const SupportPlanes& left,
                                       EachFacet&& each_facet) const;
  void find_sharp_features(std::span<const Corners> triangles);
  /// Calls visit(over, facet) for each facet that faces up and is below the path on plan in [0, t_end]; `over` is the
  /// flight over its plane.
  template <class Visit>
  void visit_under(const Parabola& path, double t_end, double slack, Visit&& visit) const;
  /// The same for facets `first` to `last` - 1.
  template <class Visit>
  void visit_under_among(std::uint32_t first, std::uint32_t last, const Parabola& path, double t_end, double slack,
                         Visit&& visit) const;
  /// The maximum height of a flight over one facet in a window of time, while no other ground is between them.
  /// `flight`: the duration of the whole flight [s].
  [[nodiscard]] double max_height_in_sight(const Parabola& path, double flight, const TimeWindow& window,
                                           std::uint32_t facet) const;
  /// The elevation of a facet at a place on plan; `n`: its normal, of any length.
  [[nodiscard]] std::optional<double> height_at(std::uint32_t facet, const Vec3& n, double x, double y) const;
  /// Calls visit(z, n_z, facet) for each facet at a place on plan that is not vertical, between two elevations.
  template <class Visit>
  void visit_column(double x, double y, double z_low, double z_high, Visit&& visit) const;

  std::vector<Facet, LargePages<Facet>> facets_;
  Bvh bvh_;
  Box bounds_;
  bool is_height_field_ = true;
  double slant_ = 1;
};

// Facets near the body are found once for all corners. The ground is not above the highest of their planes: most
// corners are so high above these that the ground below them need not be known.
template <class Visit>
void TriangleMesh::visit_low_corners(const Posture& body, double bound, Visit&& visit) const {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  struct Near {
    std::uint32_t facet;
    Vec3 normal;
    double along_x, along_y, height;  // of its plane, from the body's centre
  };
  constexpr std::size_t most = 16;
  std::array<Near, most> near;
  std::size_t count = 0;
  const double reach = body.reach + box_pad;
  const Vec3 low(body.centre.x() - reach, body.centre.y() - reach, bounds_.low.z() - 1);
  const Vec3 high(body.centre.x() + reach, body.centre.y() + reach, bounds_.high.z() + 1);
  bvh_.visit_box(low, high, [&](std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t k = first; k < last; ++k) {
      const Triangle& corner = facets_[k].corner;
      const Vec3 least = corner[0].min(corner[1]).min(corner[2]), largest = corner[0].max(corner[1]).max(corner[2]);
      if (least.x() > high.x() || largest.x() < low.x() || least.y() > high.y() || largest.y() < low.y()) continue;
      if (count++ >= most) continue;
      const Vec3 n = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
      const double along_x = -n.x() / n.z(), along_y = -n.y() / n.z();
      near[count - 1] = {k, n, along_x, along_y,
                         corner[0].z() - body.centre.z() + along_x * (body.centre.x() - corner[0].x()) +
                             along_y * (body.centre.y() - corner[0].y())};
    }
  });
  const bool are_few = count <= most;
  for (std::size_t i = 0; i < body.corners.size(); ++i) {
    const Vec3 arm = body.arm(i), place = body.centre + arm;
    if (!are_few) {
      const auto ground = elevation(place.x(), place.y());
      bound = visit(i, ground ? place.z() - *ground : infinite);
      continue;
    }
    double highest = -infinite;
    for (std::size_t k = 0; k < count; ++k) {
      highest = std::max(highest, near[k].height + near[k].along_x * arm.x() + near[k].along_y * arm.y());
    }
    if (arm.z() - highest > bound + box_pad) continue;
    double ground = -infinite;
    for (std::size_t k = 0; k < count; ++k) {
      const auto z = height_at(near[k].facet, near[k].normal, place.x(), place.y());
      if (z) ground = std::max(ground, *z);
    }
    bound = visit(i, place.z() - ground);
  }
}

template <class Touch>
void TriangleMesh::supports(const Vec3& centre, double radius, double reach, Touch&& touch) const {
  const double range = radius + reach;
  bvh_.visit_box(centre - Vec3::all(range), centre + Vec3::all(range), [&](std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t k = first; k < last; ++k) {
      const Vec3 away = centre - closest_point(facets_[k].corner, centre);
      const double distance = away.norm();
      if (distance > range) continue;
      const auto& corner = facets_[k].corner;
      touch(distance > tolerance::no_distance ? away / distance : normal({k}),
            Vec3((corner[0] + corner[1] + corner[2]) / 3), distance, FacetId{k});
    }
  });
}

template <class Visit>
void TriangleMesh::visit_ridges(const Vec3& low, const Vec3& high, double min_bend, Visit&& visit) const {
  bvh_.visit_box(low, high, [&](std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t k = first; k < last; ++k) {
      const Facet& facet = facets_[k];
      for (std::uint32_t side = 0; side < 3; ++side) {
        if ((facet.sharp >> side & 1U) == 0) continue;
        const Ridge here = ridge({k}, side);
        if (!reaches_into(here, low, high)) continue;
        const std::uint32_t beyond = facet.neighbour[side];
        if (beyond == no_neighbour || bends_down(facet.corner, here, facets_[beyond].corner, min_bend)) visit(here);
      }
    }
  });
}

}  // namespace talus
