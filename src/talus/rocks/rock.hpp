#pragma once
// A rock in the equations: a mass, and the sphere of the same volume.

#include <cmath>
#include <numbers>

namespace talus {

struct Rock {
  double mass = 0;     // [kg]
  double radius = 0;   // of the equivalent sphere [m]
  double inertia = 0;  // of that sphere about its centre [kg m2]
};

/// 2/5 m r^2, of a sphere about its centre [kg m2].
[[nodiscard]] inline double inertia_of_sphere(double mass, double radius) { return 0.4 * mass * radius * radius; }

/// The sphere with this mass [kg] and density [kg/m3]: r = (3 m / (4 pi rho))^(1/3).
[[nodiscard]] inline Rock sphere_of_mass(double mass, double density) {
  const double radius = std::cbrt(3 * mass / (4 * std::numbers::pi * density));
  return {mass, radius, inertia_of_sphere(mass, radius)};
}

/// The sphere with this diameter [m] and density [kg/m3].
[[nodiscard]] inline Rock sphere_of_diameter(double diameter, double density) {
  const double radius = diameter / 2;
  const double mass = density * 4 / 3 * std::numbers::pi * radius * radius * radius;
  return {mass, radius, inertia_of_sphere(mass, radius)};
}

}  // namespace talus
