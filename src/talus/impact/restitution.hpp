#pragma once
// The input and the result of an impact law, and the scaling of the normal restitution.

#include <optional>

#include "talus/impact/contact_set.hpp"
#include "talus/rocks/rock.hpp"

namespace talus {

/// Coefficients of restitution at one impact, each in [0, 1].
struct Restitution {
  double normal = 0;
  double tangential = 0;
};

/// A rock's motion before an impact.
struct Approach {
  const Vec3& velocity;  // [m/s]
  const Vec3& spin;      // [rad/s]
  const ContactSet& contacts;
  const Rock& rock;

  /// Of the only contact of a point or a sphere.
  [[nodiscard]] const Vec3& normal() const { return contacts[0].normal; }
};

/// A rock's motion after an impact.
struct Rebound {
  Vec3 velocity;  // [m/s]
  Vec3 spin;      // [rad/s]
};

/// Rn decreases with the impact's normal speed and with the rock's mass; each only if its scale is given.
///  - by velocity: Rn / (1 + (|vn| / scale)^2); Pfeiffer and Bowen 1989, scale 9.144 m/s (30 ft/s);
///  - by mass: Rn / (1 + (m / scale)^2), the same form in the rock's mass, as in RocFall.
struct RestitutionScaling {
  std::optional<double> normal_speed;  // [m/s]
  std::optional<double> mass;          // [kg]

  [[nodiscard]] double scaled(double rn, double vn, double rock_mass) const {
    const auto fading = [](double x) { return 1 / (1 + x * x); };
    if (normal_speed) rn *= fading(vn / *normal_speed);
    if (mass) rn *= fading(rock_mass / *mass);
    return rn;
  }
};

}  // namespace talus
