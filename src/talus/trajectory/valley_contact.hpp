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
[[nodiscard]] RollingPlane rolling_plane(const MovingRock<Surface>& rock, const InValley& state) {
  const Vec3 middle = (state.on.normal + state.other.normal).normalized();
  const double share = middle.dot(state.on.normal);
  Rock narrower = rock.rock;
  narrower.radius *= share;
  return {middle, narrower, {state.friction.sphere.dynamic, state.friction.sphere.rolling / share}};
}

/// Keeps the velocity along the valley and, of a sphere's spin, the part about the axis across it. Slip
/// between the two is left to friction.
template <class Surface>
void keep_along_valley(MovingRock<Surface>& rock, const InValley& state) {
  const Vec3& e = state.valley.direction;
  Motion& motion = rock.motion;
  motion.velocity = motion.velocity.dot(e) * e;
  if (rock.is_sphere()) {
    const Vec3 axis = rolling_plane(rock, state).normal.cross(e);
    motion.spin = motion.spin.dot(axis) * axis;
  }
}

}  // namespace talus
