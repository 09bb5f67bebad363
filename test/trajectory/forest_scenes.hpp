#pragma once
// Materials with a forest, and rocks in flight, for tests of drag.

#include "support/scenes.hpp"

namespace talus::testing_tools {

/// A material with a forest of this drag [kg/s] and height [m].
inline Material grown_over(const Soil& soil, double drag, double height) {
  Material material = material_of(soil);
  material.forest_drag = drag;
  material.forest_height = height;
  return material;
}

inline const Vec2 level[] = {{-500, 0}, {500, 0}};

/// A rock of this mass [kg] in flight.
inline Release launched(double mass, const Vec3& from, const Vec3& velocity) {
  Release release;
  release.rock = sphere_of_mass(mass, 2700);
  release.motion.position = from;
  release.motion.velocity = velocity;
  return release;
}

}  // namespace talus::testing_tools
