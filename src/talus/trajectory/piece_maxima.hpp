#pragma once
// Maximum velocity, energy and height over a part of one piece of a path. The maxima of a run, its envelopes and its
// maps all come from here, so that they agree.
//
// Heights are those of the rock's place straight above the ground below it: in flight, and also of a sphere on the
// ground; of a lumped mass on the ground it is 0. The bounce height is lowest_point() of the maximum
// (rocks/heights.hpp); a rock with a shape is taken as the sphere of the same volume here, and its run keeps the height
// of its lowest corner instead. Heights are exact along a flight. A leg on the ground is taken as straight, which it is
// unless a sphere curves on a facet; then its ends are exact, and the ground below its chord is the same plane.
//
// Checked by test/trajectory/piece_maxima_test.cpp.

#include <algorithm>
#include <optional>
#include <span>

#include "talus/rocks/energy.hpp"
#include "talus/terrain/contact.hpp"
#include "talus/trajectory/rock_log.hpp"

namespace talus {

struct MaxMotion {
  double squared_velocity;      // [m2/s2]
  double energy_translational;  // [J]
  double energy_total;          // translational and rotational [J]
};

/// Over the piece's parameter from `from` to `to`. Velocity and spin are linear in it, so that speed and energies are
/// convex, with their maximum at an end. A glide must be passed step by step.
[[nodiscard]] inline MaxMotion max_motion(const PathPiece& piece, const Rock& rock, double from, double to) {
  const double start = piece.velocity(from).squared_norm(), end = piece.velocity(to).squared_norm();
  const double largest = std::max(start, end), half_mass = 0.5 * rock.mass;
  if (!piece.on_ground) {
    return {largest, half_mass * largest, half_mass * largest + rotational_energy(rock, piece.spin)};
  }
  return {largest, half_mass * largest,
          std::max(half_mass * start + rotational_energy(rock, piece.spin_at(from)),
                   half_mass * end + rotational_energy(rock, piece.spin_at(to)))};
}

/// The maximum height [m] of a flight, its parameter from `from` to `to`, or `known` if that is larger.
template <class Surface>
[[nodiscard]] double max_height_of_flight(const Surface& surface, const Parabola& path, double from, double to,
                                          double known) {
  if (from == 0) return surface.max_height(path, to, known);
  return surface.max_height({path.at(from), path.velocity(from), path.a}, to - from, known);
}

/// The vertical height of a place over a facet [m]; nullopt if it is not over the facet on plan, or the facet does not
/// face up.
[[nodiscard]] inline std::optional<double> height_over(const Outline& facet, const Vec3& place) {
  if (!(facet.normal.z() > 0)) return std::nullopt;
  const double height = facet.normal.dot(place - facet.point) / facet.normal.z();
  const Vec3 below = place - height * unit_z;
  for (std::size_t k = 0; k < static_cast<std::size_t>(facet.edge_count); ++k) {
    if (!((below - facet.edges[k].point).dot(facet.edges[k].inward) >= 0)) return std::nullopt;
  }
  return height;
}

/// The maximum height of a sphere's centre on a leg of `duration`. `facet`: one that may be below it. Facets are
/// convex: if no ground overhangs and a straight path is over a facet at both ends, it is over that facet all the way,
/// and highest at an end.
template <class Surface>
[[nodiscard]] double max_height_of_leg(const Surface& surface, const Outline& facet, const Parabola& leg,
                                       double duration, double from, double to, double known) {
  const Vec3 chord = leg.at(duration) - leg.p;
  const double squared_length = chord.squared_norm();
  const auto share = [&](double s) {
    return squared_length > 0 ? std::clamp((leg.at(s) - leg.p).dot(chord) / squared_length, 0.0, 1.0) : 0.0;
  };
  const double first = share(from), last = std::max(first, share(to));
  const Vec3 start = leg.p + first * chord;
  if (!surface.may_overhang()) {
    const auto at_start = height_over(facet, start), at_end = height_over(facet, leg.p + last * chord);
    if (at_start && at_end) return std::max({known, *at_start, *at_end});
  }
  return surface.max_height({start, chord, Vec3{}}, last - first, known);
}

/// The maximum height on any piece except a glide.
template <class Surface>
[[nodiscard]] double max_height(const Surface& surface, const PathPiece& piece, bool is_sphere, double from, double to,
                                double known) {
  if (!piece.on_ground) return max_height_of_flight(surface, piece.path, from, to, known);
  if (!is_sphere) return known;
  return max_height_of_leg(surface, surface.outline(piece.facet), piece.path, piece.duration, from, to, known);
}

/// The maximum height in each part of a piece between two of `borders`, which are values of its parameter in
/// ascending order; at least 0.
template <class Surface>
void max_heights(const Surface& surface, const PathPiece& piece, bool is_sphere, std::span<const double> borders,
                 std::span<double> heights) {
  // A surface that is searched by walking along it is walked once for all parts.
  if constexpr (requires { surface.max_heights(piece.path, borders, heights); }) {
    if (!piece.on_ground) return surface.max_heights(piece.path, borders, heights);
  }
  for (std::size_t k = 0; k < heights.size(); ++k)
    heights[k] = max_height(surface, piece, is_sphere, borders[k], borders[k + 1], 0);
}

}  // namespace talus
