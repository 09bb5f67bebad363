#pragma once
// A rock that moves along the ground rounds a bend of it: the next facet is met at a small angle, because a curved
// surface is made of facets, or because the rock has hopped over an edge.
//
// The bend stands for curved ground, on which the speed v would only be lost to friction of the normal force that turns
// the rock, m v dtheta/dt: dv = -mu v dtheta, so that v' = v exp(-mu theta), whatever the radius (the equation of the
// capstan, without weight: any text on mechanics). n bends of theta/n take as much as one of theta. The weight acts
// along the facets, between the bends; so a slide over a polygon tends to the slide on the smooth curve, with the
// normal acceleration g cos a + v^2/R. A sphere has the same impulse, and the friction and rolling resistance of its
// own motion along the ground (rolling.hpp).
//
// Left out: rebound, roughness and the loss of the velocity into the ground, which belong to impacts (impact/). Checked
// by test/sliding/bend_test.cpp and, on arcs of 8 to 512 facets, test/trajectory/bends_test.cpp.

#include <algorithm>
#include <cmath>

#include "talus/sliding/rolling.hpp"

namespace talus {

/// The angle at which a velocity leads into the ground of unit normal `n` [rad]; 0 if it does not.
[[nodiscard]] inline double bend_angle(const Vec3& velocity, const Vec3& n) {
  const double into = -velocity.dot(n) / std::max(velocity.norm(), tolerance::least_speed);
  return std::asin(std::clamp(into, 0.0, 1.0));
}

/// The velocity turned along the ground, at the same speed.
[[nodiscard]] inline Vec3 turned_onto(const Vec3& velocity, const Vec3& n) {
  const Vec3 along = tangential(velocity, n);
  return velocity.norm() / std::max(along.norm(), tolerance::least_speed) * along;
}

/// Velocity and spin after a bend.
struct Turned {
  Vec3 velocity, spin;
};

/// A sphere rounds a bend of this angle [rad]. `velocity`: already turned.
[[nodiscard]] Turned rolled_round_bend(const Vec3& velocity, const Vec3& spin, const Vec3& n, double angle,
                                       const Rock& rock, ContactFriction friction);

}  // namespace talus
