#pragma once
// The greatest values of a rock over a part of one piece of its path: what a run's own maxima, envelopes and maps are
// made of, so that they agree.
//
// Bounce height is the height of the rock's centre above the ground below it, vertically: in flight, and of a sphere on
// the ground, too. A lumped mass on the ground has none. It is exact along a flight. A leg on the ground is taken as
// straight: it is, but where a sphere curves on a facet; its ends are, and what lies below the chord is the same plane.
//
// Checked by test/trajectory/piece_maxima_test.cpp.

#include <algorithm>
#include <optional>
#include <span>

#include "talus/rocks/rock.hpp"
#include "talus/terrain/contact.hpp"
#include "talus/trajectory/rock_log.hpp"

namespace talus {

struct MaxMotion {
  double squared_velocity;      // [m2/s2]
  double energy_translational;  // [J]
  double energy_total;          // translational and rotational [J]
};

/// Of the piece's parameter from `from` to `to`. Velocity and spin are linear in it, so that all of these are convex
/// and greatest at an end. Not of a glide: of its steps.
[[nodiscard]] inline MaxMotion max_motion(const PathPiece& piece, const Rock& rock, double from, double to) {
  const double start = piece.velocity(from).squaredNorm(), end = piece.velocity(to).squaredNorm();
  const double greatest = std::max(start, end), half_mass = 0.5 * rock.mass, half_inertia = 0.5 * rock.inertia;
  if (!piece.on_ground) {
    return {greatest, half_mass * greatest, half_mass * greatest + half_inertia * piece.spin.squaredNorm()};
  }
  return {greatest, half_mass * greatest,
          std::max(half_mass * start + half_inertia * piece.spin_at(from).squaredNorm(),
                   half_mass * end + half_inertia * piece.spin_at(to).squaredNorm())};
}

/// The greatest bounce height [m] of a flight from `from` to `to` of its parameter, if that is above `known`; else
/// `known`.
template <class Surface>
[[nodiscard]] double max_height_of_flight(const Surface& surface, const Parabola& path, double from, double to,
                                          double known) {
  if (from == 0) return surface.max_height(path, to, known);
  return surface.max_height({path.at(from), path.velocity(from), path.a}, to - from, known);
}

/// How high a place is vertically over a facet [m]; nothing where it is not over it on plan, or the facet does not face
/// up.
[[nodiscard]] inline std::optional<double> height_over(const Outline& facet, const Vec3& place) {
  if (!(facet.normal.z() > 0)) return std::nullopt;
  const double height = facet.normal.dot(place - facet.point) / facet.normal.z();
  const Vec3 below = place - height * Vec3::UnitZ();
  for (std::size_t k = 0; k < static_cast<std::size_t>(facet.edge_count); ++k) {
    if (!((below - facet.edges[k].point).dot(facet.edges[k].inward) >= 0)) return std::nullopt;
  }
  return height;
}

/// The same of a leg of a sphere, which is `duration` long. `facet` is one that may be below it: facets are convex, and
/// where no ground can lie above other ground, what is over one at both ends of a straight way is over nothing else on
/// the way, and highest at an end.
template <class Surface>
[[nodiscard]] double max_height_of_leg(const Surface& surface, const Outline& facet, const Parabola& leg,
                                       double duration, double from, double to, double known) {
  const Vec3 chord = leg.at(duration) - leg.p;
  const double squared_length = chord.squaredNorm();
  const auto share = [&](double s) {
    return squared_length > 0 ? std::clamp((leg.at(s) - leg.p).dot(chord) / squared_length, 0.0, 1.0) : 0.0;
  };
  const double first = share(from), last = std::max(first, share(to));
  const Vec3 start = leg.p + first * chord;
  if (!surface.may_overhang()) {
    const auto height = height_over(facet, start), then = height_over(facet, leg.p + last * chord);
    if (height && then) return std::max({known, *height, *then});
  }
  return surface.max_height({start, chord, Vec3::Zero()}, last - first, known);
}

/// The same of any piece but a glide, of a sphere or of a lumped mass.
template <class Surface>
[[nodiscard]] double max_height(const Surface& surface, const PathPiece& piece, bool is_sphere, double from, double to,
                                double known) {
  if (!piece.on_ground) return max_height_of_flight(surface, piece.path, from, to, known);
  if (!is_sphere) return known;
  return max_height_of_leg(surface, surface.outline(piece.facet), piece.path, piece.duration, from, to, known);
}

/// The same of each part of a piece between two of `borders` of its parameter, which ascend; 0 at the least.
template <class Surface>
void max_heights(const Surface& surface, const PathPiece& piece, bool is_sphere, std::span<const double> borders,
                 std::span<double> heights) {
  // Where the surface is walked along, it is walked along once.
  if constexpr (requires { surface.max_heights(piece.path, borders, heights); }) {
    if (!piece.on_ground) return surface.max_heights(piece.path, borders, heights);
  }
  for (std::size_t k = 0; k < heights.size(); ++k)
    heights[k] = max_height(surface, piece, is_sphere, borders[k], borders[k + 1], 0);
}

}  // namespace talus
