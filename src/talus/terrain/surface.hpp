#pragma once
// What a rock asks of the ground, whatever the ground is stored as: a section (profile.hpp), a triangulated surface
// (triangle_mesh.hpp) or a raster (raster_surface.hpp). All coordinates are local (local_frame.hpp); a radius of 0 is
// that of a point.

#include <concepts>
#include <cstdint>
#include <optional>

#include "talus/terrain/contact.hpp"

namespace talus {

template <class Ground>
concept TerrainSurface = requires(const Ground& ground, const Parabola& path, double number, FacetId facet,
                                  const SupportPlanes& planes, const Vec3& place,
                                  void (*touch)(const Vec3& normal, const Vec3& middle, double distance, FacetId)) {
  /// first_contact(path, radius, t_max, left): the first time in [0, t_max] at which a sphere, flying, touches the
  /// ground while approaching it. `left` are planes that the rock has just slid off.
  { ground.first_contact(path, number, number, planes) } -> std::same_as<std::optional<Contact>>;
  /// first_contact_on_leg(leg, radius, t_max, on): the same for a short leg with any acceleration, of a rock that rolls
  /// on the planes `on`.
  { ground.first_contact_on_leg(path, number, number, planes) } -> std::same_as<std::optional<Contact>>;
  /// exit(path): where a flight that meets nothing leaves the model.
  { ground.exit(path) } -> std::same_as<Exit>;

  /// max_height(path, t_end, known): the greatest height [m] of a flight over the ground below it in [0, t_end],
  /// if that is above `known`; else `known`.
  { ground.max_height(path, number, number) } -> std::same_as<double>;
  /// elevation(x, y, below): the highest point of the ground at a place on plan that is not above `below`.
  { ground.elevation(number, number, number) } -> std::same_as<std::optional<double>>;
  /// The highest point of the ground below a place, or at it.
  { ground.ground_below(place) } -> std::same_as<std::optional<GroundBelow>>;
  /// has_ground_below(place, near): whether some ground lies straight below a place, or at it; `near` is a facet
  /// somewhere near.
  { ground.has_ground_below(place, facet) } -> std::same_as<bool>;
  /// How high the ground stands over a place that is in it: the facet above it, if that faces up. A place in the open,
  /// be it under an overhang, has none.
  { ground.ground_over(place) } -> std::same_as<std::optional<double>>;
  /// Whether anywhere there may be ground above ground.
  { ground.may_overhang() } -> std::same_as<bool>;

  { ground.facet_count() } -> std::same_as<std::size_t>;
  /// The number by which a facet has its material: that of the segment, triangle or cell it was made from.
  { ground.source(facet) } -> std::same_as<std::uint32_t>;
  /// Unit, out of the ground.
  { ground.normal(facet) } -> std::convertible_to<Vec3>;
  /// Some point of a facet.
  { ground.point_of(facet) } -> std::convertible_to<Vec3>;
  { ground.outline(facet) } -> std::same_as<Outline>;
  /// supports(centre, radius, reach, touch): calls touch for each facet within radius + reach of a centre: what a rock
  /// there may rest against.
  { ground.supports(place, number, number, touch) } -> std::same_as<void>;
};

}  // namespace talus
