#pragma once
// The queries on a terrain, common to a section (profile.hpp), a triangulated surface (triangle_mesh.hpp) and a raster
// (raster_surface.hpp). All coordinates are local (local_frame.hpp). A radius of 0 means a point.

#include <concepts>
#include <cstdint>
#include <optional>

#include "talus/terrain/contact.hpp"

namespace talus {

template <class Ground>
concept TerrainSurface = requires(const Ground& ground, const Parabola& path, double number, FacetId facet,
                                  const SupportPlanes& planes, const Vec3& place,
                                  void (*touch)(const Vec3& normal, const Vec3& middle, double distance, FacetId)) {
  /// first_contact(path, radius, t_max, left): the first contact in [0, t_max] of a sphere in flight with ground that
  /// it approaches. `left`: the planes that the rock has just slid off.
  { ground.first_contact(path, number, number, planes) } -> std::same_as<std::optional<Contact>>;
  /// first_contact_on_leg(leg, radius, t_max, on): the same for a rock that rolls on the planes `on`, along a short leg
  /// with any acceleration.
  { ground.first_contact_on_leg(path, number, number, planes) } -> std::same_as<std::optional<Contact>>;
  /// exit(path): where a flight without contact leaves the model.
  { ground.exit(path) } -> std::same_as<Exit>;

  /// max_height(path, t_end, known): the maximum height [m] of a flight over the ground below it in [0, t_end], or
  /// `known` if that is larger.
  { ground.max_height(path, number, number) } -> std::same_as<double>;
  /// elevation(x, y, below): the highest ground at a place on plan that is not above `below`.
  { ground.elevation(number, number, number) } -> std::same_as<std::optional<double>>;
  /// The highest ground straight below a place, or at it.
  { ground.ground_below(place) } -> std::same_as<std::optional<GroundBelow>>;
  /// has_ground_below(place, near): whether there is ground straight below a place, or at it; `near`: a facet nearby.
  { ground.has_ground_below(place, facet) } -> std::same_as<bool>;
  /// The elevation of the surface straight above a place in the ground; nullopt for a place in the open, also under an
  /// overhang: the nearest facet above it does not face up.
  { ground.ground_over(place) } -> std::same_as<std::optional<double>>;
  /// Whether there may be ground above ground somewhere.
  { ground.may_overhang() } -> std::same_as<bool>;

  { ground.facet_count() } -> std::same_as<std::size_t>;
  /// The number by which a facet is assigned its material: that of the segment, triangle or cell that it was made from.
  { ground.source(facet) } -> std::same_as<std::uint32_t>;
  /// The unit normal, out of the ground.
  { ground.normal(facet) } -> std::convertible_to<Vec3>;
  /// A point of a facet.
  { ground.point_of(facet) } -> std::convertible_to<Vec3>;
  { ground.outline(facet) } -> std::same_as<Outline>;
  /// supports(centre, radius, reach, touch): calls touch for each facet within radius + reach of a centre, against
  /// which a rock there may rest.
  { ground.supports(place, number, number, touch) } -> std::same_as<void>;
};

}  // namespace talus
