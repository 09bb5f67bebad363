#pragma once
// A slope in section: a polyline in the x-z plane with the ground on its right. Its facets are its segments, extruded
// without end along y, so that a rock in the plane moves as on the extruded slope.

#include <optional>
#include <span>
#include <vector>

#include "talus/rocks/ridge.hpp"
#include "talus/terrain/bvh.hpp"
#include "talus/terrain/contact.hpp"

namespace talus {

struct OverPlane;

class Profile {
 public:
  Profile() = default;
  /// Vertices (x, z), in the order in which the ground is on the right: from left to right for an ordinary slope.
  explicit Profile(std::span<const Vec2> vertices);

  /// Replaces the vertices by as many others, without allocation: for a slope whose vertices vary from rock to rock.
  void move_vertices(std::span<const Vec2> vertices);

  [[nodiscard]] std::size_t facet_count() const { return segments_.size(); }
  [[nodiscard]] const Box& bounds() const { return bounds_; }
  [[nodiscard]] bool may_overhang() const { return !is_height_field_; }
  [[nodiscard]] std::uint32_t source(FacetId facet) const { return facet.index; }

  // The queries of TerrainSurface (surface.hpp). A sphere is a disc in the plane y = 0, with the same contacts.
  [[nodiscard]] std::optional<Contact> first_contact(const Parabola& path, double radius, double t_max,
                                                     const SupportPlanes& left = {}) const;
  [[nodiscard]] std::optional<Contact> first_contact_on_leg(const Parabola& leg, double radius, double t_max,
                                                            const SupportPlanes& on) const;
  [[nodiscard]] Exit exit(const Parabola& path) const;
  [[nodiscard]] double max_height(const Parabola& path, double t_end, double known) const;
  [[nodiscard]] std::optional<double> elevation(double x, double y = 0,
                                                double below = std::numeric_limits<double>::infinity()) const;
  [[nodiscard]] bool has_ground_below(const Vec3& place, FacetId near) const;
  [[nodiscard]] std::optional<GroundBelow> ground_below(const Vec3& place) const;
  [[nodiscard]] std::optional<double> ground_over(const Vec3& place) const;

  [[nodiscard]] Vec3 normal(FacetId facet) const { return segments_[facet.index].normal; }
  [[nodiscard]] const Vec3& point_of(FacetId facet) const { return segments_[facet.index].a; }
  [[nodiscard]] Outline outline(FacetId facet) const;

  template <class Touch>
  void supports(const Vec3& centre, double radius, double reach, Touch&& touch) const;

  // Convex vertices, as the ridges of RasterSurface: a segment's first end is its side 0, the other its side 1.
  [[nodiscard]] Ridge ridge(FacetId facet, std::uint32_t side) const {
    const Segment& segment = segments_[facet.index];
    const Vec3 end = side == 0 ? segment.a : segment.a + segment.length * segment.along;
    return {end, end, facet, side};
  }
  [[nodiscard]] std::array<Vec3, 2> beside(const Ridge& ridge) const {
    const Segment& segment = segments_[ridge.facet.index];
    if (ridge.side == 1) return {segment.a, segment.a};
    const Vec3 after = segment.a + segment.length * segment.along;
    return {ridge.facet.index > 0 ? segments_[ridge.facet.index - 1].a : after, after};
  }
  template <class Visit>
  void visit_ridges(const Vec3& low, const Vec3& high, double min_bend, Visit&& visit) const;

 private:
  struct Segment {
    Vec3 a;                    // its first end, y = 0
    Vec3 along;                // unit, towards its other end
    Vec3 normal;               // unit, out of the ground
    double length = 0;         // [m]
    bool sharp_start = false;  // a disc can touch its first end before a segment: the slope is convex there, or begins
    bool sharp_end = false;    // only ever true of the last segment
  };
  struct Candidate;
  [[nodiscard]] std::uint32_t index_of(const Segment& s) const {
    return static_cast<std::uint32_t>(&s - segments_.data());
  }
  /// A flight over a segment that faces up; nullopt if it is not over it in [0, t_end].
  [[nodiscard]] static std::optional<OverPlane> over_segment(const Segment& segment, const Parabola& path,
                                                             double t_end);
  template <class Visit>
  void visit_column(double x, Visit&& visit) const;
  template <class Visit>
  void visit_near(const Parabola& path, double pad, double& t_max, Visit&& visit) const;
  enum class Path { flight, leg };
  void meet(const Parabola& path, Path kind, double radius, std::uint32_t k, const SupportPlanes& left,
            Candidate& best) const;

  std::vector<Segment> segments_;
  Bvh bvh_;  // only for long profiles that fold back in x
  Box bounds_;
  bool is_height_field_ = true;
};

template <class Touch>
void Profile::supports(const Vec3& centre, double radius, double reach, Touch&& touch) const {
  for (const Segment& segment : segments_) {
    const double s = std::clamp((centre - segment.a).dot(segment.along), 0.0, segment.length);
    Vec3 away = centre - (segment.a + s * segment.along);
    away.y() = 0;
    const double distance = away.norm();
    if (distance > radius + reach) continue;
    touch(distance > tolerance::no_distance ? away / distance : segment.normal,
          Vec3(segment.a + 0.5 * segment.length * segment.along), distance, FacetId{index_of(segment)});
  }
}

template <class Visit>
void Profile::visit_ridges(const Vec3& low, const Vec3& high, double min_bend, Visit&& visit) const {
  const auto look_at = [&](const Vec3& vertex, std::uint32_t segment, std::uint32_t side) {
    if (vertex.x() < low.x() || vertex.x() > high.x() || vertex.z() < low.z() || vertex.z() > high.z()) return;
    visit(Ridge{vertex, vertex, FacetId{segment}, side});
  };
  const auto count = static_cast<std::uint32_t>(segments_.size());
  std::uint32_t k = 0;
  if (is_height_field_) {
    k = static_cast<std::uint32_t>(
        std::partition_point(segments_.begin(), segments_.end(), [&](const Segment& s) { return s.a.x() < low.x(); }) -
        segments_.begin());
  }
  for (; k < count; ++k) {
    const Segment& segment = segments_[k];
    if (is_height_field_ && segment.a.x() > high.x()) return;
    if (segment.sharp_start && (k == 0 || segments_[k - 1].normal.dot(segment.along) < -min_bend)) {
      look_at(segment.a, k, 0);
    }
  }
  if (count > 0 && segments_.back().sharp_end) look_at(ridge({count - 1}, 1).from, count - 1, 1);
}

}  // namespace talus
