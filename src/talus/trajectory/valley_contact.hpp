#pragma once
// A rock in a valley can only move along it.

#include "talus/trajectory/moving_rock.hpp"

namespace talus {

/// The plane on which a sphere rolls or slips.
struct RollingPlane {
  Vec3 normal;
  Rock rock;
  ContactFriction friction;
};

/// In a valley a sphere rolls on both sides at once: as on a plane whose normal is the middle of both normals, with the
/// distance of the contacts from the axis as its radius.
template <class Surface>
[[nodiscard]] RollingPlane rolling_plane(const MovingRock<Surface>& rock, const InValley& phase) {
  const Vec3 middle = (phase.on.normal + phase.other.normal).normalized();
  const double share = middle.dot(phase.on.normal);
  Rock narrower = rock.rock;
  narrower.radius *= share;
  return {middle, narrower, {phase.friction.sphere.dynamic, phase.friction.sphere.rolling / share}};
}

/// The part of a sphere's spin that a valley leaves it: about the axis across the valley.
template <class Surface>
[[nodiscard]] Vec3 spin_in_valley(MovingRock<Surface>& rock, const InValley& phase, const Vec3& spin) {
  const Vec3 axis = rolling_plane(rock, phase).normal.cross(rock.valley_of(phase).direction);
  return spin.dot(axis) * axis;
}

/// Keeps the velocity along the valley, and of a sphere's spin what the valley leaves. Slip between the two is left to
/// friction.
template <class Surface>
void keep_along_valley(MovingRock<Surface>& rock, const InValley& phase) {
  Motion& motion = rock.motion;
  const Vec3& along = rock.valley_of(phase).direction;
  motion.velocity = motion.velocity.dot(along) * along;
  if (rock.is_sphere()) motion.spin = spin_in_valley(rock, phase, motion.spin);
}

}  // namespace talus
